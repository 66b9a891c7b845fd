package rsal.agents.team;

import java.util.List;
import java.util.Optional;
import rsal.agent.AgentContext;
import rsal.agent.team.PathCostEstimator;
import rsal.agent.team.Worker;
import rsal.agents.charging.Recharging;
import rsal.agents.driving.GoalService;
import rsal.agents.driving.NavigationClient;
import rsal.agents.driving.PathCostService;
import rsal.agents.driving.PlaceSearch;
import rsal.agents.driving.PlannedPaths;
import rsal.agents.exploration.Chart;
import rsal.agents.exploration.Charting;
import rsal.agents.foraging.Spotting;
import rsal.agents.parts.AgentTypeBase;
import rsal.agents.parts.PoseReporter;
import rsal.agents.parts.RequiredRobot;
import rsal.agents.patrol.IntruderDetector;
import rsal.agents.patrol.Meet;
import rsal.agents.patrol.Meeting;
import rsal.agents.patrol.PatrolMember;
import rsal.agents.patrol.Visit;
import rsal.agents.patrol.Visiting;
import rsal.device.BlobFinder;
import rsal.device.Device;
import rsal.device.Mapper;
import rsal.device.Navigator;
import rsal.device.Planner;
import rsal.robot.Robot;
import rsal.settings.Arguments;

/// A member of a team: bids for what the team has to do and does what it gets. Its battery comes first, then driving
/// where it is told.
public final class WorkerAgent extends AgentTypeBase {
    private static final double NEAR = 0.5; // m, of a place

    public WorkerAgent() {
        super(
                "worker",
                "Bids for tasks of its team, executes those that it wins, and monitors its battery.",
                List.of(
                        Recharging.CHARGERS,
                        Recharging.LOW,
                        Recharging.FULL,
                        IntruderDetector.INTRUDER,
                        PoseReporter.PERIOD),
                List.of(Navigator.class));
    }

    @Override
    protected List<Class<? extends Device>> needsBesides(Arguments arguments) {
        return arguments.get(IntruderDetector.INTRUDER).isEmpty() ? List.of() : List.of(BlobFinder.class);
    }

    @Override
    protected void begin(AgentContext self, Arguments arguments) {
        Robot robot = RequiredRobot.of(self);
        var driver = new NavigationClient(self, robot.require(Navigator.class));
        var reporter = new PoseReporter(self, robot, arguments, _ -> {});
        Optional<Charting> charting =
                robot.find(Mapper.class).map(mapper -> new Charting(self, robot.id(), driver, mapper));
        var planned = new PlannedPaths(robot.find(Planner.class), NEAR);
        PathCostEstimator pathCosts =
                charting.map(skill -> skill.pathCosts(planned)).orElse(planned);
        var patrol = new PatrolMember(self, robot.id(), driver, reporter::mapFromBase, planned);
        var worker = new Worker(self, pathCosts, reporter::mapFromBase, now -> {
            if (now.job().isEmpty()) {
                self.state("waiting for a job");
            }
            patrol.idle(now.job().isEmpty());
        });
        worker.learn(Visit.class, new Visiting(self, robot.id(), driver));
        var meeting = new Meeting(self, driver, reporter::mapFromBase);
        worker.learn(Meet.class, meeting);
        charting.ifPresent(skill -> {
            worker.learn(Chart.class, skill);
            skill.begin();
        });
        var recharging = new Recharging(
                self,
                robot,
                driver,
                reporter::mapFromBase,
                arguments,
                () -> true,
                () -> {
                    patrol.fit(false);
                    worker.unfit("charging");
                },
                () -> {
                    worker.fit();
                    patrol.fit(true);
                });
        Runnable beforeGoal = () -> {
            patrol.fit(false);
            worker.unfit("on an errand");
        };
        var goals = new GoalService(self, robot.id(), driver, beforeGoal, () -> {
            if (recharging.isCharging()) {
                worker.unfit("charging");
            } else {
                worker.fit();
                patrol.fit(true);
            }
        });
        recharging.begin();
        goals.begin();
        reporter.begin();
        PathCostService.begin(self, robot, reporter);
        PlaceSearch.begin(self, robot, reporter);
        Spotting.color(arguments, IntruderDetector.INTRUDER)
                .ifPresent(color -> new IntruderDetector(self, robot, reporter, color, meeting::see).begin());
        worker.begin();
        patrol.begin();
        self.state("waiting for a job");
    }
}
