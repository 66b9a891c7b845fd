package rsal.agents.foraging;

import rsal.agent.MessageContent;
import rsal.agent.Topic;
import rsal.agent.message.MessageCheck;
import rsal.data.Point2d;

/// A robot has brought a thing to a depot and released it there.
///
/// @param robot its id
/// @param goal the thing, as it was announced
/// @param mapFromDepot where the depot is, in the map frame [m]
public record Collected(String robot, CollectGoal goal, Point2d mapFromDepot) implements MessageContent {
    public static final Topic<Collected> TOPIC = new Topic<>("collected", Collected.class);

    public Collected {
        MessageCheck.given("robot", robot);
        MessageCheck.given("goal", goal);
        MessageCheck.somewhere("depot", mapFromDepot);
    }

    @Override
    public String words() {
        return "%s has brought %s to %s".formatted(robot, goal, mapFromDepot.rounded());
    }
}
