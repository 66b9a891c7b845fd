package rsal.device;

import rsal.data.Odometry;
import rsal.data.Pose2d;
import rsal.data.Twist2d;

/// Motors and wheels. Frame of its readings: `<robot>/odom`.
public interface DriveBase extends Sensor<Odometry>, Locomotion {
    /// Moves at this velocity until the next command. The newest wins; when none comes for the watchdog's time
    /// (0.5 s by default) the base stops by itself. What the drive can't do at all is left out (a differential
    /// drive's way to the side, a car's turn in place); speeds beyond what it can do are cut to it, keeping the
    /// curvature: [rsal.robot.RobotModel.Drive#feasible].
    ///
    /// @throws IllegalArgumentException when a component is not finite
    void command(Twist2d velocity);

    /// Switches the motors: of the wheels, and of grippers and actuators on the same robot. Wheels that are
    /// disabled ignore commands; grippers and actuators stand still and go on, when they are enabled again,
    /// with what they are to do then.
    void enable(boolean enabled);

    boolean enabled();

    /// Sets the robot's pose in its odometry. The robot does not move.
    void resetOdometry(Pose2d odomFromBase);
}
