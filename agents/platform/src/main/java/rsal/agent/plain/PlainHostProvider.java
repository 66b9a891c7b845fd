package rsal.agent.plain;

import rsal.agent.AgentHost;
import rsal.agent.AgentHostProvider;
import rsal.agent.platform.PlainHost;
import rsal.settings.Arguments;
import rsal.time.Scheduler;

/// Runs all agents on the run's own thread: as fast as a method call, and deterministic in simulated time.
public final class PlainHostProvider implements AgentHostProvider {
    @Override
    public String key() {
        return "plain";
    }

    @Override
    public String description() {
        return "Runs agents on the thread of the run. In simulated time, equal seeds give equal runs.";
    }

    @Override
    public boolean followsSchedulerTime() {
        return true;
    }

    @Override
    public AgentHost create(Arguments settings, Scheduler scheduler) {
        return new PlainHost(scheduler);
    }
}
