package rsal.behavior;

import rsal.data.Footprint;
import rsal.data.Twist2d;

/// Never turns faster than is safe, nor into something.
public final class LimitTurnRate implements Behavior {
    private static final double MARGIN = 0.04; // m; lasers err by centimeters
    private static final double HORIZON = 0.3; // s

    private final double most;
    private final BodyOutline body;

    /// @param most [rad/s]
    public LimitTurnRate(Footprint footprint, double most) {
        this.most = most;
        this.body = new BodyOutline(footprint);
    }

    @Override
    public Twist2d act(Percept percept, Twist2d below) {
        double omega = Math.clamp(below.omega(), -most, most);
        Twist2d spin = Twist2d.drive(0, omega);
        if (omega != 0 && body.timeToTouch(percept.surroundings(), spin, MARGIN, HORIZON) < HORIZON) {
            omega = 0;
        }
        return omega == below.omega() ? below : new Twist2d(below.vx(), below.vy(), omega);
    }
}
