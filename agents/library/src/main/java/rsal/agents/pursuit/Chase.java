package rsal.agents.pursuit;

import rsal.agent.MessageContent;
import rsal.agent.Topic;
import rsal.agent.message.MessageCheck;

/// A hunter chases a prey from now on.
///
/// @param hunter id of its robot
/// @param prey id of the prey's robot
public record Chase(String hunter, String prey) implements MessageContent {
    public static final Topic<Chase> TOPIC = new Topic<>("chase", Chase.class);

    public Chase {
        MessageCheck.given("hunter", hunter);
        MessageCheck.given("prey", prey);
    }

    @Override
    public String words() {
        return prey.isEmpty() ? "%s cuts a prey off".formatted(hunter) : "%s goes for %s".formatted(hunter, prey);
    }
}
