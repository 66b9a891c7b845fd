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
    static final Parameter<List<Point2d>> PLACES = Parameter.places(
            "places", "Which places to watch. None: they are found by a robot with a device of type 'places'.");
    static final Parameter<Integer> COUNT = Parameter.integer("count", 12, 1, 1000, "", "How many places to find.");
    static final Parameter<Double> STAY_TIME =
            Parameter.number("stayTime", 0, 0, 600, "s", "How long a robot stands at a place.");
    static final Parameter<String> STRATEGY = Parameter.choice(
            "strategy",
            "bids",
            List.of("bids", "cycle", "random"),
            "Who goes where: the one to which it is worth most, by how long nobody was there and how far it is; each"
                    + " along all places in their order; or each anywhere.");
    static final Parameter<Double> URGENCY = Parameter.number(
            "urgency",
            0.5,
            0,
            100,
            "m/s",
            "With bids: how much longer a path may be for each second that nobody was at a place.");

    public Patrol() {
        super(
                "patrol",
                "Has a team watch places, so that none is left alone for long.",
                List.of(PLACES, COUNT, PlaceQuest.CLEARANCE, STAY_TIME, STRATEGY, URGENCY, Alarms.RESPONDERS),
                List.of());
    }

    @Override
    protected void begin(AgentContext self, Arguments arguments) {
        new PatrolMonitor(self, arguments).begin();
    }
}
