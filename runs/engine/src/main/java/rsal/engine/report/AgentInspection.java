package rsal.engine.report;

import java.util.List;
import java.util.Optional;
import rsal.agent.bdi.Mind;
import rsal.agent.platform.AgentPlatform;
import rsal.scenario.RunPlan.PlannedAgent;

/// How an agent was started, what it believes, wants and does, and what it talks about: made for those who look
/// into it.
///
/// @param planned how it was started; empty where that is not known: of agents that people started, a recording
///         does not tell it
/// @param shown how it is and what it shows of itself, which any agent may; empty when it has not started
/// @param mind empty when it has none, or has ended
/// @param program the rules and plans that it goes by, where it is written in a language for agents
/// @param history what it did, believed and wanted lately, oldest first: see [rsal.engine.RunInspector#inside]
/// @param mail what reached it lately, oldest first, of each topic the newest; empty where that is not known
/// @param talks what it and its partners said in conversations lately, oldest first
/// @param hearings what it heard of others and others of it, where that is recorded
public record AgentInspection(
        String name,
        Optional<PlannedAgent> planned,
        Optional<AgentPlatform.View> shown,
        Optional<Mind.View> mind,
        Optional<Mind.Program> program,
        List<MindChange> history,
        Optional<List<ReceivedMessage>> mail,
        List<SpeechAct> talks,
        List<Reception> hearings) {
    public AgentInspection {
        history = List.copyOf(history);
        mail = mail.map(List::copyOf);
        talks = List.copyOf(talks);
        hearings = List.copyOf(hearings);
    }
}
