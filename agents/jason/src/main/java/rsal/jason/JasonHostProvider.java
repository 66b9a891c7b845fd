package rsal.jason;

import rsal.agent.AgentHost;
import rsal.agent.AgentHostProvider;
import rsal.agent.platform.PlainHost;
import rsal.settings.Arguments;
import rsal.time.Scheduler;

/// Runs all agents on the run's own thread, deterministic in simulated time, as `plain` does: agents in AgentSpeak
/// bring their interpreter along.
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
    public AgentHost create(Arguments settings, Scheduler scheduler) {
        return new PlainHost(scheduler); // an agent's interpreter is part of the agent
    }
}
