package rsal.behavior;

import rsal.data.Footprint;
import rsal.data.Twist2d;

/// Looks ahead along the way that the layers below want to take. When the body would touch something soon, it
/// takes the way nearest to theirs that does not: slower, then more to one side, at last turning on the spot.
/// Where nothing is free it wants to turn, too, which the layers above it may not let it.
public final class AvoidCollision implements Behavior {
    private static final double MARGIN = 0.05; // m
    private static final double HORIZON = 1.0; // s
    private static final double[] SPEEDS = {1, 0.5, 0};
    private static final double[] TURNS = {0, 0.3, -0.3, 0.6, -0.6, 1, -1}; // rad/s more

    private static final double TURN_ANYWAY = 0.6; // rad/s

    private final BodyOutline body;

    public AvoidCollision(Footprint footprint) {
        this.body = new BodyOutline(footprint);
    }

    @Override
    public Twist2d act(Percept percept, Twist2d below) {
        if (isFree(percept, below)) {
            return below;
        }
        double side = below.omega() < 0 ? -1 : 1;
        for (double speed : SPEEDS) {
            for (double turn : TURNS) {
                Twist2d other = Twist2d.drive(below.vx() * speed, below.omega() + side * turn);
                if (!other.equals(Twist2d.STOP) && isFree(percept, other)) { // or it would stand there for ever
                    return other;
                }
            }
        }
        return Twist2d.drive(0, side * TURN_ANYWAY);
    }

    private boolean isFree(Percept percept, Twist2d twist) {
        return body.timeToTouch(percept.surroundings(), twist, MARGIN, HORIZON) >= HORIZON;
    }
}
