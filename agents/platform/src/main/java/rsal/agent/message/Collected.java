package rsal.agent.message;

import rsal.agent.MessageContent;
import rsal.agent.Topic;
import rsal.data.Point2d;

/// A robot has brought something to a depot and let go of it there.
public record Collected(String robot, CollectGoal goal, Point2d mapFromDepot) implements MessageContent {
    public static final Topic<Collected> TOPIC = new Topic<>("collected", Collected.class);

    public Collected {
        Check.given("robot", robot);
        Check.given("goal", goal);
        Check.somewhere("depot", mapFromDepot);
    }

    @Override
    public String words() {
        return "%s has brought %s to %s".formatted(robot, goal, mapFromDepot.rounded());
    }
}
