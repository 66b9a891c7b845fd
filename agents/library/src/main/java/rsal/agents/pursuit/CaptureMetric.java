package rsal.agents.pursuit;

import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import rsal.data.Pose2d;
import rsal.metric.Metric;
import rsal.metric.MetricType;
import rsal.metric.NameKind;
import rsal.metric.QuantityType;
import rsal.metric.RobotState;
import rsal.metric.RunState;
import rsal.metric.SignalType;
import rsal.settings.Arguments;

/// Which prey are caught in truth. A prey says which hunter has caught it, and how far away that is. It counts
/// from when that is true: this hunter, or another robot of its role, is so near, and no wall stands between.
public final class CaptureMetric implements MetricType {
    static final QuantityType CAUGHT = QuantityType.of("caught", "", "robots that have been caught", NameKind.ROLE)
            .countingAll();
    static final SignalType DISTANCE = SignalType.ofRobots(
            "captureDistance", "m", "true distance of a prey and its hunter when its capture counts");

    private static final double RIGHT = 1.0; // m by which a prey may be wrong about the distance
    private static final double SIDE = 0.3; // m from a hunter's middle; who is seen in part is in sight

    @Override
    public String key() {
        return "capture";
    }

    @Override
    public String description() {
        return "Counts the prey that are caught: their agents have reported it, and it was true.";
    }

    @Override
    public List<QuantityType> quantities() {
        return List.of(CAUGHT);
    }

    @Override
    public List<SignalType> signals() {
        return List.of(DISTANCE);
    }

    @Override
    public Metric create(Arguments arguments, RunState run) {
        return new Captures(run);
    }

    /// @param role of the robot that the prey named
    private record Claim(String role, double distance) {}

    private static final class Captures implements Metric {
        private final RunState run;
        private final Map<String, Claim> untrue = new LinkedHashMap<>(); // until now, by prey
        private final Set<String> caught = new HashSet<>(); // prey

        Captures(RunState run) {
            this.run = run;
        }

        @Override
        public void onMessage(String sender, Object content) {
            if (content instanceof Caught said && !caught.contains(said.prey())) {
                run.robot(said.prey()).ifPresent(prey -> heard(said, prey));
            }
        }

        /// It is believed where nobody knows better.
        private void heard(Caught said, RobotState prey) {
            Optional<RobotState> hunter = run.robot(said.hunter());
            Optional<Pose2d> mapFromHunter = hunter.flatMap(RobotState::mapFromBase);
            if (prey.mapFromBase().isEmpty() || mapFromHunter.isEmpty()) {
                caught.add(said.prey());
                return;
            }
            Pose2d mapFromPrey = prey.mapFromBase().get();
            var claim = new Claim(hunter.map(RobotState::role).orElse(""), said.distance());
            double distance = mapFromPrey.distanceTo(mapFromHunter.get());
            if (holds(claim, mapFromPrey, mapFromHunter.get())) {
                count(said.prey(), distance);
            } else if (untrue.put(said.prey(), claim) == null) {
                run.event(
                        "uncaught",
                        said.prey(),
                        "is not caught: '%s' is really %.2f m away%s"
                                .formatted(
                                        said.hunter(),
                                        distance,
                                        isInSight(mapFromPrey, mapFromHunter.get()) ? "" : ", behind a wall"));
            }
        }

        /// Some may be caught now who have said so before.
        @Override
        public void onStep() {
            if (untrue.isEmpty()) {
                return;
            }
            List<RobotState> robots = run.robots();
            Map<String, Double> now = new LinkedHashMap<>(); // from how far [m]
            untrue.forEach((prey, claim) -> robots.stream()
                    .filter(robot -> robot.id().equals(prey))
                    .flatMap(robot -> robot.mapFromBase().stream())
                    .findFirst()
                    .ifPresent(mapFromPrey -> robots.stream()
                            .filter(robot -> robot.role().equals(claim.role)
                                    && !robot.id().equals(prey))
                            .flatMap(hunter -> hunter.mapFromBase().stream())
                            .filter(mapFromHunter -> holds(claim, mapFromPrey, mapFromHunter))
                            .mapToDouble(mapFromPrey::distanceTo)
                            .min()
                            .ifPresent(distance -> now.put(prey, distance))));
            now.forEach((prey, distance) -> {
                run.event("caught", prey, "is really caught now, from %.2f m".formatted(distance));
                count(prey, distance);
            });
        }

        private boolean holds(Claim claim, Pose2d mapFromPrey, Pose2d mapFromHunter) {
            return mapFromPrey.distanceTo(mapFromHunter) <= claim.distance + RIGHT
                    && isInSight(mapFromPrey, mapFromHunter);
        }

        private boolean isInSight(Pose2d mapFromPrey, Pose2d mapFromHunter) {
            return !run.walls().hide(mapFromPrey.position(), mapFromHunter.position(), SIDE);
        }

        private void count(String prey, double distance) {
            untrue.remove(prey);
            caught.add(prey);
            run.sample(DISTANCE, prey, distance);
        }

        @Override
        public double value(String quantity, List<String> names) {
            return caught.stream()
                    .flatMap(prey -> run.robot(prey).stream())
                    .filter(prey -> prey.role().equals(names.getFirst()))
                    .count();
        }
    }
}
