package rsal.agents;

import java.util.List;
import rsal.agent.Agent;
import rsal.agent.AgentContext;
import rsal.agent.AgentType;
import rsal.agent.presence.Presence;
import rsal.device.Device;
import rsal.settings.Arguments;
import rsal.settings.Parameter;

/// Has a team watch places for ever, so that none is left alone for long. Needs no robot.
public final class Patrol implements Agent {
    static final Parameter PLACES = Parameter.places(
            "places", "Which places to watch. None: they are found by a robot with a device of type (places).");
    static final Parameter COUNT = Parameter.integer("count", 12, 1, 1000, "", "How many places to find.");
    static final Parameter CLEARANCE = Parameter.number(
            "clearance", 0.4, 0.05, 10, "m", "Least distance from places to find, and from ways to them, to walls.");
    static final Parameter STAY = Parameter.number("stay", 0, 0, 600, "s", "How long a robot stands at a place.");
    static final Parameter STRATEGY = Parameter.choice(
            "strategy",
            "bids",
            List.of("bids", "cycle", "random"),
            "Who goes where: the one to which it is worth most, by how long nobody was there and how far it is; each"
                    + " along all places in their order; or each anywhere.");
    static final Parameter URGENCY = Parameter.number(
            "urgency",
            0.5,
            0,
            100,
            "m/s",
            "With bids: how much longer a way may be for each second that nobody was at a place.");

    private final Arguments arguments;

    Patrol(Arguments arguments) {
        this.arguments = arguments;
    }

    @Override
    public void start(AgentContext self) {
        new Watching(self, arguments).begin();
        Presence.begin(self);
    }

    @Override
    public void stop(AgentContext self) {
        Presence.end(self);
    }

    public static final class Type implements AgentType {
        @Override
        public String key() {
            return "patrol";
        }

        @Override
        public String description() {
            return "Has a team watch places, so that none is left alone for long.";
        }

        @Override
        public List<Parameter> parameters() {
            return List.of(PLACES, COUNT, CLEARANCE, STAY, STRATEGY, URGENCY);
        }

        @Override
        public List<Class<? extends Device>> needs() {
            return List.of();
        }

        @Override
        public Agent create(Arguments arguments) {
            return new Patrol(arguments);
        }
    }
}
