package rsal.agents.pursuit;

import rsal.agent.MessageContent;
import rsal.agent.Topic;
import rsal.agent.message.MessageCheck;
import rsal.data.Pose2d;

/// A hunter drives there from now on, by its pursuit strategy. Other hunters count on it.
///
/// @param hunter id of its robot
/// @param prey id of the robot that it hunts; empty while it searches
/// @param mapFromGoal where it drives, in the map frame; its heading does not matter
public record PursuitGoal(String hunter, String prey, Pose2d mapFromGoal) implements MessageContent {
    public static final Topic<PursuitGoal> TOPIC = new Topic<>("pursuit-goal", PursuitGoal.class);

    public PursuitGoal {
        MessageCheck.given("hunter", hunter);
        MessageCheck.given("prey", prey);
        MessageCheck.somewhere("goal", mapFromGoal);
    }

    @Override
    public String words() {
        return "%s drives to %s".formatted(hunter, mapFromGoal.rounded());
    }
}
