package rsal.behavior;

import java.util.List;
import rsal.data.Footprint;
import rsal.data.Point2d;
import rsal.data.Twist2d;

/// A robot's outline, for looking ahead whether it will touch something.
final class Body {
    private static final double STEP = 0.05; // s; at most 3 cm of way

    private final double[] normalX;
    private final double[] normalY;
    private final double[] offset;
    private final double radius;

    Body(Footprint footprint) {
        List<Point2d> corners = footprint.corners();
        normalX = new double[corners.size()];
        normalY = new double[corners.size()];
        offset = new double[corners.size()];
        for (int i = 0; i < corners.size(); i++) {
            Point2d a = corners.get(i);
            Point2d b = corners.get((i + 1) % corners.size());
            double length = a.distanceTo(b);
            normalX[i] = (b.y() - a.y()) / length;
            normalY[i] = (a.x() - b.x()) / length;
            offset[i] = normalX[i] * a.x() + normalY[i] * a.y();
        }
        radius = footprint.circumscribedRadius();
    }

    /// Of the circle around the base's origin that holds the body [m].
    double radius() {
        return radius;
    }

    /// How far a point is outside the body [m], or a bit less where a corner is nearest; negative inside.
    private double gap(double x, double y) {
        double gap = Double.NEGATIVE_INFINITY;
        for (int i = 0; i < offset.length; i++) {
            gap = Math.max(gap, normalX[i] * x + normalY[i] * y - offset[i]);
        }
        return gap;
    }

    /// How long the robot may move like this until it comes nearer to something than a margin, if nothing else
    /// moves [s]. Things that are nearer already only count once they come closer still.
    ///
    /// @return at most the horizon
    double timeToTouch(Surroundings surroundings, Twist2d twist, double margin, double horizon) {
        double reach = radius + margin + twist.speed() * horizon;
        double first = horizon;
        for (int i = 0; i < surroundings.things(); i++) {
            double x = surroundings.x(i);
            double y = surroundings.y(i);
            if (x * x + y * y < reach * reach) {
                first = Math.min(first, timeToTouch(x, y, twist, margin, first));
            }
        }
        return first;
    }

    private double timeToTouch(double x, double y, Twist2d twist, double margin, double horizon) {
        double before = gap(x, y);
        double allowed = Math.min(margin, before - 1e-4);
        double cos = Math.cos(twist.omega() * STEP);
        double sin = Math.sin(twist.omega() * STEP);
        double px = x;
        double py = y;
        for (double t = STEP; t <= horizon; t += STEP) {
            double dx = px - twist.vx() * STEP; // the thing moves the other way, seen from the robot
            double dy = py - twist.vy() * STEP;
            px = cos * dx + sin * dy;
            py = cos * dy - sin * dx;
            if (gap(px, py) < allowed) {
                return t - STEP;
            }
        }
        return horizon;
    }
}
