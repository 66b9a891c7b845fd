package rsal.sim;

import java.time.Duration;
import java.time.Instant;
import java.time.InstantSource;
import java.util.random.RandomGenerator;
import rsal.data.Odometry;
import rsal.data.Pose2d;
import rsal.data.Stamped;
import rsal.data.Twist2d;
import rsal.device.DeviceInfo;
import rsal.device.DriveBase;
import rsal.device.Health;
import rsal.device.SensorCore;
import rsal.device.Subscription;
import rsal.fault.Fault;
import rsal.fault.SensorFaults;

/// A simulated drive. When the robot runs into something, its wheels stop with it: odometry counts
/// only the way made, the speeds are zero, and it says that it is stalled until a step in which the robot moves as
/// it should or is not asked to move. Where robots slide along what they touch, wheels go on and slip.
final class SimDrive extends SensorCore<Odometry> implements DriveBase {
    private static final Duration PATIENCE = Duration.ofMillis(500); // without odometry, then it is stale

    private final InstantSource clock;
    private final Duration watchdog;
    private final WheelSpeeds wheels;
    private final Odometer odometer;
    private final DriveFaults faults = new DriveFaults();
    private final SensorFaults<Odometry> odometryFaults = new SensorFaults<>();
    private Twist2d command = Twist2d.STOP;
    private Instant commanded = Instant.MIN;
    private boolean enabled = true;
    private boolean stalled;
    private double part; // of the way of the last step that the robot made

    SimDrive(DeviceInfo info, InstantSource clock, Duration watchdog, WheelSpeeds wheels, Odometer odometer) {
        super(info);
        this.clock = clock;
        this.watchdog = watchdog;
        this.wheels = wheels;
        this.odometer = odometer;
    }

    @Override
    public void command(Twist2d velocity) {
        if (!velocity.isFinite()) {
            throw new IllegalArgumentException(
                    "A velocity must be finite, but '%s' was given '%s'.".formatted(info().id(), velocity));
        }
        if (enabled) {
            command = velocity;
            commanded = clock.instant();
        }
    }

    @Override
    public void enable(boolean enabled) {
        this.enabled = enabled;
        if (!enabled) {
            command = Twist2d.STOP;
        }
    }

    @Override
    public boolean enabled() {
        return enabled;
    }

    @Override
    public void resetOdometry(Pose2d odomFromBase) {
        odometer.reset(odomFromBase);
    }

    /// Turns the wheels for a step.
    WheelSpeeds turnWheels(double dt) {
        boolean driedUp = !clock.instant().isBefore(commanded.plus(watchdog));
        if (driedUp) {
            command = Twist2d.STOP;
        }
        if (!enabled || faults.dead()) {
            wheels.block();
        }
        wheels.spin(faults.obeyed(command), dt);
        return wheels;
    }

    /// The result.
    ///
    /// @param made part of the way that the robot made before it touched something; 1 for all, or when it slid on
    void moved(double made) {
        part = made;
        Twist2d counted =
                faults.counted(new Twist2d(wheels.forward() * part, wheels.left() * part, wheels.turn() * part));
        odometer.moved(counted.vx(), counted.vy(), counted.omega());
        stalled = part < 1;
        if (stalled) {
            wheels.block();
        }
    }

    /// Made in the last step [m].
    double distance() {
        return part * Math.hypot(wheels.forward(), wheels.left());
    }

    /// Turned in the last step, to either side [rad].
    double turned() {
        return part * Math.abs(wheels.turn());
    }

    /// Somebody put the robot elsewhere.
    void standStill() {
        wheels.block();
        command = Twist2d.STOP;
        stalled = false;
    }

    void report(Instant now) {
        var odometry = new Odometry(odometer.odomFromBase(), faults.counted(wheels.velocity()), stalled);
        odometryFaults
                .shown(new Stamped<>(now, info().robot() + "/odom", odometry))
                .ifPresentOrElse(this::deliver, () -> isSilent(now));
    }

    private void isSilent(Instant now) {
        if (latest().filter(last -> now.isBefore(last.time().plus(PATIENCE))).isEmpty()) {
            health(new Health.Stale("No odometry for %d ms.".formatted(PATIENCE.toMillis())));
        }
    }

    /// Begins a fault of what its odometry shows.
    ///
    /// @return ends it
    Subscription begin(Fault.OfSensor fault, RandomGenerator random) {
        return odometryFaults.add(fault, random);
    }

    /// Begins a fault of motors or wheels.
    ///
    /// @return ends it
    Subscription begin(Fault fault) {
        return faults.add(fault);
    }

    void close(Health.Lost why) {
        health(why);
    }
}
