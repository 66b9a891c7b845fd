package rsal.sim.offending;

import org.jspecify.annotations.Nullable;
import rsal.agents.offending.Seer;

/// A robot system that knows agents, which the architecture rules must find.
public record Seen(@Nullable Seer seer) {}
