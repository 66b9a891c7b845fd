package rsal.stage.playercfg;

import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Set;
import rsal.data.Pose2d;
import rsal.device.Navigator.Tolerance;
import rsal.settings.Location;
import rsal.settings.Value;
import rsal.stage.WorldProblems;

/// What Player's options for navigation are of ours: names, and units.
final class Options {
    private static final String START = "init_pose";
    private static final String DESIRED = "weight_desired_dir";
    private static final String CURRENT = "weight_current_dir";
    private static final Set<String> ELSEWHERE = Set.of(
            "distance_epsilon",
            "angle_epsilon",
            "goal_tol",
            "goal_position_tol",
            "goal_angle_tol",
            "enable_gui",
            START);

    private enum Unit {
        NUMBER,
        COUNT,
        LENGTH,
        ANGLE
    }

    /// @param name of a setting of ours; empty when there is none
    private record Own(String name, Unit unit) {
        static Own of(String name) {
            return new Own(name, Unit.NUMBER);
        }

        static Own count(String name) {
            return new Own(name, Unit.COUNT);
        }

        static Own length(String name) {
            return new Own(name, Unit.LENGTH);
        }

        static Own angle(String name) {
            return new Own(name, Unit.ANGLE);
        }
    }

    /// By driver, what the numbers of each option are.
    private static final Map<String, Map<String, List<Own>>> KNOWN = Map.of(
            "amcl",
            Map.of(
                    "pf_min_samples", List.of(Own.count("minParticles")),
                    "pf_max_samples", List.of(Own.count("maxParticles")),
                    "laser_max_beams", List.of(Own.count("beams")),
                    "laser_range_var", List.of(Own.length("hitDeviation")),
                    "update_thresh", List.of(Own.length("updateDistance"), Own.angle("updateAngle")),
                    "init_pose_var",
                            List.of(
                                    Own.length("initialDeviation"),
                                    Own.length(""),
                                    Own.angle("initialAngleDeviation"))),
            "vfh",
            Map.ofEntries(
                    Map.entry("cell_size", List.of(Own.length("cellSize"))),
                    Map.entry("window_diameter", List.of(Own.of("windowDiameter"))),
                    Map.entry("sector_angle", List.of(Own.of("sectorAngle"))),
                    Map.entry("safety_dist_0ms", List.of(Own.length("safetyDist0ms"))),
                    Map.entry("safety_dist_1ms", List.of(Own.length("safetyDist1ms"))),
                    Map.entry("max_speed", List.of(Own.length("maxSpeed"))),
                    Map.entry("max_speed_narrow_opening", List.of(Own.length("maxSpeedNarrowOpening"))),
                    Map.entry("max_speed_wide_opening", List.of(Own.length("maxSpeedWideOpening"))),
                    Map.entry("max_acceleration", List.of(Own.length("maxAcceleration"))),
                    Map.entry("max_turnrate_0ms", List.of(Own.angle("maxTurnRate0ms"))),
                    Map.entry("max_turnrate_1ms", List.of(Own.angle("maxTurnRate1ms"))),
                    Map.entry("min_turn_radius_safety_factor", List.of(Own.of("minTurnRadiusSafetyFactor"))),
                    Map.entry(DESIRED, List.of(Own.of("weightDesiredDir"))),
                    Map.entry(CURRENT, List.of(Own.of("weightCurrentDir"))),
                    Map.entry("escape_speed", List.of(Own.length("escapeSpeed"))),
                    Map.entry("escape_time", List.of(Own.of("escapeTime")))),
            "nd",
            Map.of(
                    "max_speed", List.of(Own.length("maxSpeed"), Own.angle("maxTurnRate")),
                    "avoid_dist", List.of(Own.length("avoidDist")),
                    "safety_dist", List.of(Own.length("safetyDist"))),
            "snd",
            Map.of(
                    "robot_radius", List.of(Own.length("robotRadius")),
                    "min_gap_width", List.of(Own.length("minGapWidth")),
                    "obstacle_avoid_dist", List.of(Own.length("obstacleAvoidDist")),
                    "max_speed", List.of(Own.length("maxSpeed")),
                    "max_turn_rate", List.of(Own.angle("maxTurnRate"))),
            "wavefront",
            Map.of(
                    "safety_dist", List.of(Own.length("wallDistance")),
                    "max_radius", List.of(Own.length("comfortDistance")),
                    "dist_penalty", List.of(Own.of("wallCost")),
                    "replan_min_time", List.of(Own.of("replanPeriod"))));

    /// Options of ours that any controller's navigator has; others belong to the controller.
    static final Set<String> OF_NAVIGATORS =
            Set.of("maxSpeed", "maxTurnRate", "maxAcceleration", "escapeSpeed", "escapeTime");

    private final PlayerConfig config;
    private final WorldProblems findings;

    Options(PlayerConfig config, WorldProblems findings) {
        this.config = config;
        this.findings = findings;
    }

