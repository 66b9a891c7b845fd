package rsal.navigation.passage;

import java.util.ArrayList;
import java.util.List;
import org.jspecify.annotations.Nullable;
import rsal.data.Point2d;

/// A place at which three or more corridors meet in which two robots can pass each other.
///
/// @param mapFromCenter where clearance is greatest
/// @param radius within which paths of different corridors meet [m]
public record Junction(Point2d mapFromCenter, double radius) {
    private static final double STEP = 0.05; // m

    /// Whether a place is within.
    public boolean contains(Point2d mapFromPlace) {
        return mapFromCenter.distanceTo(mapFromPlace) < radius;
    }

    /// Where a path leads through it first.
    ///
    /// @param from length of path before it [m]
    /// @param to length of path to where it leaves it, or ends [m]
    public record Stretch(Junction junction, double from, double to) {}

    /// Where a path leads through any of several, in its order.
    ///
    /// @param mapFromPath corners of the path
    /// @param length of path that counts [m]
    public static List<Stretch> stretches(List<Junction> all, List<Point2d> mapFromPath, double length) {
        var found = new ArrayList<Stretch>();
        double done = 0;
        @Nullable Junction inside = null;
        double entered = 0;
        for (int leg = 1; leg < mapFromPath.size() && done < length; leg++) {
            Point2d from = mapFromPath.get(leg - 1);
            Point2d to = mapFromPath.get(leg);
            double whole = from.distanceTo(to);
            int samples = Math.max(1, (int) Math.ceil(whole / STEP));
            for (int i = 0; i <= samples && done + whole * i / samples < length; i++) {
                double share = (double) i / samples;
                var place = new Point2d(from.x() + share * (to.x() - from.x()), from.y() + share * (to.y() - from.y()));
                double at = done + share * whole;
                if (inside != null && !inside.contains(place)) {
                    found.add(new Stretch(inside, entered, at));
                    inside = null;
                }
                if (inside == null) {
                    inside = at(all, place);
                    entered = at;
                }
            }
            done += whole;
        }
        if (inside != null) {
            found.add(new Stretch(inside, entered, Math.min(done, length)));
        }
        return found;
    }

    private static @Nullable Junction at(List<Junction> all, Point2d place) {
        for (Junction junction : all) {
            if (junction.contains(place)) {
                return junction;
            }
        }
        return null;
    }
}
