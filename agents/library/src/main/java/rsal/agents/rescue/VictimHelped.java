package rsal.agents.rescue;

import rsal.agent.MessageContent;
import rsal.agent.Topic;

/// A helper has been with a victim: nobody need look after it any more.
///
/// @param victim what its marker says
public record VictimHelped(int victim) implements MessageContent {
    public static final Topic<VictimHelped> TOPIC = new Topic<>("victim-helped", VictimHelped.class);

    /// `victim 3 has been helped`
    @Override
    public String toString() {
        return "victim %d has been helped".formatted(victim);
    }
}
