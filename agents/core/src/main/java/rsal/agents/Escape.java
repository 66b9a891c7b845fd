package rsal.agents;

import java.util.List;
import rsal.agent.Agent;
import rsal.agent.AgentContext;
import rsal.agent.AgentType;
import rsal.agent.presence.Presence;
import rsal.behavior.Pilot;
import rsal.device.Device;
import rsal.settings.Arguments;
import rsal.settings.Parameter;

/// A prey: follows the wall on its left and says where it is, until a hunter comes too near. Then it gives up and
/// spins on the spot.
public final class Escape implements Agent {
    static final Parameter HUNTER = Parameter.robots(
            "hunter",
            "",
            List.of(""),
            "Role of the robots that catch it, or id of the one; empty when any other robot does.");
    static final Parameter CATCH_DISTANCE =
            Parameter.number("catchDistance", 2.0, 0.1, 100, "m", "It is caught when a hunter is nearer than this.");

    private final Arguments arguments;

    Escape(Arguments arguments) {
        this.arguments = arguments;
    }

    @Override
    public void start(AgentContext self) {
        new Prey(self, Body.of(self), arguments).begin();
        Presence.begin(self);
    }

    @Override
    public void stop(AgentContext self) {
        Presence.end(self);
    }

    public static final class Type implements AgentType {
        @Override
        public String key() {
            return "escape";
        }

        @Override
        public String description() {
            return "Prey: follows the wall on its left until a hunter comes too near, then gives up.";
        }

        @Override
        public List<Parameter> parameters() {
            return List.of(HUNTER, CATCH_DISTANCE, Reporter.PERIOD);
        }

        @Override
        public List<Class<? extends Device>> needs() {
            return List.of(Pilot.class);
        }

        @Override
        public Agent create(Arguments arguments) {
            return new Escape(arguments);
        }
    }
}
