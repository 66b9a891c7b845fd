package rsal.player.bridge;

import java.util.Optional;
import rsal.data.Angles;
import rsal.data.Interval;
import rsal.data.Pose2d;
import rsal.data.Twist2d;
import rsal.robot.RobotModel.Axis;
import rsal.robot.RobotModel.Drive;
import rsal.robot.RobotModel.Steering;

/// Wishes that take several steps, minding nothing that is in the way.
final class Steps {
    private static final double NEAR = 0.02; // m; as Stage has it
    private static final double ALIGNED = Math.toRadians(2);
    private static final double AHEAD = Math.toRadians(10); // drives on only when its goal is so far ahead; the same
    private static final double GAIN = 2; // 1/s; brakes in time though what it knows is 0.2 s old

    private Steps() {}

    /// Turns to a place, drives there and turns to a heading, as fast as the base can; one that drives to all
    /// sides does it all at once.
    ///
    /// @param drive of a base that turns in place
    static ClientCommand to(Pose2d odomFromGoal, Drive drive) {
        return odometry -> {
            Pose2d baseFromGoal = odometry.odomFromBase().inverse().compose(odomFromGoal);
            double distance = Math.hypot(baseFromGoal.x(), baseFromGoal.y());
            double bearing = Math.atan2(baseFromGoal.y(), baseFromGoal.x());
            boolean near = distance <= NEAR;
            if (near && Math.abs(baseFromGoal.theta()) <= ALIGNED) {
                return Optional.empty();
            }
            if (near) {
                return Optional.of(new Twist2d(0, 0, speed(baseFromGoal.theta(), drive.turn())));
            }
            double speed = speed(distance, drive.forward());
            if (drive.steering() instanceof Steering.Omnidirectional) {
                double turn = speed(baseFromGoal.theta(), drive.turn());
                return Optional.of(new Twist2d(speed * Math.cos(bearing), speed * Math.sin(bearing), turn));
            }
            double ahead = Math.abs(bearing) < AHEAD ? speed : 0;
            return Optional.of(new Twist2d(ahead, 0, speed(bearing, drive.turn())));
        };
    }

    /// Drives at a speed, in the direction of a heading as soon as it looks there.
    static ClientCommand along(double velocity, double odomHeading, Drive drive) {
        return odometry -> {
            double left = Angles.difference(odometry.odomFromBase().theta(), odomHeading);
            return Optional.of(new Twist2d(velocity, 0, speed(left, drive.turn())));
        };
    }

    /// At which it still comes to rest after what is left.
    private static double speed(double left, Axis axis) {
        double acceleration = Math.max(0, axis.acceleration().reach());
        double braking = Math.min(GAIN * Math.abs(left), Math.sqrt(acceleration * Math.abs(left)));
        return Interval.around0(axis.speed().reach()).clamp(Math.copySign(braking, left));
    }
}
