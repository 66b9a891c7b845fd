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

/// A clever prey: explores along walls, monitors its battery, and runs from hunters that it or other prey see, to where
/// these come last. Caught like any other.
public final class Evade extends AgentTypeBase {
    static final Parameter<Double> SENSING_RANGE = Parameter.number(
            "sensingRange",
            10,
            0,
            1000,
            "m",
            "Distance up to which it sees hunters, which it reports to the other prey.");
    static final Parameter<Double> FLEE_DISTANCE =
            Parameter.number("fleeDistance", 6, 0, 1000, "m", "It flees from hunters nearer than this.");

    public Evade() {
        super(
                "evade",
                "Clever prey: explores, recharges, and flees from hunters that it or other prey see.",
                List.of(
                        Escape.HUNTER,
                        Escape.CATCH_DISTANCE,
                        Escape.CATCHERS,
                        Escape.MOVEMENT,
                        MarkerSight.SEES,
                        SENSING_RANGE,
                        FLEE_DISTANCE,
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
