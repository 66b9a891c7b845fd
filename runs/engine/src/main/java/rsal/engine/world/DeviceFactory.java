package rsal.engine.world;

import java.lang.System.Logger;
import java.lang.System.Logger.Level;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.SplittableRandom;
import java.util.function.Function;
import rsal.data.Pose2d;
import rsal.device.Device;
import rsal.device.DriveBase;
import rsal.device.Health;
import rsal.engine.arbitration.CommandArbiter;
import rsal.engine.arbitration.Teleoperation;
import rsal.engine.communication.RobotBreaker;
import rsal.engine.communication.RobotRadio;
import rsal.engine.event.EventLog;
import rsal.engine.report.Teammate;
import rsal.engine.report.Words;
import rsal.engine.robot.GuardedScheduler;
import rsal.engine.robot.RobotTeam;
import rsal.robot.DeviceDriver;
import rsal.robot.Robot;
import rsal.robot.RobotSpec;
import rsal.scenario.RunPlan;
import rsal.scenario.RunPlan.PlannedDevice;
import rsal.scenario.RunPlan.PlannedRobot;
import rsal.time.Scheduler;

/// Gives robots their software devices, and people a way to tell them what to do; journals how all of their devices
/// are. All calls on the run's thread.
public final class DeviceFactory implements AutoCloseable {
    private static final Logger LOG = System.getLogger(DeviceFactory.class.getName());

    private final RunPlan plan;
    private final Scheduler scheduler;
    private final EventLog eventLog;
    private final RobotBreaker breaker;
    private final SimulatedWorld world;
    private final RobotTeam team;
    private final RobotRadio radio;
    private final Function<RobotSpec, Overlay> overlays;
    private final Map<String, List<GuardedScheduler>> lanes = new HashMap<>(); // of software devices, by robot
    private boolean closed;

    /// @param radio by which devices of robots hear each other
    /// @param overlays by which real robots see what is simulated
    public DeviceFactory(
            RunPlan plan,
            Scheduler scheduler,
            EventLog eventLog,
            RobotBreaker breaker,
            SimulatedWorld world,
            RobotTeam team,
            RobotRadio radio,
            Function<RobotSpec, Overlay> overlays) {
        this.plan = plan;
        this.scheduler = scheduler;
        this.eventLog = eventLog;
        this.breaker = breaker;
        this.world = world;
        this.team = team;
        this.radio = radio;
        this.overlays = overlays;
    }

    /// Makes what was planned for a robot, which then is one of the team.
    ///
    /// @param bare as its system made it
    public void equip(Robot bare, PlannedRobot planned) {
        Optional<CommandArbiter> arbiter = bare.find(DriveBase.class).map(CommandArbiter::new);
        Robot robot = arbiter.map(own -> own.steering(bare, CommandArbiter.Source.AGENTS))
                .orElse(bare);
        if (planned.overlay()) {
            robot = overlays.apply(planned.spec()).over(robot);
        }
        Optional<Pose2d> start = planned.spec().mapFromBase();
        for (PlannedDevice device : planned.drivers()) {
            List<String> missing = missing(device, robot);
            if (missing.isEmpty()) {
                robot = robot.with(breaker.breakable(
                        make(device, robot, device.mapFromStart().or(() -> start))));
            } else {
                leaveOut(device, robot, missing);
            }
        }
        team.join(robot, teleoperation(robot, arbiter, planned), new Teammate(planned.spec(), world.body(robot.id())));
        robot.devices().forEach(this::watch);
    }

    /// Types of devices that it needs and the robot does not have: a real robot may lack what its model has.
    private static List<String> missing(PlannedDevice device, Robot robot) {
        return device.driver().needs().stream()
                .filter(need -> robot.find(need).isEmpty())
                .map(Class::getSimpleName)
                .toList();
    }

    private void leaveOut(PlannedDevice device, Robot robot, List<String> missing) {
        String what =
                "'%s' is left out, as the robot has no %s".formatted(device.name(), String.join(" and no ", missing));
        eventLog.event("device", robot.id(), what);
        LOG.log(Level.WARNING, () -> "Robot '%s': %s.".formatted(robot.id(), what));
    }

    private Optional<Teleoperation> teleoperation(Robot robot, Optional<CommandArbiter> arbiter, PlannedRobot planned) {
        Optional<Pose2d> start = planned.spec().mapFromBase();
        Teleoperation.Maker spares = (device, made) -> makeSpare(device, made, start);
        return arbiter.map(own -> new Teleoperation(robot, own, planned.spares(), spares, eventLog));
    }

    /// Makes a device in the middle of the run. It begins where the robot is now, as if somebody had placed it there.
    ///
    /// @param start where it was at first, for when nobody knows where it is now
    private Device makeSpare(PlannedDevice device, Robot robot, Optional<Pose2d> start) {
        Device made = make(device, robot, world.truth(robot.id()).or(() -> start));
        watch(made);
        return made;
    }

    private Device make(PlannedDevice device, Robot robot, Optional<Pose2d> mapFromBase) {
        String name = "Device '%s/%s'".formatted(robot.id(), device.name());
        var lane = new GuardedScheduler(name, scheduler);
        var context = new DeviceDriver.Context(
                device.name(),
                Overlay.asSeenBy(device.driver(), robot),
                plan.map(),
                mapFromBase,
                lane,
                new SplittableRandom(device.seed()),
                radio.link(robot.id(), lane::guarded));
        Device made = lane.making(() -> device.driver().create(context, device.options()));
        lanes.computeIfAbsent(robot.id(), _ -> new ArrayList<>()).add(lane);
        return made;
    }

    /// A device that has no connection from the beginning is an event, too.
    private void watch(Device device) {
        if (device.health() instanceof Health.Lost lost) {
            eventLog.event("health", device.info().id(), Words.of(lost));
        }
        device.onHealth(health -> {
            if (!closed && team.has(device.info().robot())) {
                eventLog.event("health", device.info().id(), Words.of(health));
            }
        });
    }

    /// A robot has left: its software devices do nothing any more.
    public void leave(String robot) {
        radio.leave(robot);
        Optional.ofNullable(lanes.remove(robot)).ifPresent(all -> all.forEach(GuardedScheduler::end));
    }

    /// Journals no more.
    @Override
    public void close() {
        closed = true;
    }
}
