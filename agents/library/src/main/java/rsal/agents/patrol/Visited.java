package rsal.agents.patrol;

import java.util.List;
import rsal.agent.MessageContent;
import rsal.agent.Topic;
import rsal.agent.message.MessageCheck;
import rsal.data.Point2d;

/// A robot was at a place that its team watches.
///
/// @param robot its id
/// @param mapFromPlace the place, in the map frame [m]
/// @param idleness times since the last visits of all places, in the order of [PatrolOrder] [s]. It is -1
///     ([#UNKNOWN]) for those of which the robot knows of no visit; empty when it knows of none
public record Visited(String robot, Point2d mapFromPlace, List<Double> idleness) implements MessageContent {
    public static final Topic<Visited> TOPIC = new Topic<>("visited", Visited.class);

    /// Stands for the time since a visit when none is known.
    public static final double UNKNOWN = -1;

    public Visited {
        MessageCheck.given("robot", robot);
        MessageCheck.somewhere("place", mapFromPlace);
        idleness = List.copyOf(idleness);
        if (!idleness.stream().allMatch(each -> (each >= 0 || each == UNKNOWN) && Double.isFinite(each))) {
            throw new IllegalArgumentException(
                    "Times since visits are at least 0 s, or -1 where none is known, not '%s'.".formatted(idleness));
        }
    }

    /// Of one that knows nothing of other places.
    public Visited(String robot, Point2d mapFromPlace) {
        this(robot, mapFromPlace, List.of());
    }

    @Override
    public String words() {
        return "%s was at %s".formatted(robot, mapFromPlace.rounded());
    }
}
