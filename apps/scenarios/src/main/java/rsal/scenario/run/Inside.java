package rsal.scenario.run;

import java.util.List;
import java.util.Optional;
import rsal.agent.bdi.Mind;
import rsal.scenario.RunPlan.PlannedAgent;

/// How an agent was started, what it believes, wants and does, and what it talks about: made for those who look into
/// it.
///
/// @param mind empty when it has none, or has ended
/// @param talks what it and its partners said in conversations lately, oldest first
/// @param hearings what it heard of others and others of it, where that is recorded
public record Inside(PlannedAgent agent, Optional<Mind.View> mind, List<Spoken> talks, List<Hearing> hearings) {
    public Inside {
        talks = List.copyOf(talks);
        hearings = List.copyOf(hearings);
    }
}
