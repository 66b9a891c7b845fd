package rsal.environment;

import java.util.List;
import rsal.data.Pose2d;
import rsal.device.Localizer;
import rsal.robot.Robot;
import rsal.settings.Arguments;
import rsal.settings.Parameter;

/// The pose of the robot in the frame `map`: position, and heading as cosine and sine.
public final class PoseObservation implements ObservationType {
    private static final Parameter<String> FROM = Parameter.choice(
            "from",
            "localizer",
            List.of("localizer", "truth"),
            "Where the pose comes from. Real robots have no 'truth'.");
    private static final Parameter<Double> MAX =
            Parameter.number("max", 100, 1, 10_000, "m", "Greatest coordinate; those beyond count as this one.");

    @Override
    public String key() {
        return "pose";
    }

    @Override
    public String description() {
        return "Position in the map [m], cosine and sine of the heading.";
    }

    @Override
    public List<Parameter<?>> parameters() {
        return List.of(FROM, MAX);
    }

    @Override
    public LearnerObservation create(Arguments arguments) {
        return new Pose(arguments.get(FROM).equals("truth"), arguments.get(MAX).floatValue());
    }

    private record Pose(boolean isTrue, float max) implements LearnerObservation {
        @Override
        public List<String> fields() {
            return List.of("x [m]", "y [m]", "cosine of heading", "sine of heading");
        }

        @Override
        public float[] low() {
            return new float[] {-max, -max, -1, -1};
        }

        @Override
        public float[] high() {
            return new float[] {max, max, 1, 1};
        }

        @Override
        public Reader of(Robot robot, Truth world) {
            if (isTrue) {
                int number = world.number(robot.id());
                return (to, at) -> write(world.truth(number), to, at);
            }
            Localizer localizer = OwnPose.localizer(robot, "pose");
            return (to, at) -> write(OwnPose.believed(localizer), to, at);
        }

        private void write(Pose2d mapFromBase, float[] to, int at) {
            Bounds.put(mapFromBase.x(), mapFromBase.y(), max, to, at);
            to[at + 2] = (float) Math.cos(mapFromBase.theta());
            to[at + 3] = (float) Math.sin(mapFromBase.theta());
        }
    }
}
