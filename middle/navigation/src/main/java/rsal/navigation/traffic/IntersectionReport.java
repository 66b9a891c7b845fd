package rsal.navigation.traffic;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import rsal.data.Point2d;
import rsal.data.Pose2d;

/// Where a robot is, and how it crosses a junction. All places in the map frame. Robots compare paths, so they need not
/// agree on where junctions are.
///
/// @param number counts the reports of a robot; an older one that comes later does not count
/// @param radius of the circle that it turns in [m]
/// @param claim what it wants to cross, or crosses; empty for nothing
/// @param waits whether it stands for others, and goes on when it may
/// @param isAsking whether it wants an answer
/// @param heard newest ticket that it has heard of each robot, by id
public record IntersectionReport(
        long number,
        Pose2d mapFromBase,
        double radius,
        Optional<Claim> claim,
        boolean waits,
        boolean isAsking,
        Map<String, Long> heard) {
    public IntersectionReport {
        heard = Map.copyOf(heard);
    }

    /// @param ticket the lower one goes first
    /// @param isHeld whether the robot crosses, else it wants to
    /// @param mapFromEntry where its path comes in, with its direction there
    /// @param path points of what is left of it in the junction
    public record Claim(long ticket, boolean isHeld, Pose2d mapFromEntry, List<Point2d> path) {
        public Claim {
            path = List.copyOf(path);
        }

        /// Whether two robots come in by the same lane.
        boolean comesWith(Claim other) {
            return mapFromEntry.distanceTo(other.mapFromEntry) < 0.7
                    && Math.cos(mapFromEntry.theta() - other.mapFromEntry.theta()) > 0;
        }

        /// Whether two paths come nearer than a distance [m].
        boolean meets(Claim other, double within) {
            for (Point2d one : path) {
                for (Point2d place : other.path) {
                    if (one.distanceTo(place) < within) {
                        return true;
                    }
                }
            }
            return false;
        }

        /// How far a place is behind the entry, in its direction [m]; negative before it.
        double progress(Point2d place) {
            return (place.x() - mapFromEntry.x()) * Math.cos(mapFromEntry.theta())
                    + (place.y() - mapFromEntry.y()) * Math.sin(mapFromEntry.theta());
        }
    }
}
