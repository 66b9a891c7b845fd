package rsal.environment;

import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.stream.IntStream;
import rsal.data.Point2d;
import rsal.data.Pose2d;
import rsal.device.Localizer;
import rsal.robot.Robot;
import rsal.settings.Arguments;
import rsal.settings.Parameter;

/// In which directions the robot has been already in this episode, by its localizer. Real robots have it.
public final class VisitedObservation implements ObservationType {
    private static final Parameter<Integer> DIRECTIONS =
            Parameter.integer("directions", 8, 1, 72, "", "Number of directions, counter-clockwise from ahead.");
    private static final Parameter<Double> DISTANCE =
            Parameter.number("distance", 1.5, 0.1, 100, "m", "How far from the robot the place in each direction is.");
    private static final Parameter<Double> CELL =
            Parameter.number("cell", 0.75, 0.05, 100, "m", "Side of the cells that count as visited.");

    @Override
    public String key() {
        return "visited";
    }

    @Override
    public String description() {
        return "Whether the robot has been at the place in each direction, by its localizer.";
    }

    @Override
    public List<Parameter<?>> parameters() {
        return List.of(DIRECTIONS, DISTANCE, CELL);
    }

    @Override
    public LearnerObservation create(Arguments arguments) {
        return new Visited(arguments.get(DIRECTIONS), arguments.get(DISTANCE), arguments.get(CELL));
    }

    private record Visited(int directions, double distance, double cell) implements LearnerObservation {
        @Override
        public List<String> fields() {
            return IntStream.range(0, directions)
                    .mapToObj(direction -> "direction %d is visited".formatted(direction))
                    .toList();
        }

        @Override
        public float[] low() {
            return Bounds.repeated(directions, 0);
        }

        @Override
        public float[] high() {
            return Bounds.repeated(directions, 1);
        }

        @Override
        public Reader of(Robot robot, Truth world) {
            Localizer localizer = OwnPose.localizer(robot, "visited");
            Set<Long> visited = new HashSet<>(); // only asked whether it has a cell
            return (to, at) -> {
                Pose2d mapFromBase = OwnPose.believed(localizer);
                visited.add(cellOf(mapFromBase.position()));
                for (int i = 0; i < directions; i++) {
                    double angle = 2 * Math.PI * i / directions;
                    var baseFromPlace = new Point2d(distance * Math.cos(angle), distance * Math.sin(angle));
                    to[at + i] = visited.contains(cellOf(mapFromBase.transform(baseFromPlace))) ? 1 : 0;
                }
            };
        }

        private long cellOf(Point2d place) {
            return ((long) Math.floor(place.x() / cell) << Integer.SIZE)
                    | ((long) Math.floor(place.y() / cell) & 0xFFFF_FFFFL);
        }
    }
}
