package rsal.agents;

import java.util.List;
import rsal.agent.Agent;
import rsal.agent.AgentContext;
import rsal.agent.AgentType;
import rsal.agent.presence.Presence;
import rsal.device.Device;
import rsal.device.Navigator;
import rsal.robot.Robot;
import rsal.settings.Arguments;
import rsal.settings.Parameter;

/// Drives where it is told and says where it is.
public final class Nav implements Agent {
    private final Arguments arguments;

    Nav(Arguments arguments) {
        this.arguments = arguments;
    }

    @Override
    public void start(AgentContext self) {
        Robot robot = Body.of(self);
        var driver = new Driver(self, robot.require(Navigator.class));
        new Errands(self, robot.id(), driver, () -> {}, () -> {}).begin();
        var reporter = new Reporter(self, robot, arguments, _ -> {});
        reporter.begin();
        Travel.begin(self, robot, reporter);
        PlaceSearch.begin(self, robot, reporter);
        Presence.begin(self);
        self.state("waiting for a goal");
    }

    @Override
    public void stop(AgentContext self) {
        Presence.end(self);
    }

    public static final class Type implements AgentType {
        @Override
        public String key() {
            return "nav";
        }

        @Override
        public String description() {
            return "Drives where it is told, says where it is and when it has arrived.";
        }

        @Override
        public List<Parameter> parameters() {
            return List.of(Reporter.PERIOD);
        }

        @Override
        public List<Class<? extends Device>> needs() {
            return List.of(Navigator.class);
        }

        @Override
        public Agent create(Arguments arguments) {
            return new Nav(arguments);
        }
    }
}
