package rsal.agents.pursuit;

import java.util.Locale;
import java.util.Optional;
import rsal.agent.MessageContent;
import rsal.agent.Topic;
import rsal.agent.message.MessageCheck;

/// A prey has given up. The prey says so once.
///
/// @param prey id of its robot
/// @param hunter id of the robot that has caught the prey
/// @param distance distance between the two, as the prey estimates it [m]
public record Caught(String prey, String hunter, double distance) implements MessageContent {
    public static final Topic<Caught> TOPIC = new Topic<>("caught", Caught.class);

    public Caught {
        MessageCheck.given("prey", prey);
        MessageCheck.given("hunter", hunter);
        if (!(distance >= 0)) {
            throw new IllegalArgumentException("A hunter must be at some distance, not '%s'.".formatted(distance));
        }
    }

    @Override
    public String words() {
        return String.format(Locale.ROOT, "%s is caught by %s, believed at %.2f m", prey, hunter, distance);
    }

    @Override
    public Optional<String> eventKind() {
        return Optional.of("caught");
    }
}
