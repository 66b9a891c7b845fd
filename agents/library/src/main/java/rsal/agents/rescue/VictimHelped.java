package rsal.agents.rescue;

import rsal.agent.MessageContent;
import rsal.agent.Topic;

/// A helper was with a victim, which needs no more help.
///
/// @param victim number of the victim's marker
public record VictimHelped(int victim) implements MessageContent {
    public static final Topic<VictimHelped> TOPIC = new Topic<>("victim-helped", VictimHelped.class);

    /// `victim 3 has been helped`
    @Override
    public String toString() {
        return "victim %d has been helped".formatted(victim);
    }
}
