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
            "Who fetches what: so that all is done soon, by what ways would cost those who bid; or whoever is free what"
                    + " was found first.");

    public FetchMaster() {
        super("fetch", "Has a team fetch what others have found.", List.of(ALLOCATION), List.of());
    }

    @Override
    protected void begin(AgentContext self, Arguments arguments) {
        new Orders(self, arguments).begin();
    }
}
