package rsal.navigation.device;

import java.util.HashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import rsal.settings.Parameter;

/// What options of Player's drivers and of ROS 2's navigation (Nav2) are called here, or why there are none.
final class ForeignOptions {
    /// Player's `vfh`, `nd`, `snd` and what of its `wavefront` is the navigator's here; Nav2's controllers and
    /// costmaps.
    static final ForeignOptions OF_NAVIGATORS = navigators();

    /// Player's `wavefront`; Nav2's planners and costmaps.
    static final ForeignOptions OF_PLANNERS = planners();

    /// The two programs that are called `amcl`.
    static final ForeignOptions OF_LOCALIZERS = localizers();

    private final Map<String, String> advice = new HashMap<>();

    private ForeignOptions() {}

    private static ForeignOptions navigators() {
        return new ForeignOptions()
                .and(
                        "It keeps distances, not sums of a certainty grid: 'windowDiameter', 'safetyDist0ms', 'safetyDist1ms' of controller vfh.",
                        "free_space_cutoff_0ms",
                        "free_space_cutoff_1ms",
                        "obs_cutoff_0ms",
                        "obs_cutoff_1ms")
                .and(
                        "Each goal has its own tolerance.",
                        "distance_epsilon",
                        "angle_epsilon",
                        "goal_tol",
                        "goal_position_tol",
                        "goal_angle_tol",
                        "xy_goal_tolerance",
                        "yaw_goal_tolerance")
                .and(
                        "It backs off after 6 s without getting nearer, and gives up after 'patience'.",
                        "rotate_stuck_time",
                        "translate_stuck_time",
                        "translate_stuck_dist",
                        "translate_stuck_angle")
                .and(
                        "Obstacles that the laser does not see any more are remembered.",
                        "laser_buffer",
                        "sonar_buffer",
                        "laser_buffer_size")
                .and("It turns more slowly near the target angle, and needs no minimum turn rate.", "min_turnrate")
                .and("Near obstacles, it drives at a fifth of 'maxSpeed' or faster.", "min_speed", "min_vel_x")
                .and("It turns away at 'maxTurnRate' at most, as in other turns.", "escape_max_turnrate")
                .and("It always backs off after a collision.", "wait_on_stall")
                .and("It is 'controller' here: 'controller: {type: vfh}'.", "local")
                .and("It is 'planner' here: 'planner: {type: wavefront}'.", "global")
                .and("Give the robot other sonars.", "sonar_bad_transducers")
                .and("It runs ten times a second.", "synchronous", "update_rate", "controller_frequency")
                .and("It is 'replanPeriod' here.", "replan_min_time", "expected_planner_frequency")
                .and(
                        "It plans again every 'replanPeriod', and at once when it has left its path.",
                        "replan_dist_thresh")
                .and("It turns in place where that is needed.", "add_rotational_waypoints")
                .and("It is 'safetyDist0ms' of controller vfh here.", "safetyDistance")
                .and("It is 'safetyDist1ms' of controller vfh here.", "safetyDistanceAtSpeed")
                .and(
                        "That of Player's nd is 'safetyDist' of controller nd here, that of its wavefront 'wallDistance'; for vfh see 'safetyDist0ms'.",
                        "safety_dist")
                .and(
                        "Its paths end at the goal, or as near as the goal's tolerance allows; 'goalDistance' is of planners.",
                        "goalDistance")
                .and("It is 'maxSpeed' here.", "max_vel_x", "vx_max", "desired_linear_vel")
                .and("It is 'maxTurnRate' here.", "max_vel_theta", "wz_max")
                .and("It is 'maxAcceleration' here.", "acc_lim_x", "ax_max")
                .andOfMaps();
    }

    private static ForeignOptions planners() {
        return new ForeignOptions()
                .and("It is 'wallDistance' here.", "safety_dist")
                .and("It is 'goalDistance' here.", "tolerance")
                .and("Unknown space counts as a wall.", "allow_unknown")
                .andOfMaps();
    }

    /// What of a map's costs both have.
    private ForeignOptions andOfMaps() {
        return and("It is 'comfortDistance' here.", "max_radius", "inflation_radius")
                .and("It is 'wallCost' here.", "dist_penalty", "cost_scaling_factor");
    }

    private static ForeignOptions localizers() {
        return new ForeignOptions()
                .and("It is 'beams' here.", "max_beams", "laser_max_beams")
                .and("It is 'maxRange' here.", "laser_max_range", "laser_range_max")
                .and("It is 'minParticles' here.", "pf_min_samples")
                .and("It is 'maxParticles' here.", "pf_max_samples")
                .and(
                        "It is 'hitDeviation' here, and 'sonarDeviation' for sonars.",
                        "sigma_hit",
                        "laser_sigma_hit",
                        "laser_range_var")
                .and(
                        "It is 'randomShare' here; all other readings are hits.",
                        "z_rand",
                        "z_hit",
                        "z_short",
                        "z_max",
                        "laser_range_bad")
                .and("It is 'model' here: field or beam.", "laser_model_type")
                .and("It is 'updateDistance' here.", "update_min_d")
                .and("It is 'updateAngle' here.", "update_min_a")
                .and("It is 'updateDistance' and 'updateAngle' here.", "update_thresh")
                .and(
                        "The robot's model says how its wheels err; 'odometryNoiseScale' says how many times worse they may be.",
                        "odom_drift",
                        "alpha1",
                        "alpha2",
                        "alpha3",
                        "alpha4",
                        "alpha5",
                        "odom_alpha1",
                        "odom_alpha2",
                        "odom_alpha3",
                        "odom_alpha4")
                .and("The robot's model says how it drives.", "robot_model_type", "odom_model_type")
                .and(
                        "The robot's 'pose' says where it starts; without one it may be anywhere.",
                        "init_pose",
                        "initial_pose",
                        "set_initial_pose")
                .and("'initialDeviation' and 'initialAngleDeviation' say how uncertain the start is.", "init_pose_var")
                .and(
                        "It looks for the robot elsewhere by itself when scans don't fit any more.",
                        "recovery_alpha_slow",
                        "recovery_alpha_fast")
                .and("It resamples when that is necessary.", "resample_interval");
    }

    private ForeignOptions and(String sentence, String... options) {
        List.of(options).forEach(option -> advice.put(plain(option), sentence));
        return this;
    }

    /// Whether both are the same but for underscores and capitals.
    static boolean isSame(String one, String other) {
        return plain(one).equals(plain(other));
    }

    /// Without underscores and capitals: `min_gap_width` is `minGapWidth` is `mingapwidth`.
    private static String plain(String option) {
        return option.replace("_", "").toLowerCase(Locale.ROOT);
    }

    /// What to say to somebody who sets an option that is not known by this name.
    Optional<String> advice(String option, List<Parameter<?>> parameters) {
        return Optional.ofNullable(advice.get(plain(option)))
                .or(() -> parameters.stream()
                        .map(Parameter::name)
                        .filter(name -> plain(name).equals(plain(option)))
                        .findFirst()
                        .map("It is written '%s' here."::formatted));
    }
}
