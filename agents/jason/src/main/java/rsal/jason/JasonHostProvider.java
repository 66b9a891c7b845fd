package rsal.jason;

import java.util.List;
import rsal.agent.AgentHost;
import rsal.agent.AgentHostProvider;
import rsal.agent.AgentLanguage;
import rsal.agent.platform.PlainHost;
import rsal.settings.Arguments;
import rsal.time.Scheduler;

/// Runs agents written in AgentSpeak, and Java agents beside them, all on the run's own thread: deterministic in
/// simulated time.
public final class JasonHostProvider implements AgentHostProvider {
    @Override
    public String key() {
        return "jason";
    }

    @Override
    public String description() {
        return "Runs agents in AgentSpeak, together with Java agents, inside the run, also in simulated time.";
    }

    @Override
    public boolean followsSchedulerTime() {
        return true;
    }

    @Override
    public List<AgentLanguage> languages() {
        return List.of(new AgentSpeak());
    }

    @Override
    public AgentHost create(Arguments settings, Scheduler scheduler) {
        return new PlainHost(scheduler); // an agent's interpreter is part of the agent
    }
}
