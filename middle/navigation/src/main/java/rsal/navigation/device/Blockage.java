package rsal.navigation.device;

import java.time.Duration;
import java.util.Locale;
import java.util.function.Predicate;
import rsal.data.Point2d;
import rsal.navigation.avoid.Obstacles;

/// Says why a robot gives up: what it tried, what is left, and what is near it.
///
/// @param patience for how long it got no nearer
/// @param backedOff how often
/// @param shunted how often it turned to and fro
/// @param detours ways that it took because of what is not on the map
record Blockage(Duration patience, int backedOff, int shunted, int detours) {
    /// @param left of the way [m]
    String onTheWay(double left, Obstacles around, Predicate<Point2d> onMap) {
        return sentence("%.1f m of way are left".formatted(left), around, onMap);
    }

    /// @param left of the turn at the goal [rad]
    String turning(double left, Obstacles around, Predicate<Point2d> onMap) {
        return sentence("it is there, but has %.0f° to turn".formatted(Math.toDegrees(left)), around, onMap);
    }

    private String sentence(String left, Obstacles around, Predicate<Point2d> onMap) {
        return String.format(
                Locale.ROOT,
                "It got no nearer for %d s: backed off %s,%s took %d detours; %s. %s",
                patience.toSeconds(),
                times(backedOff),
                shunted == 0 ? "" : " turned to and fro %s,".formatted(times(shunted)),
                detours,
                left,
                nearest(around, onMap));
    }

    private static String times(int count) {
        return count == 1 ? "once" : "%d times".formatted(count);
    }

    private static String nearest(Obstacles around, Predicate<Point2d> onMap) {
        double least = Double.POSITIVE_INFINITY;
        int nearest = -1;
        for (int i = 0; i < around.count(); i++) {
            double distance = Math.hypot(around.x(i), around.y(i));
            if (distance < least) {
                least = distance;
                nearest = i;
            }
        }
        if (nearest < 0) {
            return "Nothing is near it.";
        }
        Point2d place = around.at(nearest);
        return String.format(
                Locale.ROOT,
                "Nearest is something that is %son the map, %.2f m %s its middle.",
                onMap.test(place) ? "" : "not ",
                least,
                side(Math.toDegrees(Math.atan2(place.y(), place.x()))));
    }

    private static String side(double degrees) {
        if (Math.abs(degrees) <= 45) {
            return "ahead of";
        }
        return Math.abs(degrees) >= 135 ? "behind" : degrees > 0 ? "to the left of" : "to the right of";
    }
}
