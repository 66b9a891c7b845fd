package rsal.agents;

import java.util.ArrayList;
import java.util.List;
import rsal.agent.Agent;
import rsal.agent.AgentContext;
import rsal.agent.AgentType;
import rsal.agent.presence.Presence;
import rsal.agent.team.Worker;
import rsal.device.Device;
import rsal.device.Navigator;
import rsal.device.Planner;
import rsal.robot.Robot;
import rsal.settings.Arguments;
import rsal.settings.Parameter;

/// A member of a team: bids for what the team has to do and does what it gets. Its battery comes first, then driving
/// where it is told.
public final class WorkerAgent implements Agent {
    private static final double NEAR = 0.5; // m, of a place

    private final Arguments arguments;

    WorkerAgent(Arguments arguments) {
        this.arguments = arguments;
    }

    @Override
    public void start(AgentContext self) {
        Robot robot = Body.of(self);
        var driver = new Driver(self, robot.require(Navigator.class));
        var reporter = new Reporter(self, robot, arguments, _ -> {});
        var ways = new PlannedWays(robot.find(Planner.class), NEAR);
        var worker = new Worker(self, ways, reporter::mapFromBase, now -> {
            if (now.job().isEmpty()) {
                self.state("waiting for a job");
            }
        });
        worker.learn(Visit.class, new Visiting(self, robot.id(), driver));
        var errands = new Errands(self, robot.id(), driver, () -> worker.unfit("on an errand"), worker::fit);
        new Recharging(
                        self,
                        robot,
                        driver,
                        reporter::mapFromBase,
                        arguments,
                        () -> worker.unfit("charging"),
                        worker::fit)
                .begin();
        errands.begin();
        reporter.begin();
        Travel.begin(self, robot, reporter);
        PlaceSearch.begin(self, robot, reporter);
        worker.begin();
        Presence.begin(self);
        self.state("waiting for a job");
    }

    @Override
    public void stop(AgentContext self) {
        Presence.end(self);
    }

    public static final class Type implements AgentType {
        @Override
        public String key() {
            return "worker";
        }

        @Override
        public String description() {
            return "Bids for what its team has to do, does what it gets, and minds its battery.";
        }

        @Override
        public List<Parameter> parameters() {
            var parameters = new ArrayList<>(Recharging.PARAMETERS);
            parameters.add(Reporter.PERIOD);
            return parameters;
        }

        @Override
        public List<Class<? extends Device>> needs() {
            return List.of(Navigator.class);
        }

        @Override
        public Agent create(Arguments arguments) {
            return new WorkerAgent(arguments);
        }
    }
}
