package rsal.player.device;

import java.time.Duration;
import java.time.Instant;
import java.time.InstantSource;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import rsal.data.Odometry;
import rsal.data.Pose2d;
import rsal.data.Twist2d;
import rsal.device.DeviceInfo;
import rsal.device.DriveBase;
import rsal.player.message.Pose;
import rsal.player.message.Position2d;
import rsal.player.wire.Address;
import rsal.robot.RobotModel.Drive;

/// A base behind `position2d`. A velocity holds there until the next one, so that this one sees to it that commands
/// dry up: it says the newest again and again while it is fresh, and then once that the robot is to stop. When the
/// connection is lost what was commanded is forgotten: those that drive must do so again.
final class PlayerBase extends PlayerSensor<Odometry> implements DriveBase {
    private static final Duration AGAIN =
            Duration.ofMillis(150); // for servers with a watchdog; agents mostly are sooner

    private final RemoteServer server;
    private final Drive drive;
    private final Duration watchdog;
    private final InstantSource clock;
    private final List<Consumer<Boolean>> motorListeners = new ArrayList<>();
    private boolean enabled;
    private boolean hasJoined; // the run, which says before whether its motors are to be on
    private Optional<Twist2d> wanted = Optional.empty();
    private Instant wantedAt = Instant.MIN;
    private boolean left; // driving, when the server was lost
    private Instant sentAt = Instant.MIN;
    private Pose2d reported = Pose2d.ORIGIN;
    private Pose2d odomFromTheirs = Pose2d.ORIGIN; // others may use the server's odometry: it is not set, but ours is

    /// @param watchdog after which the robot stands when nothing more is commanded
    /// @param armed whether its motors are on
    PlayerBase(
            DeviceInfo info,
            Address address,
            RemoteServer server,
            Drive drive,
            Duration watchdog,
            boolean armed,
            InstantSource clock) {
        super(info, address, info.robot() + "/odom");
        this.server = server;
        this.drive = drive;
        this.watchdog = watchdog;
        this.enabled = armed;
        this.clock = clock;
    }

    @Override
    Optional<Odometry> read(Record body) {
        if (!(body instanceof Position2d.State state)) {
            return Optional.empty();
        }
        Pose2d theirs = state.odomFromBase().to2d();
        var velocity = new Twist2d(
                state.velocity().x(), state.velocity().y(), state.velocity().theta());
        if (!theirs.isFinite() || !velocity.isFinite()) {
            return Optional.empty();
        }
        reported = theirs;
        return Optional.of(new Odometry(odomFromTheirs.compose(theirs), velocity, state.stall() != 0));
    }

    @Override
    public void command(Twist2d velocity) {
        if (!velocity.isFinite()) {
            throw new IllegalArgumentException(
                    "A velocity must be finite, but '%s' was given '%s'.".formatted(info().id(), velocity));
        }
        if (enabled && server.isConnected()) {
            Twist2d feasible = drive.feasible(velocity);
            wanted = Optional.of(feasible);
            wantedAt = clock.instant();
            send(feasible, wantedAt);
        }
    }

    /// Says again what is wanted, unless that would be too old before it can be said once more.
    @Override
    public void look(Instant now) {
        super.look(now);
        if (wanted.isPresent()) {
            if (wantedAt.plus(watchdog).isBefore(now.plus(RemoteServer.LOOK))) {
                stop();
            } else if (!sentAt.plus(AGAIN).isAfter(now)) {
                send(wanted.get(), now);
            }
        }
    }

    private void stop() {
        wanted = Optional.empty();
        send(Twist2d.STOP, clock.instant());
    }

    private void send(Twist2d velocity, Instant now) {
        sentAt = now;
        server.command(
                address(),
                Position2d.VELOCITY,
                new Position2d.Velocity(new Pose(velocity.vx(), velocity.vy(), velocity.omega()), 1));
    }

    @Override
    public void enable(boolean enabled) {
        this.enabled = enabled;
        if (!enabled) {
            stop();
        }
        motors();
        motorListeners.forEach(listener -> listener.accept(enabled));
    }

    /// Tells those that drive it, too, each time that they are switched.
    void onMotors(Consumer<Boolean> listener) {
        motorListeners.add(listener);
    }

    /// The run has the robot from now on.
    void join() {
        hasJoined = true;
        motors();
    }

    /// Has the server switch them as they are to be: off as long as that is not known.
    void motors() {
        server.ask(address(), Position2d.MOTORS, Optional.of(new Position2d.Motors(enabled && hasJoined ? 1 : 0)));
    }

    @Override
    public boolean enabled() {
        return enabled;
    }

    @Override
    public void resetOdometry(Pose2d odomFromBase) {
        odomFromTheirs = odomFromBase.compose(reported.inverse());
    }

    @Override
    public void connected() {
        super.connected();
        motors();
        if (left) {
            left = false;
            stop(); // as the server may not have noticed that we were gone
        }
    }

    @Override
    public void lost(String reason) {
        left |= wanted.isPresent();
        wanted = Optional.empty();
        super.lost(reason);
    }

    /// Stops the robot, for good.
    @Override
    public void end() {
        enabled = false;
        stop();
    }
}
