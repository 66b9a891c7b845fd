package rsal.agents.foraging;

import org.jspecify.annotations.Nullable;
import rsal.behavior.Behavior;
import rsal.behavior.Percept;
import rsal.data.Angles;
import rsal.data.Point2d;
import rsal.data.Pose2d;
import rsal.data.Twist2d;

/// Turns to where something should be, looks around when it is not seen there, and drives at it once it is. The last
/// bit, where a camera on top no longer sees what lies in front of the robot, it drives straight by odometry.
final class Aim implements Behavior {
    private static final double FAST = 0.25; // m/s
    private static final double SLOW = 0.06; // m/s
    private static final double GAIN = 0.6; // 1/s
    private static final double TURN_GAIN = 1.5; // 1/s
    private static final double MOST_TURN = 0.6; // rad/s
    private static final double AHEAD = Math.toRadians(20); // in which it drives
    private static final double STRAIGHT = 0.35; // m, from which on it does not turn any more
    private static final double PASSED = 0.12; // m
    private static final double FACING = Math.toRadians(5);
    private static final double LOOK = Math.toRadians(60); // to see to both sides what should be ahead
    private static final double AROUND = 2 * Math.PI + LOOK;

    private Point2d odomFromTarget;
    private boolean seen;
    private boolean faced;
    private double turned;
    private @Nullable Pose2d before;
    private double distance = Double.POSITIVE_INFINITY;

    /// @param odomFromGuess where it should be
    Aim(Point2d odomFromGuess) {
        this.odomFromTarget = odomFromGuess;
    }

    /// It is seen.
    void spot(Point2d odomFromThing) {
        odomFromTarget = odomFromThing;
        seen = true;
    }

    /// Where it is, as far as is known.
    Point2d odomFromTarget() {
        return odomFromTarget;
    }

    boolean seen() {
        return seen;
    }

    /// Whether it has looked all around and not seen it, or driven past it.
    boolean inVain() {
        return seen ? distance < PASSED : turned > AROUND;
    }

    @Override
    public Twist2d act(Percept percept, Twist2d below) {
        Pose2d odomFromBase = percept.odometry().odomFromBase();
        distance = odomFromBase.position().distanceTo(odomFromTarget);
        double bearing = odomFromBase.bearingTo(odomFromTarget);
        if (!seen) {
            return search(odomFromBase, bearing);
        }
        double turn = distance < STRAIGHT ? 0 : Math.clamp(TURN_GAIN * bearing, -MOST_TURN, MOST_TURN);
        boolean ahead = distance < STRAIGHT || Math.abs(bearing) < AHEAD;
        double speed = ahead ? Math.clamp(GAIN * (distance - PASSED), SLOW, FAST) : 0;
        return Twist2d.drive(speed, turn);
    }

    /// Faces the place, then turns all around.
    private Twist2d search(Pose2d odomFromBase, double bearing) {
        faced |= Math.abs(bearing) < FACING;
        if (!faced) {
            return Twist2d.drive(0, Math.clamp(TURN_GAIN * bearing, -MOST_TURN, MOST_TURN));
        }
        if (before != null) {
            turned += Math.abs(Angles.difference(before.theta(), odomFromBase.theta()));
        }
        before = odomFromBase;
        return Twist2d.drive(0, MOST_TURN);
    }
}
