package rsal.agents.exploration;

import java.time.Duration;
import java.time.Instant;
import org.jspecify.annotations.Nullable;
import rsal.behavior.Behavior;
import rsal.behavior.Percept;
import rsal.data.Angles;
import rsal.data.Twist2d;

/// Turns in place until it has looked in all directions: to the left, and where that is held up, as by a wall beside
/// the robot's tail, back and to the right. It is done, too, once both are.
final class LookAround implements Behavior {
    private static final double STILL = 1e-3; // rad; less is not a turn

    private final double rate;
    private final double enough;
    private final Duration patience;
    private double heading; // from where it began, more than once around, too
    private double leftmost;
    private double rightmost;
    private boolean right;
    private boolean done;
    private double before = Double.NaN;
    private @Nullable Instant held;

    /// @param rate to turn at [rad/s]
    /// @param enough of directions to have looked in [rad]
    /// @param patience with being held up, before it turns the other way
    LookAround(double rate, double enough, Duration patience) {
        this.rate = rate;
        this.enough = enough;
        this.patience = patience;
    }

    boolean isDone() {
        return done;
    }

    @Override
    public Twist2d act(Percept percept, Twist2d below) {
        double now = percept.odometry().odomFromBase().theta();
        double turned = Double.isNaN(before) ? 0 : Angles.difference(before, now);
        before = now;
        heading += turned;
        leftmost = Math.max(leftmost, heading);
        rightmost = Math.min(rightmost, heading);
        boolean heldUp = isHeldUp(percept.time(), Math.abs(turned));
        done |= leftmost - rightmost >= enough || (heldUp && !turnsBack());
        return done ? Twist2d.STOP : Twist2d.drive(0, right ? -rate : rate);
    }

    private boolean isHeldUp(Instant now, double turned) {
        if (held == null || turned > STILL) {
            held = now;
        }
        return held.plus(patience).isBefore(now);
    }

    /// @return false when it does already
    private boolean turnsBack() {
        boolean may = !right;
        right = true;
        held = null;
        return may;
    }
}
