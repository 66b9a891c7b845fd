package rsal.agents.coverage;

import java.util.List;
import rsal.agent.AgentContext;
import rsal.agent.message.NewGoal;
import rsal.agents.driving.PlaceQuest;
import rsal.agents.parts.AgentTypeBase;
import rsal.data.PlaceObjective;
import rsal.data.Point2d;
import rsal.settings.Arguments;
import rsal.settings.Parameter;

/// Keeps a team spread over places, given or found on the map: allots them exactly, by what the ways cost, and again
/// and again, as robots come, fall silent and are back. Needs no robot.
public final class DeploymentAgent extends AgentTypeBase {
    static final Parameter<String> ROBOTS =
            Parameter.robots("robots", NewGoal.ALL, List.of(NewGoal.ALL), "Role of the robots to distribute, or all.");
    static final Parameter<List<Point2d>> PLACES = Parameter.places(
            "places",
            "The places. If there are more than robots, some stay empty. Default: a robot with a device of type"
                    + " 'places' finds them.");
    static final Parameter<Integer> COUNT =
            Parameter.integer("count", 0, 0, 10_000, "", "Number of places to find; 0: the number of robots.");
    static final Parameter<String> OBJECTIVE = Parameter.choice(
            "objective",
            PlaceObjective.ROOMS.key(),
            PlaceObjective.keys(),
            "What makes places that are found good. rooms: one in each room; then far apart, then near to everything."
                    + " apart: the least distance between two is large. near: the greatest distance to the nearest is"
                    + " small. evenly: the mean square of that distance is small. view: they see much of the floor.");
    static final Parameter<Double> PING_INTERVAL = Parameter.number(
            "pingInterval",
            30,
            0.5,
            3600,
            "s",
            "The agent pings a robot without a message for this time. After three times this time, the robot counts"
                    + " as silent.");
    static final Parameter<Double> ALLOCATION_INTERVAL = Parameter.number(
            "allocationInterval",
            60,
            0,
            3600,
            "s",
            "Time between two allocations of the places; 0: only when the team changes.");

    public DeploymentAgent() {
        super(
                "deployment",
                "Keeps a team distributed over places, each robot at a near one.",
                List.of(ROBOTS, PLACES, COUNT, OBJECTIVE, PlaceQuest.CLEARANCE, PING_INTERVAL, ALLOCATION_INTERVAL),
                List.of());
    }

    @Override
    protected void begin(AgentContext self, Arguments arguments) {
        new Deployment(self, arguments).begin();
    }
}
