package rsal.agents.coverage;

import java.util.List;
import rsal.agent.AgentContext;
import rsal.agent.message.NewGoal;
import rsal.agents.driving.PlaceQuest;
import rsal.agents.parts.AgentTypeBase;
import rsal.data.Point2d;
import rsal.settings.Arguments;
import rsal.settings.Parameter;

/// Keeps a team spread over places, given or found on the map: allots them exactly, by what the ways cost, and again
/// and again, as robots come, fall silent and are back. Needs no robot.
public final class DeploymentAgent extends AgentTypeBase {
    static final Parameter<String> ROBOTS =
            Parameter.robots("robots", NewGoal.ALL, List.of(NewGoal.ALL), "Role of the robots to spread, or all.");
    static final Parameter<List<Point2d>> PLACES = Parameter.places(
            "places",
            "Where they should be; those that are too many stay empty. None: they are found"
                    + " by a robot with a device of type 'places'.");
    static final Parameter<Integer> COUNT =
            Parameter.integer("count", 0, 0, 10_000, "", "How many places to find; 0 for as many as there are robots.");
    static final Parameter<Double> PING_INTERVAL = Parameter.number(
            "pingInterval",
            30,
            0.5,
            3600,
            "s",
            "A robot of which nothing was heard for that long is asked; after three times that it counts as silent.");
    static final Parameter<Double> ALLOCATION_INTERVAL = Parameter.number(
            "allocationInterval",
            60,
            0,
            3600,
            "s",
            "Time between two allocations of the places; 0 for only when the team changes.");

    public DeploymentAgent() {
        super(
                "deployment",
                "Keeps a team spread over places, each robot at one that is near.",
                List.of(ROBOTS, PLACES, COUNT, PlaceQuest.CLEARANCE, PING_INTERVAL, ALLOCATION_INTERVAL),
                List.of());
    }

    @Override
    protected void begin(AgentContext self, Arguments arguments) {
        new Deployment(self, arguments).begin();
    }
}
