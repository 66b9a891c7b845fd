package rsal.sim.world;

import rsal.data.Pose2d;

/// How a body goes on along what it touches: first it makes the rest of its way, as far as that leads past, then it
/// turns by the rest of its turn, as far as there is room. There is no friction, unless its way leads almost straight
/// into what it touches. It is swept like any other way, so that sliding leads through nothing.
final class Sliding {
    private static final double NUDGE = 0.0001; // [m]; to feel where something is, less than bodies keep off
    private static final double NEARBY = 0.01; // [m]
    private static final double STEEP = 0.1; // share of a way that leads past; of less, friction leaves nothing
    private static final double OFF = 0.001; // how much farther from what it touches, per way: more than rounding
    private static final int BENDS = 3; // in one step

    private final World world;
    private final Body body;

    Sliding(World world, Body body) {
        this.world = world;
        this.body = body;
    }

    /// @param arc on which it was stopped
    /// @param made part of the arc that it made
    /// @return whether it moved
    boolean goOn(Arc arc, double made) {
        Pose2d end = arc.at(1);
        double x = end.x() - body.pose().x();
        double y = end.y() - body.pose().y();
        double worthIt = STEEP * Math.hypot(x, y);
        boolean moved = false;
        for (int bend = 0; bend < BENDS && Math.hypot(x, y) > 0; bend++) {
            double awayX = roomAt(NUDGE, 0) - roomAt(-NUDGE, 0);
            double awayY = roomAt(0, NUDGE) - roomAt(0, -NUDGE);
            double length = Math.hypot(awayX, awayY);
            if (length > 0) {
                double into = Math.min(0, x * awayX + y * awayY) / (length * length);
                x -= into * awayX;
                y -= into * awayY;
                double off = OFF * Math.hypot(x, y) / length;
                x += off * awayX;
                y += off * awayY;
            }
            if (Math.hypot(x, y) < worthIt) {
                break;
            }
            double part = world.sweep(body, straight(body.pose(), x, y));
            moved |= part > 0;
            x *= 1 - part;
            y *= 1 - part;
        }
        var turn = new Arc(body.pose(), 0, 0, arc.turn() * (1 - made));
        boolean turned = turn.turn() != 0 && world.sweep(body, turn) > 0;
        return moved || turned;
    }

    /// How much room it would have elsewhere [m].
    private double roomAt(double dx, double dy) {
        Pose2d at = body.pose();
        body.trial.placeAt(new Pose2d(at.x() + dx, at.y() + dy, at.theta()), body.height());
        return world.clearance(body.trial, body, NEARBY);
    }

    private static Arc straight(Pose2d from, double dx, double dy) {
        double cos = StrictMath.cos(from.theta());
        double sin = StrictMath.sin(from.theta());
        return new Arc(from, cos * dx + sin * dy, cos * dy - sin * dx, 0);
    }
}
