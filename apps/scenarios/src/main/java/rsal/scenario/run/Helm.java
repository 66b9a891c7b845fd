package rsal.scenario.run;

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
final class Helm {
    private final DriveBase base;
    private Hand hand = Hand.AGENTS;
    private boolean on = true; // as far as the hands want
    private boolean stopped; // in an emergency

    /// Who may steer.
    enum Hand {
        /// The robot's agents, by themselves or by their pilot or navigator.
        AGENTS,
        /// A pilot or navigator that does what people have told the robot to do.
        ORDERS,
        /// People, by themselves.
        KEYS
    }

    Helm(DriveBase base) {
        this.base = base;
    }

    Hand hand() {
        return hand;
    }

    void give(Hand next) {
        if (next != hand) {
            hand = next;
            base.command(Twist2d.STOP);
        }
    }

    /// Switches the motors off, whoever may want them on, until [#rearm].
    void stop() {
        stopped = true;
        apply();
    }

    /// Leaves the motors to the hands again: those that were switched off by one stay off.
    void rearm() {
        stopped = false;
        apply();
    }

    /// Whether they are off, whoever may want them on.
    boolean isStopped() {
        return stopped;
    }

    private void enable(boolean wanted) {
        on = wanted;
        apply();
    }

    private void apply() {
        base.enable(on && !stopped);
    }

    /// The base, for whoever steers.
    DriveBase base() {
        return base;
    }

    /// A robot with the base as one of the hands has it: whatever that commands counts only while it steers.
    ///
    /// @param robot with the base as anybody has it
    Robot steering(Robot robot, Hand whose) {
        return robot.replacing(robot.require(DriveBase.class), new Held(this, whose));
    }

    private record Held(Helm helm, Hand whose) implements DriveBase {
        @Override
        public void command(Twist2d velocity) {
            if (!velocity.isFinite()) {
                helm.base.command(velocity); // says what is wrong with it, whoever steers
            } else if (helm.hand == whose) {
                helm.base.command(velocity);
            }
        }

        @Override
        public void enable(boolean enabled) {
            helm.enable(enabled);
        }

        @Override
        public boolean enabled() {
            return helm.base.enabled();
        }

        @Override
        public void resetOdometry(Pose2d odomFromBase) {
            helm.base.resetOdometry(odomFromBase);
        }

        @Override
        public Optional<Stamped<Odometry>> latest() {
            return helm.base.latest();
        }

        @Override
        public Subscription subscribe(Consumer<? super Stamped<Odometry>> listener) {
            return helm.base.subscribe(listener);
        }

        @Override
        public DeviceInfo info() {
            return helm.base.info();
        }

        @Override
        public List<Device> children() {
            return helm.base.children();
        }

        @Override
        public Health health() {
            return helm.base.health();
        }

        @Override
        public Subscription onHealth(Consumer<? super Health> listener) {
            return helm.base.onHealth(listener);
        }
    }
}
