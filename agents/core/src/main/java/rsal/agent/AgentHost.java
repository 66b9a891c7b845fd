package rsal.agent;

import rsal.time.Scheduler;

/// Runs agents. A host supplies each agent's lane, its single thread of execution; what agents can say to each
/// other and in which order it arrives is the same on all hosts, because `Society` does that.
public interface AgentHost extends AutoCloseable {
    /// The time and timers of a new agent, whose tasks run on the agent's lane.
    ///
    /// @param name of the agent
    Scheduler lane(String name);

    /// The agent is gone: nothing runs on its lane any more.
    void end(String name);

    @Override
    void close();
}
