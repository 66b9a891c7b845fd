package rsal.navigation.wavefront;

import java.util.List;
import rsal.data.Point2d;

/// Plans ways over a map. May be asked on any thread, by several at once, and always finds the same.
public interface GlobalPlanner {
    /// What it plans over.
    CostMap map();

    /// Plans a way. A start where the robot can't be is left for the nearest place where it can. A goal to
    /// which no way leads is replaced by the nearest place to which one does.
    ///
    /// @param slack how far from the goal the way may end at most [m]
    /// @param obstacles that are not on the map, from which the way keeps the robot's radius
    Plan plan(Point2d start, Point2d goal, double slack, List<Point2d> obstacles);
}
