package rsal.agents;

import java.util.List;
import rsal.agent.Agent;
import rsal.agent.AgentContext;
import rsal.agent.AgentType;
import rsal.agent.message.NewGoal;
import rsal.agent.presence.Presence;
import rsal.device.Device;
import rsal.settings.Arguments;
import rsal.settings.Parameter;

/// Keeps a team spread over places, given or found on the map: allots them exactly, by what the ways cost, and again
/// and again, as robots come, fall silent and are back. Needs no robot.
public final class Dispersion implements Agent {
    static final Parameter ROBOTS =
            Parameter.robots("robots", NewGoal.ALL, List.of(NewGoal.ALL), "Role of the robots to spread, or all.");
    static final Parameter PLACES = Parameter.places(
            "places",
            "Where they should be; those that are too many stay empty. None: they are found"
                    + " by a robot with a device of type (places).");
    static final Parameter COUNT =
            Parameter.integer("count", 0, 0, 10_000, "", "How many places to find; 0 for as many as there are robots.");
    static final Parameter CLEARANCE = Parameter.number(
            "clearance", 0.4, 0.05, 10, "m", "Least distance from places to find, and from ways to them, to walls.");
    static final Parameter PING_INTERVAL = Parameter.number(
            "pingInterval",
            30,
            0.5,
            3600,
            "s",
            "A robot of which nothing was heard for that long is asked; after three times that it counts as silent.");
    static final Parameter DISPERSION_INTERVAL = Parameter.number(
            "dispersionInterval",
            60,
            0,
            3600,
            "s",
            "How often places are allotted anew; 0 for only when the team changes.");

    private final Arguments arguments;

    Dispersion(Arguments arguments) {
        this.arguments = arguments;
    }

    @Override
    public void start(AgentContext self) {
        new Spreading(self, arguments).begin();
        Presence.begin(self);
    }

    @Override
    public void stop(AgentContext self) {
        Presence.end(self);
    }

    public static final class Type implements AgentType {
        @Override
        public String key() {
            return "dispersion";
        }

        @Override
        public String description() {
            return "Keeps a team spread over places, each robot at one that is near.";
        }

        @Override
        public List<Parameter> parameters() {
            return List.of(ROBOTS, PLACES, COUNT, CLEARANCE, PING_INTERVAL, DISPERSION_INTERVAL);
        }

        @Override
        public List<Class<? extends Device>> needs() {
            return List.of();
        }

        @Override
        public Agent create(Arguments arguments) {
            return new Dispersion(arguments);
        }
    }
}
