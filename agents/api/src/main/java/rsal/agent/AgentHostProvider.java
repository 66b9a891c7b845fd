package rsal.agent;

import java.util.Collection;
import java.util.List;
import java.util.Optional;
import rsal.settings.Arguments;
import rsal.settings.Parameter;
import rsal.time.Scheduler;

/// A multi-agent system that can run agents, found by [java.util.ServiceLoader] and named by its key in a
/// scenario (`mas: {use: plain}`).
public interface AgentHostProvider {
    /// `plain`, `jason`, `jadex`, `jade`.
    String key();

    /// For people: a sentence.
    String description();

    /// Whether it can follow simulated time. When not, scenarios on a simulated clock refuse it at start.
    boolean followsSchedulerTime();

    default List<Parameter<?>> parameters() {
        return List.of();
    }

    /// Why an agent can't have a name, for people; empty when it can.
    ///
    /// @param others names of the other agents
    default Optional<String> nameProblem(String name, Collection<String> others) {
        return Optional.empty();
    }

    AgentHost create(Arguments settings, Scheduler scheduler);
}
