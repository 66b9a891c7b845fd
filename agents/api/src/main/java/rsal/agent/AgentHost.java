package rsal.agent;

import java.util.Optional;
import java.util.function.Consumer;
import rsal.time.Scheduler;

/// Runs agents. A host supplies each agent's lane, its single thread of execution, and may carry what agents say; what
/// they can say, what becomes of it and how conversations end is the same on all hosts, because `Society` and
/// `rsal.agent.protocol` do that.
///
/// All calls on the run's thread, or on that of one of its agents while it is that one's turn
/// ([Scheduler#exclusively]). None may wait for a thread that waits for its turn, as those of agents do.
public interface AgentHost extends AutoCloseable {
    /// The time and timers of a new agent, whose tasks run on the agent's lane, one at a time, in the order in which
    /// they were handed in or were due.
    ///
    /// @param name of the agent, as no other that runs has
    Scheduler lane(String name);

    /// How the multi-agent system carries what its agents say; empty when it leaves that to us, which is to say that
    /// all is heard at the instant when it is said.
    default Optional<MessageTransport> carrier() {
        return Optional.empty();
    }

    /// From now on this is told the name of each agent that the multi-agent system has ended by itself, as a person may
    /// want it by its tools. Told on the run's thread; nothing runs on that one's lane any more.
    default void onKilled(Consumer<String> listener) {}

    /// The agent is gone: nothing runs on its lane any more. What it has said already is still carried.
    void end(String name);

    /// All agents are gone. Threads and what else it holds are given back soon after.
    @Override
    void close();
}
