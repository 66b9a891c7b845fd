package rsal.environment;

import java.util.List;
import rsal.data.Point2d;
import rsal.robot.Robot;
import rsal.settings.Arguments;
import rsal.settings.Parameter;

/// Where the robot has started, in its base frame, by its localizer. Real robots have it.
public final class HomeObservation implements ObservationType {
    private static final Parameter<Double> MAX =
            Parameter.number("max", 100, 0.1, 10_000, "m", "Greatest coordinate; those beyond count as this one.");

    @Override
    public String key() {
        return "home";
    }

    @Override
    public String description() {
        return "Position of the robot's start in the base frame [m], by its localizer.";
    }

    @Override
    public List<Parameter<?>> parameters() {
        return List.of(MAX);
    }

    @Override
    public LearnerObservation create(Arguments arguments) {
        return new Home(arguments.get(MAX).floatValue());
    }

    private record Home(float max) implements LearnerObservation {
        @Override
        public List<String> fields() {
            return List.of("x of start [m]", "y of start [m]");
        }

        @Override
        public float[] low() {
            return new float[] {-max, -max};
        }

        @Override
        public float[] high() {
            return new float[] {max, max};
        }

        @Override
        public Reader of(Robot robot, Truth world) {
            var start = new OwnStart(OwnPose.localizer(robot, "home"));
            return (to, at) -> {
                Point2d home = start.baseFromStart();
                Bounds.put(home.x(), home.y(), max, to, at);
            };
        }
    }
}
