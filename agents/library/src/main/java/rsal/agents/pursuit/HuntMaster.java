package rsal.agents.pursuit;

import java.util.List;
import rsal.agent.AgentContext;
import rsal.agents.parts.AgentTypeBase;
import rsal.settings.Arguments;
import rsal.settings.Parameter;

/// Has a team catch prey: hunters that bid (`follow` with `assignment: bids`) each get a prey so that no way is long,
/// more than one of them for a prey when there are more hunters; again and again while they move. Needs no robot.
public final class HuntMaster extends AgentTypeBase {
    static final String KEY = "hunt";
    static final Parameter<String> PREY =
            Parameter.robots("prey", "prey", List.of(), "Role of the robots to hunt, or id of one robot.");
    static final Parameter<Double> INTERVAL =
            Parameter.number("interval", 4, 0.5, 600, "s", "Time between two allocations of all prey.");

    public HuntMaster() {
        super(
                KEY,
                "Allocates prey to a team of hunters by their bids, so that near hunters catch and surround each"
                        + " prey.",
                List.of(PREY, INTERVAL),
                List.of());
    }

    @Override
    protected void begin(AgentContext self, Arguments arguments) {
        new PursuitCoordinator(self, arguments).begin();
    }
}
