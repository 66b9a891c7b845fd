package rsal.data;

/// What the wheels say: `odomFromBase` is smooth but drifts, `velocity` is measured, in the base frame. `stalled`
/// means the motors push and the robot does not move.
public record Odometry(Pose2d odomFromBase, Twist2d velocity, boolean stalled) {}