    /// What of a driver's options our own device is set to; warns of each that it has not.
    Value.Mapping settings(Driver driver) {
        Map<String, List<Own>> known = KNOWN.getOrDefault(driver.name(), Map.of());
        var entries = new LinkedHashMap<String, Value>();
        var keys = new LinkedHashMap<String, Location>();
        var omitted = new LinkedHashSet<>(driver.options().keySet());
        omitted.removeAll(ELSEWHERE);
        if (driver.option(START).isPresent() && driver.option("init_pose_var").isEmpty()) { // Player's own
            entries.put("initialDeviation", new Value.Scalar(driver.location(), 1.0));
            entries.put("initialAngleDeviation", new Value.Scalar(driver.location(), 360.0));
            keys.put("initialDeviation", driver.location());
            keys.put("initialAngleDeviation", driver.location());
        }
        boolean weighs =
                driver.option(DESIRED).isPresent() || driver.option(CURRENT).isPresent();
        if (known.containsKey(CURRENT) && weighs) { // Player has no third weight
            entries.put("weightPreviousDir", new Value.Scalar(driver.location(), 0.0));
            keys.put("weightPreviousDir", driver.location());
        }
        known.forEach((name, own) -> driver.option(name).ifPresent(option -> {
            List<Value> values = option.value() instanceof Value.Sequence list ? list.items() : List.of(option.value());
            for (int i = 0; i < Math.min(values.size(), own.size()); i++) {
                if (!own.get(i).name().isEmpty()) {
                    entries.put(
                            own.get(i).name(), inUnits(values.get(i), own.get(i).unit()));
                    keys.put(own.get(i).name(), option.location());
                }
            }
            omitted.remove(name);
        }));
        omitted.stream()
                .filter(name -> KnownDrivers.options(driver.name())
                        .filter(all -> all.contains(name.replaceFirst("\\[.*", "")))
                        .isPresent()) // of those that are no options at all another warning tells
                .map(name -> driver.option(name).orElseThrow())
                .forEach(option -> findings.warn(
                        option.location(),
                        "'%s' has no effect: what does the work of '%s' here has nothing like it."
                                .formatted(WorldProblems.shortened(option.name()), driver.name()),
                        KnownDrivers.insteadOf(driver.name(), option.name())));
        return new Value.Mapping(driver.location(), entries, keys);
    }

    /// What is not a number stays as it is: the one that takes it says what is wrong with it.
    private Value inUnits(Value value, Unit unit) {
        if (!(value instanceof Value.Scalar scalar) || !(scalar.value() instanceof Number number)) {
            return value;
        }
        double written = number.doubleValue();
        return new Value.Scalar(
                value.location(),
                switch (unit) {
                    case NUMBER -> written;
                    case COUNT -> Math.round(written);
                    case LENGTH -> written * config.meters();
                    case ANGLE -> Math.toDegrees(written * config.radians());
                });
    }

    /// Where a driver is told that its robot starts.
    Optional<Pose2d> start(Driver driver) {
        OptionalDouble x = first(driver, 0, START);
        OptionalDouble y = first(driver, 1, START);
        OptionalDouble theta = first(driver, 2, START);
        if (x.isPresent() && y.isPresent() && theta.isPresent()) {
            return Optional.of(new Pose2d(
                    x.getAsDouble() * config.meters(),
                    y.getAsDouble() * config.meters(),
                    theta.getAsDouble() * config.radians()));
        }
        driver.option(START)
                .ifPresent(wrong -> findings.warn(
                        wrong.location(),
                        "'%s' has no effect: it is not a pose.".formatted(START),
                        "Write %s [X Y HEADING].".formatted(START)));
        return Optional.empty();
    }

    /// When a driver takes a goal for reached.
    Tolerance tolerance(Driver driver) {
        OptionalDouble distance = first(driver, 0, "distance_epsilon", "goal_tol", "goal_position_tol");
        OptionalDouble angle = switch (driver.name()) {
            case "nd" -> first(driver, 1, "goal_tol");
            default -> first(driver, 0, "angle_epsilon", "goal_angle_tol");
        };
        return new Tolerance(
                positive(distance, config.meters()).orElse(Tolerance.DEFAULT.distance()),
                positive(angle, config.radians()).orElse(Tolerance.DEFAULT.angle()));
    }

    private static Optional<Double> positive(OptionalDouble value, double unit) {
        return value.isPresent() && value.getAsDouble() > 0
                ? Optional.of(value.getAsDouble() * unit)
                : Optional.empty();
    }

    private static OptionalDouble first(Driver driver, int index, String... names) {
        for (String name : names) {
            Optional<Value> value = driver.option(name).map(Driver.Option::value);
            List<Value> values = value.<List<Value>>map(
                            one -> one instanceof Value.Sequence list ? list.items() : List.of(one))
                    .orElse(List.of());
            if (index < values.size()
                    && values.get(index) instanceof Value.Scalar scalar
                    && scalar.value() instanceof Number number) {
                return OptionalDouble.of(number.doubleValue());
            }
        }
        return OptionalDouble.empty();
    }
}
