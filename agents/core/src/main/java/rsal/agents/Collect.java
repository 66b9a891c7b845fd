package rsal.agents;

import java.util.List;
import rsal.agent.Agent;
import rsal.agent.AgentContext;
import rsal.agent.AgentType;
import rsal.agent.presence.Presence;
import rsal.behavior.Pilot;
import rsal.device.BlobFinder;
import rsal.device.Device;
import rsal.device.Gripper;
import rsal.device.Navigator;
import rsal.robot.Robot;
import rsal.settings.Arguments;
import rsal.settings.Parameter;

/// Collects things that others have found.
public final class Collect implements Agent {
    private final Arguments arguments;

    Collect(Arguments arguments) {
        this.arguments = arguments;
    }

    @Override
    public void start(AgentContext self) {
        Robot robot = Body.of(self);
        var reporter = new Reporter(self, robot, arguments, _ -> {});
        reporter.begin();
        new Collecting(self, robot, reporter, arguments).begin();
        Presence.begin(self);
    }

    @Override
    public void stop(AgentContext self) {
        Presence.end(self);
    }

    public static final class Type implements AgentType {
        @Override
        public String key() {
            return "collect";
        }

        @Override
        public String description() {
            return "Fetches things that others have found, and brings them to its depot.";
        }

        @Override
        public List<Parameter> parameters() {
            return List.of(
                    Reporter.PERIOD,
                    Collecting.DEPOT,
                    Collecting.DEPOT_RADIUS,
                    Collecting.QUEUE,
                    Recharging.CHARGERS,
                    Recharging.LOW,
                    Recharging.FULL,
                    Recharging.RANGE);
        }

        @Override
        public List<Class<? extends Device>> needs() {
            return List.of(Navigator.class, Gripper.class, BlobFinder.class, Pilot.class);
        }

        @Override
        public Agent create(Arguments arguments) {
            return new Collect(arguments);
        }
    }
}
