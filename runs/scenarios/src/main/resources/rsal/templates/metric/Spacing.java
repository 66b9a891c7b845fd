import java.util.Comparator;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import rsal.metric.Metric;
import rsal.metric.MetricType;
import rsal.metric.QuantityType;
import rsal.metric.RobotState;
import rsal.metric.RunState;
import rsal.metric.SignalType;
import rsal.settings.Arguments;
import rsal.settings.Parameter;

/// How far robots are from their nearest neighbors, and how often two of them meet.
public final class Spacing implements MetricType {
    private static final SignalType SPACING =
            SignalType.ofRobots("spacing", "m", "distance of a robot to the nearest other one, after each step");
    private static final QuantityType ENCOUNTERS =
            QuantityType.of("encounters", "", "how often a robot has come near another one so far");
    private static final Parameter<Double> NEAR =
            Parameter.number("near", 1, 0.1, 100, "m", "How near two robots are that meet.");

    @Override
    public String key() {
        return "spacing";
    }

    @Override
    public String description() {
        return "How far robots are from their nearest neighbors, and how often two of them meet.";
    }

    @Override
    public List<Parameter<?>> parameters() {
        return List.of(NEAR);
    }

    @Override
    public List<QuantityType> quantities() {
        return List.of(ENCOUNTERS);
    }

    @Override
    public List<SignalType> signals() {
        return List.of(SPACING);
    }

    @Override
    public Metric create(Arguments arguments, RunState run) {
        return new Neighbors(run, arguments.get(NEAR));
    }

    /// The metric in one run.
    private static final class Neighbors implements Metric {
        private final RunState run;
        private final double near; // m
        private final Set<String> meeting = new HashSet<>(); // robots that are near another one now
        private int encounters;

        Neighbors(RunState run, double near) {
            this.run = run;
            this.near = near;
        }

        @Override
        public void onStep() {
            List<RobotState> robots = run.robots();
            for (RobotState robot : robots) {
                distanceToNearest(robot, robots).ifPresent(distance -> note(robot.id(), distance));
            }
        }

        private static Optional<Double> distanceToNearest(RobotState robot, List<RobotState> robots) {
            return robot.mapFromBase().flatMap(here -> robots.stream()
                    .filter(other -> !other.id().equals(robot.id()))
                    .flatMap(other -> other.mapFromBase().stream())
                    .map(here::distanceTo)
                    .min(Comparator.naturalOrder()));
        }

        private void note(String robot, double distance) {
            run.sample(SPACING, robot, distance);
            if (distance > near) {
                meeting.remove(robot);
            } else if (meeting.add(robot)) {
                encounters++;
            }
        }

        /// There is one quantity, so it is what is asked for.
        @Override
        public double value(String quantity, List<String> names) {
            return encounters;
        }
    }
}
