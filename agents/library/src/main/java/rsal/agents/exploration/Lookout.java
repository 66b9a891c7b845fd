package rsal.agents.exploration;

import rsal.agent.MessageContent;
import rsal.agent.Topic;
import rsal.agent.message.MessageCheck;
import rsal.data.Point2d;

/// A robot goes to look around somewhere, or has done so: the others may look elsewhere.
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
