package rsal.environment;

import java.util.List;
import rsal.data.Point2d;
import rsal.data.Pose2d;
import rsal.device.Localizer;
import rsal.robot.Robot;
import rsal.settings.Arguments;
import rsal.settings.Parameter;

/// Where a place is, such as a goal, in the robot's base frame: by its true pose, or by its localizer as real robots
/// have it.
public final class PlaceObservation implements ObservationType {
    private static final Parameter<Double> X = Parameter.number(
                    "x", 0, -10_000, 10_000, "m", "x of the place in the map.")
            .required();
    private static final Parameter<Double> Y = Parameter.number(
                    "y", 0, -10_000, 10_000, "m", "y of the place in the map.")
            .required();
    private static final Parameter<String> FROM = Parameter.choice(
            "from",
            "truth",
            List.of("localizer", "truth"),
            "Where the pose of the robot comes from. Real robots have no 'truth'.");
    private static final Parameter<Double> MAX =
            Parameter.number("max", 100, 0.1, 10_000, "m", "Greatest coordinate; those beyond count as this one.");

    @Override
    public String key() {
        return "place";
    }

    @Override
    public String description() {
        return "Position of a place in the base frame [m].";
    }

    @Override
    public List<Parameter<?>> parameters() {
        return List.of(X, Y, FROM, MAX);
    }

    @Override
    public LearnerObservation create(Arguments arguments) {
        return new Place(
                new Point2d(arguments.get(X), arguments.get(Y)),
                arguments.get(FROM).equals("truth"),
                arguments.get(MAX).floatValue());
    }

    private record Place(Point2d mapFromPlace, boolean isTrue, float max) implements LearnerObservation {
        @Override
        public List<String> fields() {
            return List.of("x of place [m]", "y of place [m]");
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
            if (isTrue) {
                int number = world.number(robot.id());
                return (to, at) -> write(world.truth(number), to, at);
            }
            Localizer localizer = OwnPose.localizer(robot, "place");
            return (to, at) -> write(OwnPose.believed(localizer), to, at);
        }

        private void write(Pose2d mapFromBase, float[] to, int at) {
            Point2d baseFromPlace = mapFromBase.inverse().transform(mapFromPlace);
            Bounds.put(baseFromPlace.x(), baseFromPlace.y(), max, to, at);
        }
    }
}
