package rsal.scenario.run;

import java.util.List;
import rsal.agent.Society;

/// An agent as people see it.
///
/// @param lastMessages the newest it said, oldest first
public record AgentView(Society.View view, List<String> lastMessages) {
    public AgentView {
        lastMessages = List.copyOf(lastMessages);
    }
}
