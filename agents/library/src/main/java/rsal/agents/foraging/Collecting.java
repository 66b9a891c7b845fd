package rsal.agents.foraging;

import java.time.Duration;
import java.util.List;
import java.util.Optional;
import org.jspecify.annotations.Nullable;
import rsal.agent.AgentContext;
import rsal.agent.team.Skill;
import rsal.agent.team.TaskRoute;
import rsal.agent.team.Work;
import rsal.agent.team.Worker;
import rsal.agents.charging.Recharging;
import rsal.agents.driving.NavigationClient;
import rsal.agents.driving.PlannedPaths;
import rsal.agents.parts.AgentWords;
import rsal.agents.parts.PoseReporter;
import rsal.data.Point2d;
import rsal.data.Pose2d;
import rsal.device.Navigator;
import rsal.device.Planner;
import rsal.robot.Robot;
import rsal.settings.Arguments;
import rsal.settings.Parameter;

/// What a robot with a gripper does for a team: it fetches things, one after the other, and brings them to its depot.
/// What its battery would not last for it does not take on.
final class Collecting implements Skill<Fetch> {
    static final Parameter<List<Point2d>> DEPOT = Parameter.places(
            "depot",
            "Depots to which it brings things: each thing to the nearest one. Default: its place 2 s after its start.");
    static final Parameter<Double> DEPOT_RADIUS = Parameter.number(
            "depotRadius", 1.5, 0.3, 10, "m", "Things within this distance of the depot are collected.");

    static final Duration SETTLING = Duration.ofSeconds(2);
    private static final Duration REPEAT = Duration.ofSeconds(4);
    private static final double NEAR = 0.5; // m, of a thing by a wall
    private static final double HANDLING = 6; // m that it could drive while it aims, grips and releases

    private final AgentContext self;
    private final Robot robot;
    private final PoseReporter reporter;
    private final NavigationClient driver;
    private final Recharging recharging;
    private final Worker worker;
    private final List<Point2d> given;
    private final double depotRadius;
    private final Depots depots;
    private @Nullable FetchTask task;

    Collecting(AgentContext self, Robot robot, PoseReporter reporter, Arguments arguments) {
        this.self = self;
        this.robot = robot;
        this.reporter = reporter;
        this.driver = new NavigationClient(self, robot.require(Navigator.class));
        this.worker =
                new Worker(self, new PlannedPaths(robot.find(Planner.class), NEAR), reporter::mapFromBase, _ -> {});
        this.recharging = new Recharging(
                self,
                robot,
                driver,
                reporter::mapFromBase,
                arguments,
                () -> task == null,
                () -> worker.unfit("charging"),
                this::beFit);
        double range = arguments.get(Recharging.RANGE);
        worker.learn(Fetch.class, this);
        worker.within(() -> recharging.reach(range));
        this.depotRadius = arguments.get(DEPOT_RADIUS);
        this.given = arguments.get(DEPOT);
        this.depots = new Depots(self);
    }

    void begin() {
        recharging.begin();
        self.state("waiting to know where it stands");
        if (given.isEmpty()) {
            self.scheduler().after(SETTLING, this::standHere);
        } else {
            settle(given);
        }
        self.scheduler().every(REPEAT, depots::publish);
    }

    private void standHere() {
        Optional<Pose2d> mapFromBase = reporter.mapFromBase();
        if (mapFromBase.isEmpty()) {
            self.scheduler().after(SETTLING, this::standHere);
            return;
        }
        settle(List.of(mapFromBase.get().position()));
    }

    private void settle(List<Point2d> mapFromDepots) {
        depots.settle(
                mapFromDepots.size() == 1 ? List.of(robot.id()) : Depots.numbered(robot.id(), mapFromDepots.size()),
                mapFromDepots,
                depotRadius);
        worker.begin();
        beFit();
        depots.publish();
    }

    private void beFit() {
        worker.fit();
        self.state("waiting for something to fetch");
    }

    @Override
    public Optional<TaskRoute> course(Fetch job) {
        Pose2d mapFromDepot = AgentWords.pose(depotFor(job));
        return Optional.of(new TaskRoute(
                task != null && task.isBringing()
                        ? mapFromDepot
                        : AgentWords.pose(job.goal().mapFromThing()),
                mapFromDepot,
                HANDLING));
    }

    private Point2d depotFor(Fetch job) {
        return depots.nearest(job.goal().mapFromThing()); // it takes no jobs before there is one
    }

    @Override
    public void begin(Fetch job, Work work) {
        Point2d mapFromDepot = depotFor(job);
        var begun = new FetchTask(
                self,
                robot,
                reporter,
                driver,
                job.goal(),
                mapFromDepot,
                why -> self.scheduler().execute(() -> ended(job, mapFromDepot, work, why)));
        task = begun;
        work.onEnd(() -> drop(begun));
        begun.begin();
    }

    /// What it holds it brings all the same, and does nothing else meanwhile.
    private void drop(FetchTask dropped) {
        if (task == dropped) {
            worker.unfit("bringing what nobody asks for any more");
            dropped.drop();
        }
    }

    private void ended(Fetch job, Point2d mapFromDepot, Work work, Optional<String> why) {
        task = null;
        if (why.isEmpty()) {
            self.publish(Collected.TOPIC, new Collected(robot.id(), job.goal(), mapFromDepot));
            self.state("has collected " + job.goal());
            work.done("brought to %s".formatted(AgentWords.place(AgentWords.pose(mapFromDepot))));
        } else {
            self.state("has not collected %s: %s".formatted(job.goal(), why.get()));
            work.fail(why.get());
        }
        if (recharging.isNeeded()) {
            worker.unfit("charging"); // before it gets the next job
        } else {
            worker.fit();
        }
    }
}
