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
                "Has a team map a place: the robot that gets there first drives to each frontier of the map, until no frontier is left.",
                List.of(),
                List.of());
    }

    @Override
    protected void begin(AgentContext self, Arguments arguments) {
        new Cartography(self).begin();
    }
}
