package rsal.environment;

import java.util.List;
import rsal.data.Point2d;
import rsal.data.Pose2d;
import rsal.device.Navigator;
import rsal.robot.Robot;
import rsal.settings.Arguments;
import rsal.settings.Parameter;

/// Sends the robot's navigator to one of some places of the map. The choice of the place to which it is already driving
/// changes nothing.
public final class PlaceAction implements ActionType {
    private static final Parameter<List<Point2d>> PLACES = Parameter.points("places", "The places in the map.");
    private static final double NEAR = 0.3; // m, at which a place counts as reached

    @Override
    public String key() {
        return "place";
    }

    @Override
    public String description() {
        return "Sends the navigator to one of some places of the map.";
    }

    @Override
    public List<Parameter<?>> parameters() {
        return List.of(PLACES);
    }

    @Override
    public LearnerAction create(Arguments arguments) {
        List<Point2d> places = arguments.get(PLACES);
        if (places.isEmpty()) {
            throw new IllegalArgumentException("'places' must name at least one place, as \"2 3; 4 -1\".");
        }
        return new Chosen(places);
    }

    private record Chosen(List<Point2d> places) implements LearnerAction {
        @Override
        public List<String> fields() {
            return List.of("place");
        }

        @Override
        public float[] low() {
            return new float[] {0};
        }

        @Override
        public float[] high() {
            return new float[] {places.size() - 1};
        }

        @Override
        public int choices() {
            return places.size();
        }

        @Override
        public Actor of(Learner learner) {
            Robot robot = learner.robot();
            Navigator navigator = robot.find(Navigator.class)
                    .orElseThrow(() -> new IllegalArgumentException(
                            "Robot '%s' has no navigator for the action 'place'.".formatted(robot.id())));
            var before = new int[] {-1};
            return (from, at) -> {
                int choice = Math.round(from[at]);
                if (choice != before[0]) {
                    before[0] = choice;
                    Point2d place = places.get(choice);
                    learner.run(() -> learner.goTo(
                            navigator, new Pose2d(place.x(), place.y(), 0), Navigator.Tolerance.position(NEAR)));
                }
            };
        }
    }
}
