package rsal.agents.offending;

import rsal.sim.offending.Seen;

/// An agent that knows where robots come from, which the architecture rules must find.
public record Seer(Seen seen) {}
