package rsal.behavior;

import java.lang.System.Logger;
import java.lang.System.Logger.Level;
import java.time.Duration;
import java.time.Instant;
import java.time.InstantSource;
import java.util.Optional;
import org.jspecify.annotations.Nullable;
import rsal.data.Odometry;
import rsal.data.Stamped;
import rsal.data.Twist2d;
import rsal.device.DeviceInfo;
import rsal.device.DriveBase;
import rsal.device.Health;
import rsal.device.LaserScanner;
import rsal.device.Locomotion;
import rsal.device.Sensor;
import rsal.device.SensorCore;
import rsal.device.SonarArray;
import rsal.robot.Robot;

/// Lets a subsumption stack drive a robot, and reports the decisions of the stack. Frame of its readings:
/// `<robot>/base_link`.
///
/// While motors are off, the stack is not called, since it would detect that it is stuck. When odometry or a
/// range sensor is silent, the robot stands still, and the pilot is stale until they are back. When a behavior
/// throws an exception, or returns a velocity that is not finite, the robot stands still. The pilot then
/// releases the stack, and is lost until it gets another one.
public final class Pilot extends SensorCore<Decision> implements Locomotion {
    static final Duration PERIOD = Duration.ofMillis(100);

    private static final Logger LOG = System.getLogger(Pilot.class.getName());
    private static final Duration SILENT = Duration.ofMillis(500);

    private final DriveBase base;
    private final Optional<LaserScanner> laser;
    private final Optional<SonarArray> sonar;
    private final SectorFusion fusion;
    private final InstantSource clock;
    private final String frame;
    private @Nullable Subsumption stack;
    private boolean paused;

    Pilot(DeviceInfo info, Robot robot, SectorFusion fusion, InstantSource clock) {
        super(info);
        this.base = robot.require(DriveBase.class);
        this.laser = robot.find(LaserScanner.class);
        this.sonar = robot.find(SonarArray.class);
        this.fusion = fusion;
        this.clock = clock;
        this.frame = robot.id() + "/base_link";
    }

    /// Lets a stack drive from the next update on, instead of the present one.
    public void engage(Subsumption next) {
        stack = next;
        if (!health().isOk()) {
            health(Health.ok());
        }
    }

    /// Stands still, and lets others drive.
    public void release() {
        if (stack != null) {
            stack = null;
            base.command(Twist2d.STOP);
        }
    }

    public boolean engaged() {
        return stack != null;
    }

    /// Stands still and keeps its stack, without calling it. Those that engage or release it meanwhile find
    /// that done after [#resume].
    public void pause() {
        if (!paused && stack != null) {
            base.command(Twist2d.STOP);
        }
        paused = true;
    }

    public void resume() {
        paused = false;
    }

    public boolean paused() {
        return paused;
    }

    void update() {
        Subsumption driving = paused || !base.enabled() ? null : stack;
        Instant now = clock.instant();
        Optional<String> silent = silent(now);
        if (driving == null) {
            if (silent.isEmpty()) {
                if (health() instanceof Health.Stale) {
                    health(Health.ok());
                }
                percept(now); // the behavior that is engaged next must know what is beside the tail
            }
            return;
        }
        if (silent.isPresent()) {
            base.command(Twist2d.STOP);
            health(new Health.Stale("No reading of '%s'.".formatted(silent.get())));
            return;
        }
        Decision decision;
        try {
            decision = driving.decide(percept(now));
            if (!decision.twist().isFinite()) {
                throw new IllegalStateException(
                        "Layer '%s' wants '%s'.".formatted(decision.inCharge(), decision.twist()));
            }
        } catch (RuntimeException e) {
            LOG.log(Level.ERROR, () -> "A behavior of '%s' failed.".formatted(info().id()), e);
            release();
            health(new Health.Lost("A behavior failed: " + e));
            return;
        }
        if (stack != driving || paused) {
            return; // a behavior engaged another stack, released this one, or had it paused
        }
        base.command(decision.twist());
        deliver(new Stamped<>(now, frame, decision));
    }

    private Percept percept(Instant now) {
        Odometry odometry = base.latest().orElseThrow().value();
        return new Percept(
                now,
                odometry,
                fusion.fuse(
                        now,
                        odometry.odomFromBase(),
                        laser.flatMap(Sensor::latest).map(Stamped::value),
                        sonar.flatMap(Sensor::latest).map(Stamped::value)));
    }

    /// A device that has had no reading for too long.
    private Optional<String> silent(Instant now) {
        if (isSilent(base, now)) {
            return Optional.of(base.info().id());
        }
        return laser.filter(l -> isSilent(l, now))
                .map(l -> l.info().id())
                .or(() -> sonar.filter(s -> isSilent(s, now)).map(s -> s.info().id()));
    }

    private static boolean isSilent(Sensor<?> sensor, Instant now) {
        return sensor.latest()
                .filter(reading -> !reading.time().plus(SILENT).isBefore(now))
                .isEmpty();
    }
}
