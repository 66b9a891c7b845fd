package rsal.data;

/// What the wheels measure (`nav_msgs/Odometry`).
///
/// @param odomFromBase pose in the odom frame, which is smooth but drifts
/// @param velocity measured, in the base frame [m/s, rad/s]
/// @param stalled whether the motors run, but the robot does not move
public record Odometry(Pose2d odomFromBase, Twist2d velocity, boolean stalled) {}
