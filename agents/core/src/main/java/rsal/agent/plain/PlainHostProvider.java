package rsal.agent.plain;

import java.util.List;
import rsal.agent.AgentHost;
import rsal.agent.AgentHostProvider;
import rsal.settings.Arguments;
import rsal.settings.Parameter;
import rsal.time.Scheduler;

/// Runs all agents on the run's own thread: as fast as a method call, and deterministic in simulated time.
public final class PlainHostProvider implements AgentHostProvider {
    @Override
    public String key() {
        return "plain";
    }

    @Override
    public boolean followsSchedulerTime() {
        return true;
    }

    @Override
    public List<Parameter> parameters() {
        return List.of();
    }

    @Override
    public AgentHost create(Arguments settings, Scheduler scheduler) {
        return new PlainHost(scheduler);
    }
}
