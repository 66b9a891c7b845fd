package rsal.agents;

import java.util.List;
import rsal.agent.AgentContext;
import rsal.behavior.Pilot;
import rsal.device.Device;
import rsal.settings.Arguments;
import rsal.settings.Parameter;

/// A prey: follows the wall on its left and says where it is, until a hunter comes too near. Then it gives up and
/// spins on the spot.
public final class Escape extends AgentTypeBase {
    static final Parameter HUNTER = Parameter.robots(
            "hunter",
            "",
            List.of(""),
            "Role of the robots that catch it, or id of the one; empty when any other robot does.");
    /// The thesis has 1.5 m, which hunters that stop 2 m away do not come to: so the same as theirs.
    static final Parameter CATCH_DISTANCE =
            Parameter.number("catchDistance", 2.0, 0.1, 100, "m", "It is caught when a hunter is nearer than this.");

    public Escape() {
        super(
                "escape",
                "Prey: follows the wall on its left until a hunter comes too near, then gives up.",
                List.of(HUNTER, CATCH_DISTANCE, Sight.SEES, Reporter.PERIOD),
                List.of(Pilot.class));
    }

    @Override
    List<Class<? extends Device>> needsBesides(Arguments arguments) {
        return Sight.needs(arguments);
    }

    @Override
    void begin(AgentContext self, Arguments arguments) {
        new Prey(self, Body.of(self), arguments).begin();
    }
}
