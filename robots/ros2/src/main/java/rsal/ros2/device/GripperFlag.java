package rsal.ros2.device;

/// What a gripper feels, for which ROS has no type of its own.
enum GripperFlag {
    INNER_BEAM("inner_beam"),
    OUTER_BEAM("outer_beam"),
    LEFT_CONTACT("left_contact"),
    RIGHT_CONTACT("right_contact"),
    HOLDING("holding");

    private final String topic;

    GripperFlag(String topic) {
        this.topic = topic;
    }

    /// Its name below that of the gripper.
    String topic() {
        return topic;
    }
}
