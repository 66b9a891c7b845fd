package rsal.behavior;

import java.util.List;
import rsal.data.Footprint;
import rsal.data.Point2d;
import rsal.data.Twist2d;

/// A robot's outline, for looking ahead whether it will touch something.
final class BodyOutline {
    private static final double STEP = 0.05; // s; at most 3 cm of way
    private static final double ROUNDING = 1e-9; // m, far more than what is lost in a hundred steps

    private final double[] normalX;
    private final double[] normalY;
    private final double[] offset;
    private final double radius;

    BodyOutline(Footprint footprint) {
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

    /// How far a point is outside the body [m], or a bit less where a corner is nearest; negative inside. Moving the
    /// point by some way changes it by no more than that way.
    private double gap(double x, double y) {
        double gap = Double.NEGATIVE_INFINITY;
        for (int i = 0; i < offset.length; i++) {
            gap = Math.max(gap, beyond(i, x, y));
        }
        return gap;
    }

    /// How far a point is beyond the line through a side [m].
    private double beyond(int side, double x, double y) {
        return normalX[side] * x + normalY[side] * y - offset[side];
    }

    /// How long the robot may move like this until it comes nearer to something than a margin, if nothing else
    /// moves [s]. Things that are nearer already only count once they come closer still. Looks at each step of
    /// 0.05 s at which it may be that near.
    ///
    /// @return at most the horizon
    double timeToTouch(Surroundings surroundings, Twist2d twist, double margin, double horizon) {
        double reach = radius + margin + twist.speed() * horizon;
        double first = horizon;
        for (int i = 0; i < surroundings.things(); i++) {
            double x = surroundings.x(i);
            double y = surroundings.y(i);
            if (x * x + y * y < reach * reach) {
                double before = gap(x, y);
                double allowed = Math.min(margin, before - 1e-4);
                if (!isPassed(x, y, twist, allowed)) {
                    first = Math.min(first, timeToTouch(x, y, twist, before, allowed, first));
                }
            }
        }
        return first;
    }

    /// Whether a robot that drives straight on leaves a thing beside or behind it: beyond a side that does not come
    /// nearer to it.
    private boolean isPassed(double x, double y, Twist2d twist, double allowed) {
        if (twist.omega() == 0) {
            for (int i = 0; i < offset.length; i++) {
                boolean nears = normalX[i] * twist.vx() > 0 || normalY[i] * twist.vy() > 0;
                if (!nears && beyond(i, x, y) >= allowed) {
                    return true;
                }
            }
        }
        return false;
    }

    /// @param before how far the thing is from the body now [m]
    /// @param allowed how near it may come [m]
    private double timeToTouch(double x, double y, Twist2d twist, double before, double allowed, double horizon) {
        double farthest = Math.sqrt(x * x + y * y) + twist.speed() * horizon;
        double distance =
                (twist.speed() + Math.abs(twist.omega()) * farthest) * STEP; // of the thing in a step, at most
        double cos = Math.cos(twist.omega() * STEP);
        double sin = Math.sin(twist.omega() * STEP);
        double px = x;
        double py = y;
        double free = (before - allowed - ROUNDING) / distance; // steps in which it can't come so near
        for (double t = STEP; t <= horizon; t += STEP) {
            double dx = px - twist.vx() * STEP; // the thing moves the other way, seen from the robot
            double dy = py - twist.vy() * STEP;
            px = cos * dx + sin * dy;
            py = cos * dy - sin * dx;
            if (--free < 0) {
                double gap = gap(px, py);
                if (gap < allowed) {
                    return t - STEP;
                }
                free = (gap - allowed - ROUNDING) / distance;
            }
        }
        return horizon;
    }
}
