package rsal.agent;

import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import rsal.device.Subscription;

/// Who is there.
public interface Directory {
    /// All running agents, in the order in which they started.
    List<Entry> agents();

    default Optional<Entry> find(String name) {
        return agents().stream().filter(e -> e.name().equals(name)).findFirst();
    }

    /// Agents of a role, in the order in which they started.
    default List<Entry> ofRole(String role) {
        return agents().stream().filter(e -> e.role().equals(role)).toList();
    }

    /// What a running agent offers, by name; empty for one that does not run.
    List<ServiceDescription> capabilities(String agent);

    /// Agents that offer something, in the order in which they started.
    default List<Entry> offering(String capability) {
        return agents().stream()
                .filter(agent -> capabilities(agent.name()).stream()
                        .anyMatch(offered -> offered.name().equals(capability)))
                .toList();
    }

    /// Tells of each that comes, what it offers, and of each that goes after its last words.
    Subscription onChange(Consumer<? super Change> listener);

    /// Tells only of those that go, which in a team of a thousand is less to hear.
    Subscription onDeparture(Consumer<? super Change.Went> listener);

    /// @param type key of its [AgentType]
    /// @param robot id of its robot; empty when it has none
    /// @param robotRole role of its robot; empty when it has none
    record Entry(String name, String role, String type, String robot, String robotRole) {}

    sealed interface Change {
        record Came(Entry agent) implements Change {}

        /// It offers something new, or something else under that name.
        record Offered(Entry agent, ServiceDescription capability) implements Change {}

        record Withdrew(Entry agent, ServiceDescription capability) implements Change {}

        /// @param reason empty when it ended as it should
        record Went(Entry agent, String reason) implements Change {}
    }
}
