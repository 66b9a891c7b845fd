package rsal.agents;

import java.util.List;
import rsal.agent.Agent;
import rsal.agent.AgentContext;
import rsal.agent.AgentType;
import rsal.behavior.Pilot;
import rsal.device.Device;
import rsal.robot.Robot;
import rsal.settings.Arguments;
import rsal.settings.Parameter;

/// Drives about without a plan and says where it is. Driving where it is told comes first.
public final class Wander implements Agent {
    private final Arguments arguments;

    Wander(Arguments arguments) {
        this.arguments = arguments;
    }

    @Override
    public void start(AgentContext self) {
        Robot robot = Body.of(self);
        Roaming.anywhere(self, robot).begin();
        new Reporter(self, robot, arguments, _ -> {}).begin();
        Presence.begin(self);
    }

    @Override
    public void stop(AgentContext self) {
        Presence.end(self);
    }

    public static final class Type implements AgentType {
        @Override
        public String key() {
            return "wander";
        }

        @Override
        public String description() {
            return "Drives about, around all that is in its way, and says where it is.";
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
            return new Wander(arguments);
        }
    }
}
