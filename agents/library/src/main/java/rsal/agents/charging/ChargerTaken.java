package rsal.agents.charging;

import java.util.Optional;
import rsal.agent.MessageContent;
import rsal.agent.Topic;
import rsal.agent.message.MessageCheck;
import rsal.data.Point2d;

/// A robot drives to a charger or is charged there. It repeats this; after ten seconds without it, the charger
/// counts as free.
///
/// @param robot its id
/// @param mapFromCharger where the charger is, in the map frame [m]
public record ChargerTaken(String robot, Point2d mapFromCharger) implements MessageContent {
    public static final Topic<ChargerTaken> TOPIC = new Topic<>("charger-taken", ChargerTaken.class);

    public ChargerTaken {
        MessageCheck.given("robot", robot);
        MessageCheck.somewhere("charger", mapFromCharger);
    }

    @Override
    public String words() {
        return "%s has the charger at %s".formatted(robot, mapFromCharger.rounded());
    }

    /// It is said again and again.
    @Override
    public Optional<String> eventKind() {
        return Optional.empty();
    }
}
