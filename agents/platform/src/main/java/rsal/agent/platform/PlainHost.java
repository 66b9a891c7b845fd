package rsal.agent.platform;

import rsal.agent.AgentHost;
import rsal.time.Scheduler;

/// Each lane is the run's scheduler: for systems whose agents bring all else that they need.
public record PlainHost(Scheduler scheduler) implements AgentHost {
    @Override
    public Scheduler lane(String name) {
        return scheduler;
    }

    @Override
    public void end(String name) {} // Society runs nothing of an ended agent

    @Override
    public void close() {}
}
