package rsal.ros2.setting;

import java.util.OptionalDouble;

/// How a gripper is driven that is one or two joints, each behind an action of type `control_msgs/GripperCommand`.
///
/// @param action of the paddles, in the robot's namespace
/// @param joint of the paddles, as `joint_states` names it
/// @param open position of the joint while the paddles are open [m or rad]; empty for the opening of the model
/// @param closed position of the joint while they are closed [m or rad]
/// @param effort greatest [N or Nm]; 0 for the controller's own
/// @param liftAction of the lift, in the robot's namespace: 0 is down, the height of the model's gripper is up [m]
/// @param liftJoint of the lift, as `joint_states` names it
public record GripperSettings(
        String action,
        String joint,
        OptionalDouble open,
        double closed,
        double effort,
        String liftAction,
        String liftJoint) {
    /// Names as `ros2_controllers` has them in its examples, and as our bridge has them.
    public static final GripperSettings USUAL = new GripperSettings(
            "gripper_controller/gripper_cmd",
            "gripper_joint",
            OptionalDouble.empty(),
            0,
            0,
            "gripper_lift_controller/gripper_cmd",
            "gripper_lift_joint");
}
