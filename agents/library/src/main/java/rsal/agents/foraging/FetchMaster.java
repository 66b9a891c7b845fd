package rsal.agents.foraging;

import java.util.List;
import rsal.agent.AgentContext;
import rsal.agents.parts.AgentTypeBase;
import rsal.settings.Arguments;
import rsal.settings.Parameter;

/// Has a team fetch what others ask for. Needs no robot.
public final class FetchMaster extends AgentTypeBase {
    static final Parameter<String> ALLOCATION = Parameter.choice(
            "allocation",
            "bids",
            List.of("bids", "first"),
            "How the team divides things: by bids of the path costs, so that all are collected soon; or a free robot"
                    + " fetches the thing that was found first.");

    public FetchMaster() {
        super(
                "fetch",
                "Allocates things that others have found to a team, which fetches them.",
                List.of(ALLOCATION),
                List.of());
    }

    @Override
    protected void begin(AgentContext self, Arguments arguments) {
        new Orders(self, arguments).begin();
    }
}
