package rsal.agents.pursuit;

import java.util.List;
import rsal.agent.AgentContext;
import rsal.agents.charging.Recharging;
import rsal.agents.parts.AgentTypeBase;
import rsal.agents.parts.PoseReporter;
import rsal.agents.parts.RequiredRobot;
import rsal.behavior.Pilot;
import rsal.device.Device;
import rsal.device.Navigator;
import rsal.device.Planner;
import rsal.settings.Arguments;
import rsal.settings.Parameter;

/// A clever prey: explores along walls, minds its battery, and runs from hunters that it or other prey see, where these
/// get much later than it does. Caught like any other.
public final class Evade extends AgentTypeBase {
    static final Parameter<Double> SIGHT =
            Parameter.number("sight", 10, 0, 1000, "m", "How far it sees hunters, and tells the other prey of them.");
    static final Parameter<Double> FEAR =
            Parameter.number("fear", 6, 0, 1000, "m", "It runs from hunters nearer than this.");

    public Evade() {
        super(
                "evade",
                "Clever prey: explores, recharges, and runs from hunters that it or other prey see.",
                List.of(
                        Escape.HUNTER,
                        Escape.CATCH_DISTANCE,
                        MarkerSight.SEES,
                        SIGHT,
                        FEAR,
                        Recharging.CHARGERS,
                        PoseReporter.PERIOD),
                List.of(Pilot.class, Navigator.class, Planner.class));
    }

    @Override
    protected List<Class<? extends Device>> needsBesides(Arguments arguments) {
        return MarkerSight.needs(arguments);
    }

    @Override
    protected void begin(AgentContext self, Arguments arguments) {
        new Evader(self, RequiredRobot.of(self), arguments).begin();
    }
}
