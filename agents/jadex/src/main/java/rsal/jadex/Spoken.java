package rsal.jadex;

import jadex.bridge.service.annotation.Reference;
import java.util.function.Consumer;
import rsal.agent.Message;

/// A message on its way.
///
/// @param arrival told the name of the one whom it has reached
@Reference
public record Spoken(Message<?> message, Consumer<String> arrival) {}
