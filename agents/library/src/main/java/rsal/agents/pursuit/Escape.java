package rsal.agents.pursuit;

import java.util.List;
import rsal.agent.AgentContext;
import rsal.agents.parts.AgentTypeBase;
import rsal.agents.parts.PoseReporter;
import rsal.agents.parts.RequiredRobot;
import rsal.behavior.Pilot;
import rsal.device.Device;
import rsal.settings.Arguments;
import rsal.settings.Parameter;

/// A prey: follows the wall on its left and says where it is, until a hunter comes too near. Then it gives up and
/// spins on the spot.
public final class Escape extends AgentTypeBase {
    public static final Parameter<String> HUNTER = Parameter.robots(
            "hunter", "", List.of(""), "Role of the robots that catch it, or id of one robot; empty: any other robot.");
    /// The thesis has 1.5 m, which hunters that stop 2 m away do not come to: so the same as theirs.
    public static final Parameter<Double> CATCH_DISTANCE =
            Parameter.number("catchDistance", 2.0, 0.1, 100, "m", "It is caught when a hunter is nearer than this.");

    static final Parameter<Integer> CATCHERS = Parameter.integer(
            "catchers",
            1,
            1,
            10,
            "",
            "It is caught when so many hunters are nearer than 'catchDistance' at once, in its line of sight.");
    private static final String WANDER = "wander";
    static final Parameter<String> MOVEMENT = Parameter.choice(
            "movement",
            "follow-wall",
            List.of("follow-wall", WANDER),
            "How it drives while it does not flee: along the wall on its left, or straight on and away from obstacles at random.");

    public Escape() {
        super(
                "escape",
                "Prey: follows the wall on its left until a hunter comes too near, then gives up.",
                List.of(HUNTER, CATCH_DISTANCE, CATCHERS, MOVEMENT, MarkerSight.SEES, PoseReporter.PERIOD),
                List.of(Pilot.class));
    }

    /// Whether one with such arguments drives at random while it does not flee.
    static boolean wanders(Arguments arguments) {
        return arguments.get(MOVEMENT).equals(WANDER);
    }

    @Override
    protected List<Class<? extends Device>> needsBesides(Arguments arguments) {
        return MarkerSight.needs(arguments);
    }

    @Override
    protected void begin(AgentContext self, Arguments arguments) {
        new Prey(self, RequiredRobot.of(self), arguments).begin();
    }
}
