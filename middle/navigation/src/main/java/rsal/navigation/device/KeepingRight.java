package rsal.navigation.device;

import java.util.ArrayList;
import java.util.List;
import rsal.data.Point2d;
import rsal.navigation.grid.DistanceField;

/// Moves a path to the right as far as there is room, so that two who meet each other pass without a decision.
///
/// @param toNotFree how far the next wall of the map is
/// @param radius of the circle that the robot turns in [m]
record KeepingRight(DistanceField toNotFree, double radius) {
    private static final double[] SIDEWAYS = {0.5, 0.35, 0.2}; // m
    private static final double ROOM = 0.1; // m to walls
    private static final double SHORTEST = 0.05; // m

    /// @param mapFromBase where the robot is
    /// @param target on its path
    Point2d target(Point2d mapFromBase, Point2d target) {
        return shifted(target, mapFromBase, target);
    }

    /// Its first point, where the robot is, stays.
    List<Point2d> path(List<Point2d> path) {
        var right = new ArrayList<Point2d>(path.size());
        for (int i = 0; i < path.size(); i++) {
            right.add(i == 0 ? path.get(i) : shifted(path.get(i), path.get(i - 1), path.get(i)));
        }
        return right;
    }

    /// @param from where the direction begins to which it is moved to the right
    private Point2d shifted(Point2d place, Point2d from, Point2d to) {
        double length = from.distanceTo(to);
        if (length < SHORTEST) {
            return place;
        }
        double rightX = (to.y() - from.y()) / length;
        double rightY = (from.x() - to.x()) / length;
        for (double sideways : SIDEWAYS) {
            double x = place.x() + sideways * rightX;
            double y = place.y() + sideways * rightY;
            if (toNotFree.at(x, y) >= radius + ROOM) {
                return new Point2d(x, y);
            }
        }
        return place;
    }
}
