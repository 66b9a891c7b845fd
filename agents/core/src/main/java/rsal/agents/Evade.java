package rsal.agents;

import java.util.List;
import rsal.agent.Agent;
import rsal.agent.AgentContext;
import rsal.agent.AgentType;
import rsal.agent.presence.Presence;
import rsal.behavior.Pilot;
import rsal.device.Device;
import rsal.device.Navigator;
import rsal.device.Planner;
import rsal.settings.Arguments;
import rsal.settings.Parameter;

/// A clever prey: explores along walls, minds its battery, and runs from hunters that it or other prey see, where these
/// get much later than it does. Caught like any other.
public final class Evade implements Agent {
    static final Parameter SIGHT =
            Parameter.number("sight", 10, 0, 1000, "m", "How far it sees hunters, and tells the other prey of them.");
    static final Parameter FEAR = Parameter.number("fear", 6, 0, 1000, "m", "It runs from hunters nearer than this.");

    private final Arguments arguments;

    Evade(Arguments arguments) {
        this.arguments = arguments;
    }

    @Override
    public void start(AgentContext self) {
        new Evader(self, Body.of(self), arguments).begin();
        Presence.begin(self);
    }

    @Override
    public void stop(AgentContext self) {
        Presence.end(self);
    }

    public static final class Type implements AgentType {
        @Override
        public String key() {
            return "evade";
        }

        @Override
        public String description() {
            return "Clever prey: explores, recharges, and runs from hunters that it or other prey see.";
        }

        @Override
        public List<Parameter> parameters() {
            return List.of(Escape.HUNTER, Escape.CATCH_DISTANCE, SIGHT, FEAR, Recharging.CHARGERS, Reporter.PERIOD);
        }

        @Override
        public List<Class<? extends Device>> needs() {
            return List.of(Pilot.class, Navigator.class, Planner.class);
        }

        @Override
        public Agent create(Arguments arguments) {
            return new Evade(arguments);
        }
    }
}
