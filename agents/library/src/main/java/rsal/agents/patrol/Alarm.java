package rsal.agents.patrol;

import java.util.Optional;
import rsal.agent.MessageContent;
import rsal.agent.Topic;
import rsal.agent.message.MessageCheck;
import rsal.data.Point2d;

/// A robot sees an intruder. The robot repeats this as long as it sees the intruder.
///
/// @param robot id of the robot that sees the intruder
/// @param mapFromIntruder position of the intruder, in the map frame [m]
public record Alarm(String robot, Point2d mapFromIntruder) implements MessageContent {
    public static final Topic<Alarm> TOPIC = new Topic<>("alarm", Alarm.class);

    public Alarm {
        MessageCheck.given("robot", robot);
        MessageCheck.somewhere("intruder", mapFromIntruder);
    }

    @Override
    public String words() {
        return "%s sees an intruder at %s".formatted(robot, mapFromIntruder.rounded());
    }

    /// It is said again and again.
    @Override
    public Optional<String> eventKind() {
        return Optional.empty();
    }
}
