package rsal.stage.playercfg;

import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;

/// Drivers that come with Player, and what can be set of some.
final class KnownDrivers {
    static final String STAGE = "stage";

    private static final String GIVEN = "A scenario gives its robots what does the same ('rsal list drivers').";
    private static final String REAL = "It is for real robots.";

    private static final Map<String, String> OPTIONS = Map.ofEntries(
            Map.entry(STAGE, "worldfile usegui model"),
            Map.entry("mapfile", "filename resolution negate origin"),
            Map.entry("rangertolaser", ""),
            Map.entry("lasertoranger", ""),
            Map.entry("sonartoranger", ""),
            Map.entry(
                    "amcl",
                    "odom_init pf_min_samples pf_max_samples pf_err pf_z init_pose init_pose_var update_thresh odom_drift"
                            + " laser_max_beams laser_range_var laser_range_bad enable_gui"),
            Map.entry(
                    "vfh",
                    "cell_size window_diameter sector_angle safety_dist_0ms safety_dist_1ms max_speed"
                            + " max_speed_narrow_opening max_speed_wide_opening max_acceleration min_turnrate"
                            + " max_turnrate_0ms max_turnrate_1ms min_turn_radius_safety_factor free_space_cutoff_0ms"
                            + " free_space_cutoff_1ms obs_cutoff_0ms obs_cutoff_1ms weight_desired_dir"
                            + " weight_current_dir distance_epsilon angle_epsilon escape_speed escape_time"
                            + " escape_max_turnrate synchronous"),
            Map.entry(
                    "wavefront",
                    "safety_dist max_radius dist_penalty distance_epsilon angle_epsilon replan_dist_thresh"
                            + " replan_min_time add_rotational_waypoints force_map_refresh update_rate request_map"
                            + " velocity_control control_tv control_av control_a laser_buffer_size laser_maxrange"),
            Map.entry(
                    "nd",
                    "goal_tol max_speed min_speed avoid_dist safety_dist rotate_stuck_time translate_stuck_time"
                            + " translate_stuck_dist translate_stuck_angle wait_on_stall laser_buffer sonar_buffer"
                            + " sonar_bad_transducers"),
            Map.entry(
                    "snd",
                    "robot_radius min_gap_width obstacle_avoid_dist max_speed max_turn_rate goal_position_tol"
                            + " goal_angle_tol"),
            Map.entry(
                    "p2os",
                    "port use_tcp tcp_remote_host tcp_remote_port radio bumpstall pulse joystick"
                            + " direct_wheel_vel_control max_xspeed max_yawspeed max_xaccel max_xdecel max_yawaccel"
                            + " max_yawdecel rot_kp rot_kv rot_ki trans_kp trans_kv trans_ki use_vel_band"
                            + " ignore_checksum fov gripper_pose gripper_outersize gripper_innersize"
                            + " armgrip_outersize armgrip_innersize aa_basepos aa_baseorient aa_offsets aa_orients"
                            + " aa_axes limb_pos limb_links limb_offsets"),
            Map.entry("hokuyoaist", HokuyoAist.OPTIONS),
            Map.entry("hokuyo_aist", HokuyoAist.OPTIONS));

    /// What old manuals name, and drivers never read.
    private static final Map<String, String> NEVER_READ = Map.of(
            "amcl laser_pose", "Where the laser is, the driver asks the laser.",
            "amcl laser_range_max", "How far the laser sees, the driver asks the laser.",
            "wavefront cspace_file", "The driver computes that each time.");

    private static final Map<String, String> INSTEAD_OF = Map.of(
            "amcl odom_drift[0]", "How much its odometry drifts, the robot's model says.",
            "amcl odom_drift[1]", "How much its odometry drifts, the robot's model says.",
            "amcl odom_drift[2]", "How much its odometry drifts, the robot's model says.");

    private static final Map<String, String> INSTEAD = Map.ofEntries(
            Map.entry("amcl", GIVEN),
            Map.entry("vfh", GIVEN),
            Map.entry("nd", GIVEN),
            Map.entry("snd", GIVEN),
            Map.entry("wavefront", GIVEN),
            Map.entry("rangertolaser", "Robots have lasers without it."),
            Map.entry("lasertoranger", "Robots have lasers without it."),
            Map.entry("sonartoranger", "Robots have sonars without it."),
            Map.entry("p2os", REAL),
            Map.entry("hokuyoaist", REAL),
            Map.entry("hokuyo_aist", REAL));

    private KnownDrivers() {}

    private static final class HokuyoAist {
        static final String OPTIONS = "portopts pose size min_angle max_angle invert verbose ignoreunknowns"
                + " get_intensities power speed_level high_sensitivity min_dist hw_timestamps";
    }

    static Set<String> names() {
        return new TreeSet<>(OPTIONS.keySet());
    }

    /// Names of what can be set of a driver; empty when nobody knows.
    static Optional<Set<String>> options(String driver) {
        return Optional.ofNullable(OPTIONS.get(driver)).map(names -> new TreeSet<>(Set.of(names.split(" "))));
    }

    /// Why an option that looks right has no effect.
    static Optional<String> whyNeverRead(String driver, String option) {
        return Optional.ofNullable(NEVER_READ.get(driver + " " + option));
    }

    /// What is instead of an option that has no effect.
    static String insteadOf(String driver, String option) {
        return INSTEAD_OF.getOrDefault(driver + " " + option, "");
    }

    /// What a run has instead of a driver.
    static String instead(String driver) {
        return INSTEAD.getOrDefault(driver, "");
    }
}
