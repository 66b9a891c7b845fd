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
            "How the team divides things: by bids of what the paths cost, so that all is done soon; or a free robot"
                    + " fetches what was found first.");

    public FetchMaster() {
        super("fetch", "Has a team fetch what others have found.", List.of(ALLOCATION), List.of());
    }

    @Override
    protected void begin(AgentContext self, Arguments arguments) {
        new Orders(self, arguments).begin();
    }
}
