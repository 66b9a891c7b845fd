package rsal.agents.exploration;

import rsal.agent.MessageContent;
import rsal.agent.Topic;
import rsal.agent.message.MessageCheck;
import rsal.data.Point2d;

/// A robot drives to a place to look around, or has looked around there. The others can look elsewhere.
///
/// @param robot its id
/// @param mapFromPlace the place, in the map frame [m]
/// @param done whether it has looked around
public record Lookout(String robot, Point2d mapFromPlace, boolean done) implements MessageContent {
    public static final Topic<Lookout> TOPIC = new Topic<>("lookout", Lookout.class);

    public Lookout {
        MessageCheck.given("robot", robot);
        MessageCheck.somewhere("place", mapFromPlace);
    }

    @Override
    public String words() {
        return (done ? "%s has looked around at %s" : "%s goes to look around at %s")
                .formatted(robot, mapFromPlace.rounded());
    }
}
