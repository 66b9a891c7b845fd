package rsal.sim;

import rsal.data.Twist2d;
import rsal.robot.RobotModel.Axis;
import rsal.robot.RobotModel.Drive;
import rsal.robot.RobotModel.Steering;

/// The speeds of a drive: how they follow what is wanted, within what its motors can do.
final class WheelSpeeds {
    private final Drive drive;
    private final Motor forward;
    private final Motor left;
    private final Motor turn;
    private final double turningRadius; // [m]

    WheelSpeeds(Drive drive) {
        this.drive = drive;
        forward = new Motor(drive.forward());
        left = new Motor(drive.sideways());
        turn = new Motor(drive.turn());
        turningRadius = drive.steering() instanceof Steering.Car car ? car.turningRadius() : 0;
    }

    /// One step on: speeds up or slows down towards what is wanted, as far as that is [Drive#feasible], each speed at
    /// its own constant acceleration, then holds it. A car bends its way no more than its wheels let it at any
    /// speed, so that it turns less while it is still slow.
    ///
    /// @param dt [s]
    void spin(Twist2d wanted, double dt) {
        Twist2d feasible = drive.feasible(wanted);
        forward.spin(feasible.vx(), dt);
        left.spin(feasible.vy(), dt);
        turn.spin(feasible.omega(), dt);
        if (turningRadius > 0) {
            turn.cut(Math.abs(forward.speed) / turningRadius, Math.abs(forward.distance) / turningRadius);
        }
    }

    /// They stand still at once.
    void block() {
        forward.speed = 0;
        left.speed = 0;
        turn.speed = 0;
    }

    /// Forward in the last step, if nothing was in the way [m].
    double forward() {
        return forward.distance;
    }

    /// To the left in the last step, if nothing was in the way [m].
    double left() {
        return left.distance;
    }

    /// Counter-clockwise in the last step, if nothing was in the way [rad].
    double turn() {
        return turn.distance;
    }

    Twist2d velocity() {
        return new Twist2d(forward.speed, left.speed, turn.speed);
    }

    /// What makes one of the speeds.
    private static final class Motor {
        private final double least; // acceleration
        private final double most;
        private double speed;
        private double distance; // in the last step

        Motor(Axis axis) {
            least = axis.acceleration().least();
            most = axis.acceleration().most();
        }

        void spin(double wanted, double dt) {
            double before = speed;
            speed = Math.clamp(wanted, before + least * dt, before + most * dt);
            distance = made(before, dt);
        }

        /// The way made while a speed changes at a constant rate and then stays.
        private double made(double before, double dt) {
            double change = speed - before;
            return change == 0 ? speed * dt : speed * dt - change * Math.abs(change) / (change > 0 ? most : -least) / 2;
        }

        void cut(double mostSpeed, double mostWay) {
            speed = Math.clamp(speed, -mostSpeed, mostSpeed);
            distance = Math.clamp(distance, -mostWay, mostWay);
        }
    }
}
