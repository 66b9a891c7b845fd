package rsal.engine.report;

import java.time.Duration;

/// A message that reached an agent.
///
/// @param time since the run's start, when it was said
/// @param from name of the agent that said it, or `operator`
/// @param forAll whether it was for all who listen, else for this agent alone
/// @param words clipped
public record ReceivedMessage(Duration time, String from, boolean forAll, String topic, String words) {}
