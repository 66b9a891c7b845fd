package rsal.scenario.run;

import java.util.List;
import java.util.Optional;
import java.util.function.BooleanSupplier;
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
/// changes hands the robot stands still until the new one commands.
final class Helm {
    private final DriveBase base;
    private Hand hand = Hand.AGENTS;

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

    /// The base, for whoever steers.
    DriveBase base() {
        return base;
    }

    /// A robot with the base as one of the hands has it: whatever that commands counts only while it steers.
    ///
    /// @param robot with the base as anybody has it
    Robot steering(Robot robot, Hand whose) {
        return robot.replacing(robot.require(DriveBase.class), new Held(base, () -> hand == whose));
    }

    private record Held(DriveBase base, BooleanSupplier steers) implements DriveBase {
        @Override
        public void command(Twist2d velocity) {
            if (!velocity.isFinite()) {
                base.command(velocity); // says what is wrong with it, whoever steers
            } else if (steers.getAsBoolean()) {
                base.command(velocity);
            }
        }

        @Override
        public void enable(boolean enabled) {
            base.enable(enabled);
        }

        @Override
        public boolean enabled() {
            return base.enabled();
        }

        @Override
        public void resetOdometry(Pose2d odomFromBase) {
            base.resetOdometry(odomFromBase);
        }

        @Override
        public Optional<Stamped<Odometry>> latest() {
            return base.latest();
        }

        @Override
        public Subscription subscribe(Consumer<? super Stamped<Odometry>> listener) {
            return base.subscribe(listener);
        }

        @Override
        public DeviceInfo info() {
            return base.info();
        }

        @Override
        public List<Device> children() {
            return base.children();
        }

        @Override
        public Health health() {
            return base.health();
        }

        @Override
        public Subscription onHealth(Consumer<? super Health> listener) {
            return base.onHealth(listener);
        }
    }
}
