package rsal.server;

import rsal.data.Twist2d;
import rsal.robot.RobotModel;
import rsal.server.Messages.Abilities;
import rsal.server.Messages.Drive;

/// How robots are driven by hand: what may be asked for.
final class Steering {
    private static final int LONGEST_NAME = 64;
    private static final double FASTEST = 100; // [m/s, rad/s]; bases keep limits of their own

    private Steering() {}

    /// @throws Refusal when nobody could be called like that
    static String driver(String name) {
        if (name.isBlank() || name.length() > LONGEST_NAME) {
            throw new Refusal(
                    400,
                    "A driver's name has 1 to %d characters; this is none: (%s)."
                            .formatted(LONGEST_NAME, Refusal.shortened(name)));
        }
        return name;
    }

    /// @throws Refusal when nothing moves like that
    static Twist2d velocity(Drive wish) {
        var velocity = new Twist2d(wish.vx(), wish.vy(), wish.omega());
        if (!(Math.abs(velocity.vx()) <= FASTEST
                && Math.abs(velocity.vy()) <= FASTEST
                && Math.abs(velocity.omega()) <= FASTEST)) {
            throw new Refusal(
                    400,
                    "Velocities are numbers up to %s m/s and rad/s, not (%s, %s) and (%s)."
                            .formatted((int) FASTEST, velocity.vx(), velocity.vy(), velocity.omega()));
        }
        return velocity;
    }

    static Abilities abilities(rsal.engine.report.Abilities robot) {
        RobotModel.Drive drive = robot.drive();
        return new Abilities(
                drive.forward().speed().most(),
                -drive.forward().speed().least(),
                drive.sideways().speed().most(),
                drive.turn().speed().most(),
                robot.behaviors(),
                robot.noBehavior(),
                robot.noGoal());
    }
}
