package rsal.agents.patrol;

import java.util.List;
import rsal.agent.AgentContext;
import rsal.agents.driving.PlaceQuest;
import rsal.agents.parts.AgentTypeBase;
import rsal.data.Point2d;
import rsal.settings.Arguments;
import rsal.settings.Parameter;

/// Has a team watch places for ever, so that none is left alone for long. Needs no robot.
public final class Patrol extends AgentTypeBase {
    static final Parameter<List<Point2d>> PLACES =
            Parameter.places("places", "Places to watch. Default: a robot with a device of type 'places' finds them.");
    static final Parameter<Integer> COUNT = Parameter.integer("count", 12, 1, 1000, "", "Number of places to find.");
    static final Parameter<Double> STAY_TIME =
            Parameter.number("stayTime", 0, 0, 600, "s", "Time for which a robot stands at a place.");
    static final Parameter<String> STRATEGY = Parameter.choice(
            "strategy",
            "bids",
            List.of("bids", "cycle", "random"),
            "How places are assigned: by bids, which weigh the time since the last visit and the path cost; as a"
                    + " cycle of all places for each robot; or at random.");
    static final Parameter<Double> URGENCY = Parameter.number(
            "urgency",
            0.5,
            0,
            100,
            "m/s",
            "With bids: how much longer a path may be for each second since the last visit of a place.");

    public Patrol() {
        super(
                "patrol",
                "Lets a team visit places again and again, so that no place is unvisited for long.",
                List.of(PLACES, COUNT, PlaceQuest.CLEARANCE, STAY_TIME, STRATEGY, URGENCY, Alarms.RESPONDERS),
                List.of());
    }

    @Override
    protected void begin(AgentContext self, Arguments arguments) {
        new PatrolMonitor(self, arguments).begin();
    }
}
