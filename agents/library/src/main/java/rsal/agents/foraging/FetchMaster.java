package rsal.agents.foraging;

import java.util.List;
import rsal.agent.AgentContext;
import rsal.agent.team.AllocationType;
import rsal.agents.parts.AgentTypeBase;
import rsal.settings.Arguments;
import rsal.settings.Parameter;
import rsal.settings.PluginChoice;

/// Has a team fetch what others ask for. Needs no robot.
public final class FetchMaster extends AgentTypeBase {
    static final Parameter<PluginChoice> ALLOCATION = AllocationType.parameter();

    public FetchMaster() {
        super(
                "fetch",
                "Allocates things that others have found to a team, which fetches them.",
                List.of(ALLOCATION),
                List.of());
    }

    @Override
    protected void begin(AgentContext self, Arguments arguments) {
        new FetchRequests(self, arguments).begin();
    }
}
