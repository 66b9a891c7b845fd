package rsal.ros2.bridge;

import rsal.device.Gripper;

/// What a gripper is called on ROS 2, in its robot's namespace.
///
/// @param name `gripper` of a robot's first one, the device's own name of others
record GripperNames(String name) {
    static GripperNames of(Gripper gripper, RobotOutlet outlet) {
        return new GripperNames(outlet.name(gripper, Gripper.class, "gripper"));
    }

    /// The action that moves its paddles.
    String paddles() {
        return name + "_controller/gripper_cmd";
    }

    /// The action that moves its lift.
    String lift() {
        return name + "_lift_controller/gripper_cmd";
    }

    String paddlesJoint() {
        return name + "_joint";
    }

    String liftJoint() {
        return name + "_lift_joint";
    }
}
