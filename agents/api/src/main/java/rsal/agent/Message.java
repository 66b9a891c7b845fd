package rsal.agent;

import java.time.Instant;

/// Something said.
///
/// @param sender name of the agent that said it, or `operator`
/// @param to name of the agent it is for; empty when it is for all who listen
/// @param time when it was said
/// @param content immutable
public record Message<M>(Topic<M> topic, String sender, String to, Instant time, M content) {
    public boolean isForAll() {
        return to.isEmpty();
    }
}
