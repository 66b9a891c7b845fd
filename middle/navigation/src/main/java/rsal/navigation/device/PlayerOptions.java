package rsal.navigation.device;

import java.util.HashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import rsal.settings.Parameter;

/// What the options of Player's `vfh`, `nd`, `snd` and `wavefront` are called here, or why there are none.
final class PlayerOptions {
    private static final String TOLERANCE = "How near is near enough comes with each goal.";
    private static final String DISTANCES =
            "It keeps distances, not sums of a certainty grid: 'windowDiameter', 'safetyDist0ms', 'safetyDist1ms'.";
    private static final String STUCK = "It backs off after 6 s without getting nearer, and gives up after 'patience'.";
    private static final String REMEMBERS = "What came to lie where the laser does not look is remembered by itself.";

    private static final Map<String, String> ADVICE = new HashMap<>();

    static {
        advise(DISTANCES, "free_space_cutoff_0ms", "free_space_cutoff_1ms", "obs_cutoff_0ms", "obs_cutoff_1ms");
        advise(TOLERANCE, "distance_epsilon", "angle_epsilon", "goal_tol", "goal_position_tol", "goal_angle_tol");
        advise(STUCK, "rotate_stuck_time", "translate_stuck_time", "translate_stuck_dist", "translate_stuck_angle");
        advise(REMEMBERS, "laser_buffer", "sonar_buffer", "laser_buffer_size");
        advise("It turns the slower the less is missing, and needs no least turn rate.", "min_turnrate");
        advise("Its laws slow it down to a fifth of 'maxSpeed' at most.", "min_speed");
        advise("It turns away as it turns otherwise, no faster than 'maxTurnRate'.", "escape_max_turnrate");
        advise("It always backs off from what it has run into.", "wait_on_stall");
        advise("Give the robot other sonars.", "sonar_bad_transducers");
        advise("It runs ten times a second.", "synchronous", "update_rate");
        advise("It is 'comfortDistance' here.", "max_radius");
        advise("It is 'wallCost' here.", "dist_penalty");
        advise("It is 'replanPeriod' here.", "replan_min_time");
        advise("It plans anew every 'replanPeriod', and at once when it is off its way.", "replan_dist_thresh");
        advise("It turns by itself where that is needed.", "add_rotational_waypoints");
        advise("It is 'safetyDist0ms' here.", "safetyDistance");
        advise("It is 'safetyDist1ms' here.", "safetyDistanceAtSpeed");
    }

    private PlayerOptions() {}

    private static void advise(String advice, String... options) {
        List.of(options).forEach(option -> ADVICE.put(plain(option), advice));
    }

    /// Without underscores and capitals: `min_gap_width` is `minGapWidth` is `mingapwidth`.
    private static String plain(String option) {
        return option.replace("_", "").toLowerCase(Locale.ROOT);
    }

    /// What to say to somebody who sets an option that is not known by this name.
    static Optional<String> advice(String option, List<Parameter> parameters) {
        return parameters.stream()
                .map(Parameter::name)
                .filter(name -> plain(name).equals(plain(option)))
                .findFirst()
                .map("It is written '%s' here."::formatted)
                .or(() -> Optional.ofNullable(ADVICE.get(plain(option))));
    }
}
