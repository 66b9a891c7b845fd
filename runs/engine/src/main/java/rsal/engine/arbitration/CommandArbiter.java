package rsal.engine.arbitration;

import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import rsal.data.Odometry;
import rsal.data.Pose2d;
import rsal.data.Stamped;
import rsal.data.Twist2d;
import rsal.device.Device;
import rsal.device.DeviceInfo;
import rsal.device.DriveBase;
import rsal.device.Health;
import rsal.device.Subscription;
import rsal.robot.Robot;

/// Who steers a base: of several hands that reach for it one has it, and what the others command is dropped. When it
/// changes hands the robot stands still until the new one commands. In an emergency nobody's hand moves it.
public final class CommandArbiter {
    private final DriveBase base;
    private Source hand = Source.AGENTS;
    private boolean on = true; // as far as the hands want
    private boolean stopped; // in an emergency
    private boolean off; // by people, this one alone

    /// Who may steer.
    public enum Source {
        /// The robot's agents, by themselves or by their pilot or navigator.
        AGENTS,
        /// A pilot or navigator that does what people have told the robot to do.
        ORDERS,
        /// People, by themselves.
        KEYS
    }

    public CommandArbiter(DriveBase base) {
        this.base = base;
    }

    Source hand() {
        return hand;
    }

    void give(Source next) {
        if (next != hand) {
            hand = next;
            base.command(Twist2d.STOP);
        }
    }

    /// Switches the motors off, no matter who wants them on, until [#rearm].
    void stop() {
        stopped = true;
        apply();
    }

    /// The emergency is over. The motors are left to the hands again, unless they were [switched off][#switchOff]:
    /// those that were switched off by a hand stay off, too.
    public void rearm() {
        stopped = false;
        apply();
    }

    /// Switches the motors of this one off, no matter who wants them on, until [#switchOn].
    void switchOff() {
        off = true;
        apply();
    }

    /// Leaves the motors to the hands again, also while the emergency goes on for others.
    public void switchOn() {
        off = false;
        rearm();
    }

    /// Whether they are off, no matter who wants them on.
    public boolean isOff() {
        return stopped || off;
    }

    /// Whether they are, by an emergency.
    public boolean isStopped() {
        return stopped;
    }

    /// Whether they are, for this one alone: they stay so when an emergency is over.
    public boolean isSwitchedOff() {
        return off;
    }

    private void enable(boolean wanted) {
        on = wanted;
        apply();
    }

    private void apply() {
        base.enable(on && !isOff());
    }

    /// The base, for those that steer.
    DriveBase base() {
        return base;
    }

    /// A robot with the base as one of the hands has it: whatever that commands counts only while it steers.
    ///
    /// @param robot with the base as anybody has it
    public Robot steering(Robot robot, Source whose) {
        return robot.replacing(robot.require(DriveBase.class), new Held(this, whose));
    }

    private record Held(CommandArbiter arbiter, Source whose) implements DriveBase {
        @Override
        public void command(Twist2d velocity) {
            if (!velocity.isFinite()) {
                arbiter.base.command(velocity); // says what is wrong with it, no matter who steers
            } else if (arbiter.hand == whose) {
                arbiter.base.command(velocity);
            }
        }

        @Override
        public void enable(boolean enabled) {
            arbiter.enable(enabled);
        }

        @Override
        public boolean enabled() {
            return arbiter.base.enabled();
        }

        @Override
        public void resetOdometry(Pose2d odomFromBase) {
            arbiter.base.resetOdometry(odomFromBase);
        }

        @Override
        public Optional<Stamped<Odometry>> latest() {
            return arbiter.base.latest();
        }

        @Override
        public Subscription subscribe(Consumer<? super Stamped<Odometry>> listener) {
            return arbiter.base.subscribe(listener);
        }

        @Override
        public DeviceInfo info() {
            return arbiter.base.info();
        }

        @Override
        public List<Device> children() {
            return arbiter.base.children();
        }

        @Override
        public Health health() {
            return arbiter.base.health();
        }

        @Override
        public Subscription onHealth(Consumer<? super Health> listener) {
            return arbiter.base.onHealth(listener);
        }
    }
}
