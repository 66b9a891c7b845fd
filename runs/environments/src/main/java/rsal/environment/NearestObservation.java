package rsal.environment;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import rsal.data.Point2d;
import rsal.data.Pose2d;
import rsal.robot.Robot;
import rsal.settings.Arguments;
import rsal.settings.Parameter;

/// Where the nearest other robots are, by their true poses, the nearest first: position in the robot's base frame, and
/// whether there is one. Walls do not hide them. Real robots do not have it.
public final class NearestObservation implements ObservationType {
    private static final Parameter<String> ROLE =
            Parameter.text("role", "", "Role of these robots. Default: all robots.");
    private static final Parameter<Integer> COUNT = Parameter.integer("count", 1, 1, 1000, "", "Number of robots.");
    private static final Parameter<Double> MAX = Parameter.number(
            "max", 100, 0.1, 10_000, "m", "Greatest distance; robots that are farther away do not count.");

    @Override
    public String key() {
        return "nearest";
    }

    @Override
    public String description() {
        return "Positions of the nearest other robots in the base frame [m], by the truth of the simulation.";
    }

    @Override
    public List<Parameter<?>> parameters() {
        return List.of(ROLE, COUNT, MAX);
    }

    @Override
    public LearnerObservation create(Arguments arguments) {
        return new Nearest(
                arguments.get(ROLE), arguments.get(COUNT), arguments.get(MAX).floatValue());
    }

    private record Nearest(String role, int count, float max) implements LearnerObservation {
        private static final int EACH = 3; // x, y, whether there is one

        @Override
        public List<String> fields() {
            var fields = new ArrayList<String>();
            for (int i = 1; i <= count; i++) {
                fields.add("x of robot %d [m]".formatted(i));
                fields.add("y of robot %d [m]".formatted(i));
                fields.add("robot %d exists".formatted(i));
            }
            return fields;
        }

        @Override
        public float[] low() {
            return Bounds.repeated(count, -max, -max, 0);
        }

        @Override
        public float[] high() {
            return Bounds.repeated(count, max, max, 1);
        }

        @Override
        public Reader of(Robot robot, Truth world) {
            int own = world.number(robot.id());
            int[] others = Arrays.stream(world.numbers(role))
                    .filter(number -> number != own)
                    .toArray();
            if (others.length == 0) {
                throw new IllegalArgumentException(
                        "Robot '%s' has no other robots of the role '%s' for the observation 'nearest'."
                                .formatted(robot.id(), role));
            }
            return (to, at) -> write(world, own, others, to, at);
        }

        /// Takes the nearest, then the nearest of the rest, as there are few.
        private void write(Truth world, int own, int[] others, float[] to, int at) {
            Pose2d mapFromBase = world.truth(own);
            Pose2d baseFromMap = mapFromBase.inverse();
            double taken = -1; // squared distance of the last one
            int takenNumber = -1;
            for (int i = 0; i < count; i++) {
                int nearest = -1;
                double least = (double) max * max;
                for (int other : others) {
                    double dx = world.truth(other).x() - mapFromBase.x();
                    double dy = world.truth(other).y() - mapFromBase.y();
                    double squared = dx * dx + dy * dy;
                    boolean isLeft = squared > taken || (squared == taken && other > takenNumber);
                    if (isLeft && squared <= least && (nearest < 0 || squared < least)) {
                        nearest = other;
                        least = squared;
                    }
                }
                int first = at + EACH * i;
                if (nearest < 0) {
                    Arrays.fill(to, first, first + EACH, 0);
                    continue;
                }
                Point2d baseFromNearest =
                        baseFromMap.transform(world.truth(nearest).position());
                to[first] = (float) baseFromNearest.x();
                to[first + 1] = (float) baseFromNearest.y();
                to[first + 2] = 1;
                taken = least;
                takenNumber = nearest;
            }
        }
    }
}
