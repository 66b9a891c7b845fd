package rsal.agents.patrol;

import java.util.List;
import java.util.ServiceLoader;
import rsal.agent.AgentContext;
import rsal.agents.driving.PlaceQuest;
import rsal.agents.parts.AgentTypeBase;
import rsal.agents.patrol.strategy.PatrolStrategyType;
import rsal.data.Point2d;
import rsal.settings.Arguments;
import rsal.settings.Parameter;
import rsal.settings.PluginChoice;
import rsal.settings.PluginKind;

/// Has a team watch places for ever, so that none is left alone for long. Needs no robot.
public final class Patrol extends AgentTypeBase {
    static final Parameter<List<Point2d>> PLACES =
            Parameter.places("places", "Places to watch. Default: a robot with a device of type 'places' finds them.");
    static final Parameter<Integer> COUNT = Parameter.integer("count", 12, 1, 1000, "", "Number of places to find.");
    static final Parameter<Double> STAY_TIME =
            Parameter.number("stayTime", 0, 0, 600, "s", "Time for which a robot stands at a place.");
    static final Parameter<PluginChoice> STRATEGY = Parameter.plugin(
            "strategy",
            "balanced",
            PluginKind.of("patrolStrategy", PatrolStrategyType.class, ServiceLoader.load(PatrolStrategyType.class)),
            "decides where each robot goes next");

    public Patrol() {
        super(
                "patrol",
                "Lets a team visit places again and again, so that no place is unvisited for long.",
                List.of(PLACES, COUNT, PlaceQuest.CLEARANCE, STAY_TIME, STRATEGY, Alarms.RESPONDERS),
                List.of());
    }

    @Override
    protected void begin(AgentContext self, Arguments arguments) {
        new PatrolMonitor(self, arguments).begin();
    }
}
