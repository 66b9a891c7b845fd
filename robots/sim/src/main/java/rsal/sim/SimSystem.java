package rsal.sim;

import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionStage;
import java.util.function.Consumer;
import org.jspecify.annotations.Nullable;
import rsal.device.Health;
import rsal.device.Listeners;
import rsal.device.SimulationControl;
import rsal.device.Subscription;
import rsal.fault.FaultInjection;
import rsal.robot.Robot;
import rsal.robot.RobotSpec;
import rsal.scene.Touch;
import rsal.sim.world.World;
import rsal.system.RobotSystem;
import rsal.time.Phase;
import rsal.time.Scheduler;
import rsal.time.Task;

/// The simulated world, step by step, each in a fixed order: the newest commands take effect and the robots move,
/// one after the other by id; then their sensors look at where all are now; then their devices tell, again by id.
///
/// What feels or moves on a robot works in between, when all have moved. Sensors look in parallel where that
/// pays, those of robots near each other one after the other ([NeighborOrder]). They see a still picture of the world
/// and draw from random streams of their own, so that the readings do not depend on it.
final class SimSystem implements RobotSystem {
    private static final int WORTH_A_TASK = 1000; // rays

    private final Scheduler scheduler;
    private final Duration step;
    private final World world;
    private final Touch touch;
    private final SimulatedRobots team;
    private final ContactTracker touches = new ContactTracker();
    private final Listeners<Change> changes = new Listeners<>(e -> {
        throw e;
    });
    private final EnergyTransfer charging;
    private final SimControl control;
    private final Absence absence;
    private final SimFaults faults;
    private final NeighborOrder<SimRobot> neighbors =
            new NeighborOrder<>(robot -> robot.body().pose());
    private @Nullable Task stepping;
    private boolean looking;
    private boolean closed;

    SimSystem(
            Scheduler scheduler,
            Duration step,
            World world,
            Touch touch,
            Things things,
            List<SimRobot> robots,
            RobotSpawner recruiting) {
        this.scheduler = scheduler;
        this.step = step;
        this.world = world;
        this.touch = touch;
        this.team = new SimulatedRobots(robots);
        this.charging = new EnergyTransfer(team, things);
        this.control = new SimControl(world, things, team, recruiting, touches, changes::publish);
        this.absence = new Absence(world, team, touches, changes::publish);
        this.faults = new SimFaults(team, absence);
    }

    @Override
    public CompletionStage<List<Robot>> discover() {
        if (closed) {
            return CompletableFuture.failedStage(new IllegalStateException("This simulation is closed."));
        }
        if (stepping == null) {
            stepping = scheduler.every(step, Phase.WORLD, this::step);
        }
        return CompletableFuture.completedStage(
                team.robots().stream().map(SimRobot::robot).toList());
    }

    /// Simulated robots come and go by [SimulationControl] and by faults.
    @Override
    public Subscription onChange(Consumer<? super Change> listener) {
        return changes.add(listener);
    }

    @Override
    public Optional<SimulationControl> simulation() {
        return Optional.of(control);
    }

    @Override
    public SimulationControl.Placement addRobot(RobotSpec robot) {
        return control.addRobot(robot);
    }

    @Override
    public Optional<FaultInjection> faults() {
        return Optional.of(faults);
    }

    private void step() {
        Instant now = scheduler.instant();
        double dt = step.toNanos() * 1e-9;
        absence.retry();
        for (SimRobot robot : team.robots()) {
            if (!robot.move(world, dt, touch)) {
                touches.ranInto(robot.body(), world.obstacle(), now);
            }
        }
        touches.update(world);
        charging.step(world, dt);
        forEach(
                team.workers(),
                team.changes(),
                robot -> robot.work(now, dt, other -> touches.ranInto(robot.body(), other, now)));
        if (!looking) { // real time may be too fast for them
            world.look();
            look(now);
        }
    }

    /// Does something with each robot, but with none that has gone meanwhile: a listener may take
    /// others out of the world.
    ///
    /// @param since [SimulatedRobots#changes] when they were all there
    private void forEach(List<SimRobot> robots, int since, Consumer<SimRobot> work) {
        for (SimRobot robot : robots) {
            if (team.changes() == since || team.has(robot)) {
                work.accept(robot);
            }
        }
    }

    private void look(Instant now) {
        List<SimRobot> robots = team.robots();
        for (SimRobot robot : robots) {
            robot.lookFromHere();
        }
        int since = team.changes();
        List<List<SimRobot>> turns = tasks(robots, now);
        boolean many = turns.size() > 1; // else the one task looks and tells, with no other to wait for
        looking = true;
        world.watched(true);
        CompletionStage<List<SimRobot>> last = CompletableFuture.completedStage(List.of());
        for (List<SimRobot> some : many ? tasks(neighbors.order(robots, since), now) : List.<List<SimRobot>>of()) {
            last = last.thenCombine(scheduler.compute(() -> looked(some, now)), (_, done) -> done);
        }
        for (List<SimRobot> some : turns) { // work of their own, so that all that these set off comes before the next
            last = last.thenCombine(scheduler.compute(() -> many ? some : looked(some, now)), (_, told) -> {
                forEach(told, since, robot -> report(robot, now));
                return told;
            });
        }
        last.whenComplete((_, error) -> {
            looking = false;
            world.watched(false);
            if (error != null) {
                scheduler.execute(() -> {
                    throw new IllegalStateException("Simulated sensors failed.", error);
                });
            }
        });
    }

    /// Robots one after the other, as many together as cast so many rays that it is worth a task.
    private static List<List<SimRobot>> tasks(List<SimRobot> robots, Instant now) {
        var tasks = new ArrayList<List<SimRobot>>();
        int first = 0;
        int rays = 0;
        for (int i = 0; i < robots.size(); i++) {
            rays += robots.get(i).raysDue(now);
            if (rays >= WORTH_A_TASK || i == robots.size() - 1) {
                tasks.add(robots.subList(first, i + 1));
                first = i + 1;
                rays = 0;
            }
        }
        return tasks;
    }

    private List<SimRobot> looked(List<SimRobot> some, Instant now) {
        for (SimRobot robot : some) {
            robot.look(world, now);
        }
        return some;
    }

    private void report(SimRobot robot, Instant now) {
        if (!closed) {
            robot.report(now);
        }
    }

    @Override
    public void close() {
        if (!closed) {
            closed = true;
            if (stepping != null) {
                stepping.cancel();
            }
            var why = new Health.Lost("The simulation was closed.");
            team.all().forEach(robot -> robot.close(why));
            control.close(why);
        }
    }
}
