package rsal.ros2.device;

import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import rsal.data.Odometry;
import rsal.data.Pose2d;
import rsal.data.Twist2d;
import rsal.device.DeviceInfo;
import rsal.device.DriveBase;
import rsal.robot.RobotModel.Drive;
import rsal.ros2.link.RosPublisher.Publication;
import rsal.ros2.message.OdometryMessage;
import rsal.ros2.message.RosMessages;
import rsal.ros2.setting.Safety;

/// Wheels that take `geometry_msgs/Twist` or `TwistStamped` and publish `nav_msgs/Odometry`. Robots of ROS stop by
/// themselves when no command comes, or don't: so the newest one is published ten times a second while it is fresh, and
/// then a stop.
final class RosBase extends RosSensor<Odometry> implements DriveBase {
    private static final Duration AGAIN = Duration.ofMillis(100);
    private static final Duration STOPPING = Duration.ofMillis(500);
    private static final Duration STOPPING_AGAIN = Duration.ofSeconds(2); // new connections are not heard at once
    private static final int LAST_WORDS = 5; // stops, of which one will arrive
    private static final Duration STALL = Duration.ofMillis(300); // longer than robots take to begin
    private static final double SLOWEST = 0.01; // m/s, rad/s

    private final Publication commands;
    private final boolean isStamped;
    private final Drive drive;
    private final Duration watchdog;
    private final Frames frames;
    private final RobotClock clock;
    private final RosMessages messages = new RosMessages();
    private final List<Consumer<Boolean>> motorListeners = new ArrayList<>();
    private final List<Consumer<OdometryMessage>> odometryListeners = new ArrayList<>();
    private boolean enabled;
    private Optional<Twist2d> wanted = Optional.empty();
    private Instant wantedAt = Instant.MIN;
    private Instant sentAt = Instant.MIN;
    private Instant stoppingUntil = Instant.MIN;
    private Instant blockedSince = Instant.MAX;
    private boolean mayMove; // since it was held last
    private boolean isUsed; // was told something, be it a stop
    private Instant heldUntil = Instant.MIN; // in real time
    private boolean isHeld; // was stopped as time stood
    private Pose2d reported = Pose2d.ORIGIN;
    private Pose2d odomFromTheirs = Pose2d.ORIGIN; // others may use the robot's odometry: it is not set, but ours is

    /// @param isStamped whether the robot wants `TwistStamped`
    RosBase(
            DeviceInfo info,
            String topic,
            Publication commands,
            boolean isStamped,
            Drive drive,
            Safety safety,
            Frames frames,
            RobotClock clock) {
        super(info, info.robot() + "/odom", topic);
        this.commands = commands;
        this.isStamped = isStamped;
        this.drive = drive;
        this.watchdog = safety.watchdog();
        this.enabled = safety.armed();
        this.frames = frames;
        this.clock = clock;
    }

    /// @param message which is finite
    void take(OdometryMessage message) {
        reported = message.odomFromBase();
        heard(frames.now());
        publish(
                clock.time(message.stamp()),
                new Odometry(odomFromTheirs.compose(reported), message.velocity(), isStalled(message.velocity())));
        odometryListeners.forEach(listener -> listener.accept(message));
    }

    /// Tells others of the robot each odometry, after it was told as a reading.
    void onOdometry(Consumer<OdometryMessage> listener) {
        odometryListeners.add(listener);
    }

    /// ROS has no word for it: whether the robot has been told to move for a while, and stands.
    private boolean isStalled(Twist2d measured) {
        boolean moves = wanted.filter(RosBase::isMotion).isEmpty() || isMotion(measured);
        if (moves) {
            blockedSince = Instant.MAX;
        } else if (blockedSince.equals(Instant.MAX)) {
            blockedSince = frames.now();
        }
        return !moves && blockedSince.plus(STALL).isBefore(frames.now());
    }

    private static boolean isMotion(Twist2d velocity) {
        return Math.hypot(velocity.vx(), velocity.vy()) > SLOWEST || Math.abs(velocity.omega()) > SLOWEST;
    }

    @Override
    public void command(Twist2d velocity) {
        if (!velocity.isFinite()) {
            throw new IllegalArgumentException(
                    "A velocity must be finite, but '%s' was given '%s'.".formatted(info().id(), velocity));
        }
        if (enabled) {
            Twist2d feasible = drive.feasible(velocity);
            wanted = Optional.of(feasible);
            wantedAt = frames.now();
            send(feasible);
        }
    }

    /// Publishes the newest command again, or a stop when it is too old.
    void drive(Instant now) {
        if (wanted.isPresent()) {
            if (wantedAt.plus(watchdog).isBefore(now.plus(RosRobot.LOOK))) {
                stop();
            } else if (!sentAt.plus(AGAIN).isAfter(now)) {
                send(wanted.get());
            }
        } else if (stoppingUntil.isAfter(now)) {
            send(Twist2d.STOP);
        }
    }

    /// Told again and again for a while, as a message can get lost.
    private void stop() {
        wanted = Optional.empty();
        stoppingUntil = frames.now().plus(STOPPING);
        send(Twist2d.STOP);
    }

    /// Stops it again when it is back, unless it is driven: what it was told meanwhile was lost, and it may still
    /// go on with the last velocity that it heard. One that was never told anything is left to others.
    void appear() {
        if (isUsed && wanted.isEmpty()) {
            stoppingUntil = frames.now().plus(STOPPING_AGAIN);
        }
    }

    /// Has it stand while the run's time does, without forgetting what is wanted: once time goes on, that is
    /// sent again if it is still fresh by the run's time. A simulator that is paused must not change what
    /// happens.
    ///
    /// @param now in real time
    void hold(Instant now) {
        if (mayMove) {
            heldUntil = now.plus(STOPPING);
        }
        if (now.isBefore(heldUntil)) {
            send(Twist2d.STOP);
            sentAt = Instant.MIN;
            isHeld = true;
        }
        mayMove = false;
    }

    /// Time goes on: if it was held, what is wanted is sent again at once.
    void release(Instant now) {
        if (isHeld) {
            isHeld = false;
            drive(now);
        }
    }

    private void send(Twist2d velocity) {
        mayMove |= isMotion(velocity);
        isUsed = true;
        sentAt = frames.now();
        commands.publish(
                isStamped
                        ? messages.twist(velocity, Instant.ofEpochSecond(0, clock.stamp()), frames.base())
                        : messages.twist(velocity));
    }

    @Override
    public void enable(boolean enabled) {
        this.enabled = enabled;
        if (!enabled) {
            stop();
        }
        motorListeners.forEach(listener -> listener.accept(enabled));
    }

    /// Tells those that drive it, too, each time that its motors are switched.
    void onMotors(Consumer<Boolean> listener) {
        motorListeners.add(listener);
    }

    @Override
    public boolean enabled() {
        return enabled;
    }

    @Override
    public void resetOdometry(Pose2d odomFromBase) {
        odomFromTheirs = odomFromBase.compose(reported.inverse());
    }

    /// In the robot's own frame, whatever ours was set to.
    Pose2d reported() {
        return reported;
    }

    /// Stops the robot, for good.
    void end() {
        enabled = false;
        for (int i = 0; i < LAST_WORDS; i++) {
            stop();
        }
    }
}
