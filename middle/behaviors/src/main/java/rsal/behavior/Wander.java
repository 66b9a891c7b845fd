package rsal.behavior;

import rsal.data.Footprint;
import rsal.data.Twist2d;

/// Drives ahead as long as there is room for its body, then turns on the spot to the side where there is more of
/// it, and on to that side until there is room ahead again.
public final class Wander implements Behavior {
    private static final double MARGIN = 0.1; // m beside the body
    private static final double HORIZON = 2; // s
    private static final double TURN_RATE = 0.8; // rad/s
    private static final double LOOK_AHEAD = 0.8; // m
    private static final double ASIDE = Math.toRadians(60);

    private final double speed;
    private final BodyOutline body;
    private double side; // 1 left, −1 right; 0 while there is room ahead

    /// @param speed where there is room [m/s]
    public Wander(Footprint footprint, double speed) {
        this.speed = speed;
        this.body = new BodyOutline(footprint);
    }

    @Override
    public String state() {
        return side == 0 ? "" : "turning";
    }

    @Override
    public Twist2d act(Percept percept, Twist2d below) {
        Surroundings around = percept.surroundings();
        Twist2d ahead = Twist2d.drive(speed, 0);
        if (body.timeToTouch(around, ahead, MARGIN, HORIZON) >= HORIZON) {
            side = 0;
            return ahead;
        }
        if (side == 0) {
            side = around.clearance(-ASIDE, LOOK_AHEAD) > around.clearance(ASIDE, LOOK_AHEAD) ? -1 : 1;
        }
        return Twist2d.drive(0, side * TURN_RATE);
    }
}
