package rsal.navigation.traffic;

import java.util.List;
import rsal.data.Point2d;

/// What a robot says of the passages on its whole path, for who plans the traffic of all. All places in the map frame.
///
/// @param number counts the reports of a robot; an older one that comes later does not count
/// @param speed which it has lately had on free stretches [m/s], above 0
/// @param left length of its path [m]
/// @param legs in the order of its path
record RouteReport(long number, double speed, double left, List<Leg> legs) {
    RouteReport {
        legs = List.copyOf(legs);
    }

    /// Passages that follow each other so closely that no robot can wait between them.
    ///
    /// @param passages a place in each
    /// @param entry gate through which it comes
    /// @param from length of path before them [m]; 0 inside
    /// @param to length of path to their end [m]
    record Leg(List<Point2d> passages, Point2d entry, double from, double to) {
        Leg {
            passages = List.copyOf(passages);
        }
    }
}
