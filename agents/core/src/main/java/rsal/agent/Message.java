package rsal.agent;

import java.time.Instant;

/// Something said.
///
/// @param sender name of the agent that said it, or `operator`
/// @param time when it was said
/// @param content immutable
public record Message<M>(Topic<M> topic, String sender, Instant time, M content) {}
