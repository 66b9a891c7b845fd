package rsal.agents.exploration;

import java.util.List;
import rsal.agent.AgentContext;
import rsal.agents.parts.AgentTypeBase;
import rsal.settings.Arguments;

/// Has a team map a place that nobody knows. Needs no robot.
public final class Mapping extends AgentTypeBase {
    public Mapping() {
        super(
                "mapping",
                "Allocates the frontiers of the map to a team, each to the robot that reaches it first, until no"
                        + " frontier is left.",
                List.of(),
                List.of());
    }

    @Override
    protected void begin(AgentContext self, Arguments arguments) {
        new Cartography(self).begin();
    }
}
