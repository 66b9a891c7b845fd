package rsal.testkit.fake;

import java.time.InstantSource;
import java.util.ArrayList;
import java.util.List;
import rsal.data.Odometry;
import rsal.data.Pose2d;
import rsal.data.Stamped;
import rsal.data.Twist2d;
import rsal.device.DeviceInfo;
import rsal.device.DriveBase;
import rsal.device.Health;
import rsal.device.SensorCore;
import rsal.robot.RobotModel;

/// A base without inertia, drift or noise. It remembers every command.
public final class FakeDriveBase extends SensorCore<Odometry> implements DriveBase {
    private static final int WATCHDOG_STEPS = 5;

    private final RobotModel model;
    private final FakeWorld world;
    private final InstantSource clock;
    private final List<Twist2d> commands = new ArrayList<>();
    private Pose2d mapFromBase;
    private Pose2d mapFromOdom;
    private Twist2d wanted = Twist2d.STOP;
    private Twist2d velocity = Twist2d.STOP;
    private int stepsSinceCommand;
    private boolean enabled = true;
    private boolean stalled;

    FakeDriveBase(DeviceInfo info, RobotModel model, Pose2d mapFromBase, FakeWorld world, InstantSource clock) {
        super(info);
        this.model = model;
        this.mapFromBase = mapFromBase;
        this.mapFromOdom = mapFromBase;
        this.world = world;
        this.clock = clock;
    }

    /// All commands so far, the oldest first, as they were given.
    public List<Twist2d> commands() {
        return List.copyOf(commands);
    }

    /// How the robot really moves.
    Twist2d velocity() {
        return velocity;
    }

    /// Of its body [m].
    double radius() {
        return model.footprint().inscribedRadius();
    }

    /// Where the robot really is.
    public Pose2d mapFromBase() {
        return mapFromBase;
    }

    /// For tests: breaks the base's readings off, or mends them.
    public void turn(Health now) {
        health(now);
    }

    @Override
    public void command(Twist2d twist) {
        if (!twist.isFinite()) {
            throw new IllegalArgumentException("A command must be finite, not '%s'.".formatted(twist));
        }
        commands.add(twist);
        wanted = model.drive().feasible(twist);
        stepsSinceCommand = 0;
    }

    @Override
    public void enable(boolean on) {
        enabled = on;
        wanted = Twist2d.STOP;
    }

    @Override
    public boolean enabled() {
        return enabled;
    }

    @Override
    public void resetOdometry(Pose2d odomFromBase) {
        mapFromOdom = mapFromBase.compose(odomFromBase.inverse());
    }

    /// Puts the robot somewhere; odometry does not notice.
    void place(Pose2d mapFromBaseNow) {
        Pose2d odomFromBase = mapFromOdom.inverse().compose(mapFromBase);
        mapFromBase = mapFromBaseNow;
        mapFromOdom = mapFromBaseNow.compose(odomFromBase.inverse());
        halt();
    }

    void halt() {
        wanted = Twist2d.STOP;
        velocity = Twist2d.STOP;
    }

    void step(FakeSimulationControl simulation) {
        if (stepsSinceCommand++ >= WATCHDOG_STEPS || !enabled) {
            wanted = Twist2d.STOP;
        }
        velocity = wanted;
        double dt = FakeSystem.STEP_SECONDS;
        double middle = velocity.omega() * dt / 2;
        Pose2d next = mapFromBase
                .compose(new Pose2d(0, 0, middle))
                .compose(new Pose2d(velocity.vx() * dt, velocity.vy() * dt, middle));
        double room = world.clearance(next.x(), next.y());
        boolean touches =
                room < radius() && room <= world.clearance(mapFromBase.x(), mapFromBase.y()); // else it drives out
        if (touches && velocity.speed() != 0) {
            if (!stalled) {
                simulation.touched(clock.instant(), info().robot());
            }
            velocity = Twist2d.STOP;
        } else {
            mapFromBase = next;
        }
        stalled = touches && wanted.speed() != 0;
    }

    void sense() {
        if (!(health() instanceof Health.Lost)) {
            Pose2d odomFromBase = mapFromOdom.inverse().compose(mapFromBase);
            deliver(new Stamped<>(
                    clock.instant(), info().robot() + "/odom", new Odometry(odomFromBase, velocity, stalled)));
        }
    }
}
