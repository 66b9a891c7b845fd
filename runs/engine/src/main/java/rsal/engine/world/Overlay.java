package rsal.engine.world;

import java.time.Duration;
import java.time.Instant;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.function.Supplier;
import org.jspecify.annotations.Nullable;
import rsal.data.Fan;
import rsal.data.Pose2d;
import rsal.data.Stamped;
import rsal.device.Device;
import rsal.device.LaserScanner;
import rsal.device.Localizer;
import rsal.device.Mapper;
import rsal.device.SimulationControl;
import rsal.device.SonarArray;
import rsal.engine.event.EventLog;
import rsal.robot.DeviceDriver;
import rsal.robot.Robot;
import rsal.robot.RobotSpec;

/// Lets a real robot see what is simulated: its lasers and sonars show what is nearest, be it real or simulated, so
/// that whatever keeps it off the one keeps it off the other. Where it looks from is where it believes to be; while
/// it does not know that, it sees what is real alone. All calls on the run's thread.
public final class Overlay {
    private static final Duration PATIENCE = Duration.ofSeconds(1);

    private final RobotSpec spec;
    private final Supplier<Optional<Stamped<Pose2d>>> mapFromBase;
    private final Supplier<Optional<SimulationControl>> simulation;
    private final Supplier<Set<String>> unseen;
    private final EventLog eventLog;
    private @Nullable Instant known; // when it was where it believed to be last
    private boolean blind;

    /// @param mapFromBase where the robot believes to be
    /// @param unseen names of those in the simulated world that stand for what is real
    public Overlay(
            RobotSpec spec,
            Supplier<Optional<Stamped<Pose2d>>> mapFromBase,
            Supplier<Optional<SimulationControl>> simulation,
            Supplier<Set<String>> unseen,
            EventLog eventLog) {
        this.spec = spec;
        this.mapFromBase = mapFromBase;
        this.simulation = simulation;
        this.unseen = unseen;
        this.eventLog = eventLog;
    }

    /// The same robot with sensors that see what is simulated, too.
    Robot over(Robot robot) {
        return robot.with(robot.devices().stream().map(this::over).toList());
    }

    private Device over(Device device) {
        return switch (device) {
            case LaserScanner laser -> new OverlaidLaser(laser, this);
            case SonarArray sonars -> new OverlaidSonars(sonars, this);
            default -> device;
        };
    }

    /// A robot as a driver is to have it that makes a device of its devices: what is simulated is no part of the map,
    /// so that those that match scans with one, or make one, see only what is real.
    static Robot asSeenBy(DeviceDriver driver, Robot robot) {
        boolean matches =
                Localizer.class.isAssignableFrom(driver.makes()) || Mapper.class.isAssignableFrom(driver.makes());
        return matches
                ? robot.with(robot.devices().stream()
                        .map(device -> device instanceof OverlaidSensor<?> overlaid ? overlaid.real() : device)
                        .toList())
                : robot;
    }

    /// How far rays get before they meet something simulated [m], fan by fan; +∞ for one that meets nothing. Empty
    /// while the robot does not know where it is.
    ///
    /// @param device whose rays they are
    Optional<double[]> ranges(List<Fan> fans, String device, double reach, Instant now) {
        Optional<Pose2d> from = mapFromBase(now);
        return from.flatMap(pose -> simulation
                .get()
                .map(world -> world.ranges(fans, pose, spec.model().level(device), reach, unseen.get())));
    }

    private Optional<Pose2d> mapFromBase(Instant now) {
        Optional<Stamped<Pose2d>> believed = mapFromBase.get();
        Instant last = believed.map(Stamped::time).orElse(known == null ? now : known);
        known = last;
        boolean old = last.plus(PATIENCE).isBefore(now);
        if (old != blind) {
            blind = old;
            eventLog.event(
                    "overlay",
                    spec.id(),
                    old
                            ? "sees nothing that is simulated: for more than %d s nobody has told where it is"
                                    .formatted(PATIENCE.toSeconds())
                            : "sees what is simulated again");
        }
        return believed.filter(_ -> !old).map(Stamped::value).filter(Pose2d::isFinite);
    }

    /// A range as a sensor shows it (REP 117) when something simulated is in its way, too.
    ///
    /// @param real as the sensor shows it
    /// @param simulated way to that [m]; +∞ when nothing is there
    static float nearer(float real, double simulated, double min, double max) {
        if (Float.isNaN(real) || simulated > max) {
            return real;
        }
        return simulated < min ? Float.NEGATIVE_INFINITY : (float) Math.min(real, simulated);
    }
}
