package rsal.navigation.avoid;

import java.util.List;
import rsal.data.Footprint;
import rsal.data.Point2d;
import rsal.data.Twist2d;
import rsal.navigation.avoid.Controller.Motion;
import rsal.navigation.avoid.Controller.Target;

/// The last word of a local planner: a [CollisionMonitor], turning in place, and what to do where the robot is
/// too long to turn. So it knows where the robot goes on. Each robot needs its own.
public final class VelocityFilter {
    /// Room that is kept from all obstacles [m]: about what odometry and scans are wrong within a robot's length.
    public static final double MARGIN = 0.04;

    private static final double STEERING = 2.0; // 1/s; turn rate per angle that is missing
    private static final double CREEP = 0.08; // m/s
    private static final double SMALL = Math.toRadians(5); // not worth creeping for

    private final DriveLimits limits;
    private final CollisionMonitor guard;
    private final TrajectoryPreview ahead = new TrajectoryPreview();
    private double creeping; // m/s

    /// @param reaction how long a command lasts before the next one can take effect [s]
    public VelocityFilter(Footprint footprint, DriveLimits limits, double reaction) {
        this.limits = limits;
        this.guard = new CollisionMonitor(footprint, limits, MARGIN, reaction);
    }

    /// How much room to keep beside the circle that fits into the outline [m]: what is asked for as a rule. A body that
    /// is wider somewhere than that circle, as one behind or before its axis, could not drive straight on there: it
    /// needs its width, and beside it what is kept from all obstacles, or what is asked for if that is less.
    ///
    /// @param asked to keep beside the circle [m]
    public static double room(Footprint footprint, double asked) {
        return Math.max(asked, footprint.halfWidth() + Math.min(asked, MARGIN) - footprint.inscribedRadius());
    }

    /// What of a command is safe.
    public Twist2d guarded(Twist2d wanted, Twist2d velocity, Obstacles obstacles) {
        Twist2d safe = guard.limit(wanted, velocity, obstacles);
        ahead.on(safe);
        return safe;
    }

    /// What of a command is safe. Where the robot is too long to turn, it creeps on or back first, until it can
    /// turn or can't creep any more.
    ///
    /// @param turn that is missing [rad]
    public Twist2d guarded(Twist2d wanted, double turn, Twist2d velocity, Obstacles obstacles) {
        Twist2d command = safeOrCreeping(wanted, turn, velocity, obstacles);
        ahead.into(turn, command);
        return command;
    }

    private Twist2d safeOrCreeping(Twist2d wanted, double turn, Twist2d velocity, Obstacles obstacles) {
        Twist2d safe = guard.limit(wanted, velocity, obstacles);
        boolean wedged = Math.abs(safe.vx()) < CREEP / 4 && Math.abs(safe.omega()) < Math.abs(wanted.omega()) / 2;
        if (!wedged || Math.abs(turn) < SMALL) {
            creeping = 0;
            return safe;
        }
        if (creeping == 0) {
            creeping = Math.abs(turn) < Math.PI / 2 ? CREEP : -CREEP;
        }
        for (int way = 0; way < 2; way++) {
            Twist2d crept = guard.limit(Twist2d.drive(creeping, 0), velocity, obstacles);
            if (crept.vx() == creeping) {
                return crept;
            }
            creeping = -creeping;
        }
        return safe;
    }

    /// Drives towards a direction, the slower the more it has to turn for that, not at all beyond a right angle.
    ///
    /// @param direction in the base frame [rad]
    /// @param share of the highest speed to drive at where it need not turn, 0–1
    public Twist2d towards(double direction, double share, Target target, Motion motion, Obstacles obstacles) {
        double turn = Math.clamp(direction, -Math.PI / 2, Math.PI / 2);
        double omega = limits.turnRate() * turn / (Math.PI / 2);
        double straight = 1 - Math.abs(turn) / (Math.PI / 2);
        double speed = limits.speed() * share * straight;
        if (target.arriving()) {
            speed = Math.min(speed, limits.arriving(target.distance()));
        }
        Twist2d command = guarded(Twist2d.drive(speed, omega), direction, motion.velocity(), obstacles);
        arrivesAt(target);
        return command;
    }

    /// Turns in place by an angle [rad].
    public Twist2d turn(double angle, Twist2d velocity, Obstacles obstacles) {
        double most = Math.min(limits.turnRate(), Math.sqrt(limits.turnAcceleration() * Math.abs(angle)));
        double omega = Math.clamp(STEERING * angle, -most, most);
        return guarded(Twist2d.drive(0, omega), angle, velocity, obstacles);
    }

    /// What it let through last is nothing: the robot is to stand.
    public void stands() {
        ahead.nowhere();
    }

    /// What it let through last leads so far at most [m].
    public void upTo(double longest) {
        ahead.upTo(longest);
    }

    /// What it let through last leads to a target, and not past it if it is to come to rest there.
    public void arrivesAt(Target target) {
        if (target.arriving()) {
            ahead.upTo(target.distance());
        }
    }

    /// Where what it let through last leads within 2 s, as [Controller#way] has it: on its arc, or into the
    /// direction that it turns to.
    public List<Point2d> predictedTrajectory() {
        return ahead.points();
    }

    /// Forgets what it did.
    public void reset() {
        creeping = 0;
        ahead.nowhere();
    }
}
