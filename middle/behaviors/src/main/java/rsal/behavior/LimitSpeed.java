package rsal.behavior;

import rsal.data.Footprint;
import rsal.data.Twist2d;

/// Never drives faster than is safe, and slows down in time to stop a distance before what is in the way.
public final class LimitSpeed implements Behavior {
    private static final double MARGIN = 0.02; // m beside the body
    private static final double HORIZON = 3; // s
    private static final double DECELERATION = 0.4; // m/s², half of what the base can do

    private final double most;
    private final double stopDistance;
    private final BodyOutline body;

    /// @param most [m/s]
    /// @param stopDistance from the body to what is ahead [m]
    public LimitSpeed(Footprint footprint, double most, double stopDistance) {
        this.most = most;
        this.stopDistance = stopDistance;
        this.body = new BodyOutline(footprint);
    }

    @Override
    public Twist2d act(Percept percept, Twist2d below) {
        if (below.speed() == 0) {
            return below;
        }
        double speed = Math.min(below.speed(), most);
        Twist2d limited = scaled(below, speed);
        double time = body.timeToTouch(percept.surroundings(), limited, MARGIN, HORIZON);
        if (time < HORIZON) {
            double distance = Math.max(0, speed * time - stopDistance);
            limited = scaled(below, Math.min(speed, Math.sqrt(2 * DECELERATION * distance)));
        }
        return limited.equals(below) ? below : limited;
    }

    private static Twist2d scaled(Twist2d twist, double speed) {
        double share = speed / twist.speed();
        return new Twist2d(twist.vx() * share, twist.vy() * share, twist.omega());
    }
}
