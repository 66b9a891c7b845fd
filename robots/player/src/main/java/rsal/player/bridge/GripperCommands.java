package rsal.player.bridge;

import org.jspecify.annotations.Nullable;
import rsal.data.GripperState;
import rsal.device.GoalHandle;
import rsal.device.Gripper;

/// What clients have a gripper do, so that they can stop it.
final class GripperCommands {
    private final Gripper gripper;
    private @Nullable GoalHandle<GripperState, Gripper.Result> paddles;
    private @Nullable GoalHandle<GripperState, Gripper.Result> lift;

    GripperCommands(Gripper gripper) {
        this.gripper = gripper;
    }

    void open() {
        paddles = gripper.open();
    }

    void close() {
        paddles = gripper.close();
    }

    void lift() {
        lift = gripper.lift();
    }

    void lower() {
        lift = gripper.lower();
    }

    void stop() {
        if (paddles != null) {
            paddles.cancel();
        }
        stopLift();
    }

    void stopLift() {
        if (lift != null) {
            lift.cancel();
        }
    }
}
