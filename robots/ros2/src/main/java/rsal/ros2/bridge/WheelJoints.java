package rsal.ros2.bridge;

import java.time.Duration;
import java.time.Instant;
import java.util.LinkedHashMap;
import java.util.Map;
import rsal.data.ActuatorState;
import rsal.data.ActuatorState.Joint;
import rsal.data.ActuatorState.Motion;
import rsal.data.Angles;
import rsal.data.Interval;
import rsal.data.Odometry;
import rsal.data.Pose2d;
import rsal.data.Stamped;
import rsal.data.Twist2d;
import rsal.robot.RobotModel.Drive;
import rsal.robot.RobotModel.Wheels;
import rsal.ros2.urdf.UrdfWriter;

/// How far the wheels of a differential drive have turned, as its odometry measures: that is what encoders on the
/// wheels say.
final class WheelJoints {
    private static final Interval UNLIMITED = new Interval(Double.NEGATIVE_INFINITY, Double.POSITIVE_INFINITY);

    private final Drive drive;
    private final Wheels wheels;
    private Stamped<Odometry> last;
    private double left; // [rad]
    private double right; // also

    WheelJoints(Drive drive, Wheels wheels, Stamped<Odometry> first) {
        this.drive = drive;
        this.wheels = wheels;
        this.last = first;
    }

    /// @return states of both joints, by their names in the robot's description
    Map<String, ActuatorState> turn(Stamped<Odometry> reading) {
        Pose2d step =
                last.value().odomFromBase().inverse().compose(reading.value().odomFromBase());
        double turned = Angles.wrap(step.theta());
        // the chord of the arc on which the robot drives, which is so short that it is as long
        double distance = step.x() * Math.cos(turned / 2) + step.y() * Math.sin(turned / 2);
        if (isDriven(distance, turned, last.time(), reading.time())) {
            left += (distance - turned * wheels.track() / 2) / wheels.radius();
            right += (distance + turned * wheels.track() / 2) / wheels.radius();
        }
        last = reading;
        Twist2d velocity = reading.value().velocity();
        double apart = velocity.omega() * wheels.track() / 2;
        var states = new LinkedHashMap<String, ActuatorState>();
        states.put(UrdfWriter.LEFT_WHEEL, state(left, (velocity.vx() - apart) / wheels.radius()));
        states.put(UrdfWriter.RIGHT_WHEEL, state(right, (velocity.vx() + apart) / wheels.radius()));
        return states;
    }

    /// Whether that is what the drive can do, and not odometry that was set.
    private boolean isDriven(double distance, double turned, Instant from, Instant to) {
        double seconds = Duration.between(from, to).toNanos() / 1e9;
        double twice = 2 * Math.max(seconds, 0.05);
        return Math.abs(distance) <= twice * drive.forward().speed().reach()
                && Math.abs(turned) <= twice * drive.maxTurnRate();
    }

    private static ActuatorState state(double angle, double speed) {
        return new ActuatorState(Joint.ROTATIONAL, angle, speed, UNLIMITED, speed == 0 ? Motion.IDLE : Motion.MOVING);
    }
}
