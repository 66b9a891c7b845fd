package rsal.agents.parts;

import java.util.Map;
import java.util.Optional;
import rsal.agent.AgentContext;
import rsal.agent.Directory;
import rsal.agent.ServiceDescription;

/// Who wears which marker, as their agents tell the directory.
public final class Markers {
    private static final String NAME = "marker";
    private static final String ID = "id";

    private Markers() {}

    /// Tells which one the agent's robot wears, if any.
    static void publish(AgentContext self) {
        self.robot()
                .ifPresent(robot -> robot.marker()
                        .ifPresent(id -> self.offer(new ServiceDescription(NAME, Map.of(ID, Integer.toString(id))))));
    }

    /// Whose robot wears a marker; empty when no agent that runs has told.
    public static Optional<Directory.Entry> wearer(Directory directory, int marker) {
        var worn = new ServiceDescription(NAME, Map.of(ID, Integer.toString(marker)));
        return directory.agents().stream()
                .filter(agent -> directory.capabilities(agent.name()).contains(worn))
                .findFirst();
    }
}
