package rsal.agents;

import java.util.List;
import java.util.function.BiFunction;
import rsal.agent.Agent;
import rsal.agent.AgentContext;
import rsal.agent.AgentType;
import rsal.agent.presence.Presence;
import rsal.behavior.Pilot;
import rsal.device.Device;
import rsal.robot.Robot;
import rsal.settings.Arguments;
import rsal.settings.Parameter;

/// Drives about by a behavior and says where it is. Driving where it is told comes first.
public final class Roamer implements Agent {
    private final Arguments arguments;
    private final BiFunction<AgentContext, Robot, Roaming> roaming;

    private Roamer(Arguments arguments, BiFunction<AgentContext, Robot, Roaming> roaming) {
        this.arguments = arguments;
        this.roaming = roaming;
    }

    @Override
    public void start(AgentContext self) {
        Robot robot = Body.of(self);
        roaming.apply(self, robot).begin();
        new Reporter(self, robot, arguments, _ -> {}).begin();
        Presence.begin(self);
    }

    @Override
    public void stop(AgentContext self) {
        Presence.end(self);
    }

    /// Follows the wall on its left.
    public static final class WallFollow extends Type {
        public WallFollow() {
            super("wall-follow", "Follows the wall on its left and says where it is.", Roaming::alongWalls);
        }
    }

    /// Drives about without a plan.
    public static final class Wander extends Type {
        public Wander() {
            super("wander", "Drives about, around all that is in its way, and says where it is.", Roaming::anywhere);
        }
    }

    abstract static class Type implements AgentType {
        private final String key;
        private final String description;
        private final BiFunction<AgentContext, Robot, Roaming> roaming;

        Type(String key, String description, BiFunction<AgentContext, Robot, Roaming> roaming) {
            this.key = key;
            this.description = description;
            this.roaming = roaming;
        }

        @Override
        public String key() {
            return key;
        }

        @Override
        public String description() {
            return description;
        }

        @Override
        public List<Parameter> parameters() {
            return List.of(Reporter.PERIOD);
        }

        @Override
        public List<Class<? extends Device>> needs() {
            return List.of(Pilot.class);
        }

        @Override
        public Agent create(Arguments arguments) {
            return new Roamer(arguments, roaming);
        }
    }
}
