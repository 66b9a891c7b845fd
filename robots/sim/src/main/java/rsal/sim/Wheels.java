package rsal.sim;

import rsal.data.Twist2d;
import rsal.robot.RobotModel;

/// The speeds of a differential drive: how they follow what is wanted, within what its motors can do.
final class Wheels {
    private final RobotModel.Drive limits;
    private double speed;
    private double turnRate;
    private double distance;
    private double turn;

    Wheels(RobotModel.Drive limits) {
        this.limits = limits;
    }

    /// One step on: speeds up or slows down towards what is wanted, each speed at its own constant acceleration, then
    /// holds it. Speeds beyond the limits are cut by the same factor, which keeps the curvature.
    ///
    /// @param dt [s]
    void spin(Twist2d wanted, double dt) {
        double cut = Math.min(
                1,
                Math.min(limits.maxSpeed() / Math.abs(wanted.vx()), limits.maxTurnRate() / Math.abs(wanted.omega())));
        double oldSpeed = speed;
        double oldTurnRate = turnRate;
        speed = towards(oldSpeed, wanted.vx() * cut, limits.maxAcceleration() * dt);
        turnRate = towards(oldTurnRate, wanted.omega() * cut, limits.maxTurnAcceleration() * dt);
        distance = made(oldSpeed, speed, limits.maxAcceleration(), dt);
        turn = made(oldTurnRate, turnRate, limits.maxTurnAcceleration(), dt);
    }

    private static double towards(double now, double wanted, double most) {
        return Math.clamp(wanted, now - most, now + most);
    }

    /// The way made while a speed changes at a constant rate and then stays.
    private static double made(double from, double to, double acceleration, double dt) {
        double change = to - from;
        return to * dt - change * Math.abs(change) / acceleration / 2;
    }

    /// They stand still at once.
    void block() {
        speed = 0;
        turnRate = 0;
    }

    /// Forward in the last step, if nothing was in the way [m].
    double distance() {
        return distance;
    }

    /// Counter-clockwise in the last step, if nothing was in the way [rad].
    double turn() {
        return turn;
    }

    Twist2d velocity() {
        return Twist2d.drive(speed, turnRate);
    }
}
