package rsal.jason;

import rsal.agent.AgentHost;
import rsal.time.Scheduler;

/// Each lane is the run's scheduler: an agent's interpreter is part of the agent.
record JasonHost(Scheduler scheduler) implements AgentHost {
    @Override
    public Scheduler lane(String name) {
        return scheduler;
    }

    @Override
    public void end(String name) {} // Society runs nothing of an ended agent

    @Override
    public void close() {}
}
