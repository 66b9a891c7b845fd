package rsal.navigation.device;

import java.time.Duration;
import java.util.Locale;
import java.util.Map;
import java.util.function.Predicate;
import java.util.stream.Collectors;
import rsal.data.Point2d;
import rsal.navigation.avoid.Obstacles;

/// Says why a robot gives up: what it tried, what is left, and what is near it.
///
/// @param patience for how long it made no progress
/// @param recoveries how often each was tried
/// @param detours paths that it took because of what is not on the map
record Blockage(Duration patience, Map<String, Integer> recoveries, int detours) {
    /// @param atGoal whether only the turn at the goal is missing
    /// @param left of that turn [rad], else of the path [m]
    /// @param onMap whether a place in the base frame is on the map
    String sentence(boolean atGoal, double left, Obstacles around, Predicate<Point2d> onMap) {
        return String.format(
                Locale.ROOT,
                "The robot made no progress for %d s: %s It took %s and tried %s. %s",
                patience.toSeconds(),
                atGoal
                        ? "it is at the goal, but has %.0f° to turn.".formatted(Math.toDegrees(left))
                        : "%.1f m of its path are left.".formatted(left),
                detours == 1 ? "1 detour" : detours + " detours",
                recoveries.isEmpty() ? "no recovery" : tried(),
                nearest(around, onMap));
    }

    private String tried() {
        return recoveries.entrySet().stream()
                .map(entry -> "'%s' %s".formatted(entry.getKey(), times(entry.getValue())))
                .collect(Collectors.joining(", "));
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
            return "No obstacle is near.";
        }
        Point2d place = around.at(nearest);
        return String.format(
                Locale.ROOT,
                "The nearest obstacle is %son the map, %.2f m %s its center.",
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
