package rsal.agents;

import java.util.List;
import rsal.agent.Agent;
import rsal.agent.AgentContext;
import rsal.agent.AgentType;
import rsal.agent.presence.Presence;
import rsal.device.Device;
import rsal.device.Navigator;
import rsal.settings.Arguments;
import rsal.settings.Parameter;

/// A hunter: goes for the newest pose of a prey until that has been caught, then for the next. Driving where it is
/// told comes first.
public final class Follow implements Agent {
    static final Parameter PREY =
            Parameter.robots("prey", "prey", List.of(), "Role of the robots to hunt, or id of the one.");
    static final Parameter CATCH_DISTANCE =
            Parameter.number("catchDistance", 2.0, 0.1, 100, "m", "It stops when nearer to its prey than this.");
    static final Parameter UPDATE_INTERVAL =
            Parameter.number("updateInterval", 2.0, 0.1, 600, "s", "How often it goes for the prey's newest pose.");
    static final Parameter ASSIGNMENT = Parameter.choice(
            "assignment",
            "fixed",
            List.of("fixed", "nearest", "bids"),
            "How hunters divide several prey: in turn, once and for all; each time with the least distance for all; or"
                    + " as an agent of type (hunt) allots them by what hunters bid.");

    private final Arguments arguments;

    Follow(Arguments arguments) {
        this.arguments = arguments;
    }

    @Override
    public void start(AgentContext self) {
        if (arguments.text(ASSIGNMENT.name()).equals("bids")) {
            new Hunter(self, Body.of(self), arguments).begin();
        } else {
            new Hunt(self, Body.of(self), arguments).begin();
        }
        Presence.begin(self);
    }

    @Override
    public void stop(AgentContext self) {
        Presence.end(self);
    }

    public static final class Type implements AgentType {
        @Override
        public String key() {
            return "follow";
        }

        @Override
        public String description() {
            return "Hunts: goes for the newest pose of a prey until it has been caught.";
        }

        @Override
        public List<Parameter> parameters() {
            return List.of(PREY, CATCH_DISTANCE, UPDATE_INTERVAL, ASSIGNMENT, Reporter.PERIOD);
        }

        @Override
        public List<Class<? extends Device>> needs() {
            return List.of(Navigator.class);
        }

        @Override
        public Agent create(Arguments arguments) {
            return new Follow(arguments);
        }
    }
}
