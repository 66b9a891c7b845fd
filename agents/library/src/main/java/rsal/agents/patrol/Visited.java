package rsal.agents.patrol;

import rsal.agent.MessageContent;
import rsal.agent.Topic;
import rsal.agent.message.MessageCheck;
import rsal.data.Point2d;

/// A robot was at a place that its team watches.
///
/// @param robot its id
/// @param mapFromPlace the place, in the map frame [m]
public record Visited(String robot, Point2d mapFromPlace) implements MessageContent {
    public static final Topic<Visited> TOPIC = new Topic<>("visited", Visited.class);

    public Visited {
        MessageCheck.given("robot", robot);
        MessageCheck.somewhere("place", mapFromPlace);
    }

    @Override
    public String words() {
        return "%s was at %s".formatted(robot, mapFromPlace.rounded());
    }
}
