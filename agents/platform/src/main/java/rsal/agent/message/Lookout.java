package rsal.agent.message;

import rsal.agent.MessageContent;
import rsal.agent.Topic;
import rsal.data.Point2d;

/// A robot goes to look around somewhere, or has done so: the others may look elsewhere.
public record Lookout(String robot, Point2d mapFromPlace, boolean done) implements MessageContent {
    public static final Topic<Lookout> TOPIC = new Topic<>("lookout", Lookout.class);

    public Lookout {
        Check.given("robot", robot);
        Check.somewhere("place", mapFromPlace);
    }

    @Override
    public String words() {
        return (done ? "%s has looked around at %s" : "%s goes to look around at %s")
                .formatted(robot, mapFromPlace.rounded());
    }
}
