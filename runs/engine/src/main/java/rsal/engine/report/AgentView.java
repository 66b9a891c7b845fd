package rsal.engine.report;

import java.time.Duration;
import java.util.List;
import java.util.Optional;
import rsal.agent.platform.AgentPlatform;

/// An agent as people see it.
///
/// @param lastMessages the newest it said, oldest first
/// @param lastSaid when it said the last of them, since the run's start; empty while it has said nothing
public record AgentView(AgentPlatform.View view, List<String> lastMessages, Optional<Duration> lastSaid) {
    public AgentView {
        lastMessages = List.copyOf(lastMessages);
    }
}
