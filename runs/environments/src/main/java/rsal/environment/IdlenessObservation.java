package rsal.environment;

import java.util.ArrayList;
import java.util.List;
import rsal.data.Point2d;
import rsal.data.Pose2d;
import rsal.robot.Robot;
import rsal.settings.Arguments;
import rsal.settings.Parameter;

/// Where places of a patrol are, in the base frame, and for how many observations nobody of a role was there, by the
/// truth of the simulation. Real robots do not have it.
public final class IdlenessObservation implements ObservationType {
    private static final Parameter<List<Point2d>> PLACES = Parameter.points("places", "The places in the map.");
    private static final Parameter<String> ROLE =
            Parameter.text("role", "", "Role of the robots that visit them. Default: all robots.");
    private static final Parameter<Double> RADIUS =
            Parameter.number("radius", 1, 0.05, 100, "m", "Distance at which a robot is at a place.");
    private static final Parameter<Double> MAX = Parameter.number(
            "max", 1000, 1, 1_000_000, "", "Greatest coordinate and count; those beyond count as this one.");

    @Override
    public String key() {
        return "idleness";
    }

    @Override
    public String description() {
        return "Positions of places in the base frame [m], and for how many observations nobody was there.";
    }

    @Override
    public List<Parameter<?>> parameters() {
        return List.of(PLACES, ROLE, RADIUS, MAX);
    }

    @Override
    public LearnerObservation create(Arguments arguments) {
        List<Point2d> places = arguments.get(PLACES);
        if (places.isEmpty()) {
            throw new IllegalArgumentException("'places' must name at least one place, as \"2 3; 4 -1\".");
        }
        return new Idleness(
                places,
                arguments.get(ROLE),
                arguments.get(RADIUS),
                arguments.get(MAX).floatValue());
    }

    private record Idleness(List<Point2d> places, String role, double radius, float max) implements LearnerObservation {
        private static final int EACH = 3; // x, y, count

        @Override
        public List<String> fields() {
            var fields = new ArrayList<String>();
            for (int i = 1; i <= places.size(); i++) {
                fields.add("x of place %d [m]".formatted(i));
                fields.add("y of place %d [m]".formatted(i));
                fields.add("steps without a visit to place %d".formatted(i));
            }
            return fields;
        }

        @Override
        public float[] low() {
            return Bounds.repeated(places.size(), -max, -max, 0);
        }

        @Override
        public float[] high() {
            return Bounds.repeated(places.size(), max, max, max);
        }

        @Override
        public Reader of(Robot robot, Truth world) {
            int own = world.number(robot.id());
            int[] team = world.numbers(role);
            var idle = new int[places.size()]; // observations without a visit
            return (to, at) -> {
                Pose2d baseFromMap = world.truth(own).inverse();
                for (int i = 0; i < idle.length; i++) {
                    Point2d place = places.get(i);
                    idle[i] = isVisited(place, team, world) ? 0 : idle[i] + 1;
                    Point2d baseFromPlace = baseFromMap.transform(place);
                    int next = at + EACH * i;
                    Bounds.put(baseFromPlace.x(), baseFromPlace.y(), max, to, next);
                    to[next + 2] = Math.min(idle[i], max);
                }
            };
        }

        private boolean isVisited(Point2d place, int[] team, Truth world) {
            for (int robot : team) {
                if (world.truth(robot).position().distanceTo(place) <= radius) {
                    return true;
                }
            }
            return false;
        }
    }
}
