package rsal.engine;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import rsal.data.Point2d;
import rsal.data.Pose2d;

/// Places that a team watches, and for how long nobody has really been at each of them.
final class PatrolMetrics {
    private static final double NEAR = 1.0; // m
    private static final double PERIOD = 1.0; // s between two samples

    private final Map<Point2d, Double> visited = new LinkedHashMap<>(); // when [s], by place
    private final Samples idleTimes = new Samples(); // s
    private double next;

    /// These are watched from now on.
    void watch(List<Point2d> mapFromPlaces, double now) {
        visited.clear();
        mapFromPlaces.forEach(place -> visited.put(place, now));
        next = now + PERIOD;
    }

    /// A robot says that it has been at a place.
    ///
    /// @param mapFromBase where it really is
    void visit(Point2d mapFromPlace, Pose2d mapFromBase, double now) {
        if (mapFromBase.position().distanceTo(mapFromPlace) <= NEAR) {
            visited.computeIfPresent(mapFromPlace, (_, _) -> now);
        }
    }

    /// Takes a sample of each place when it is time for it.
    void look(double now) {
        if (!visited.isEmpty() && now >= next) {
            next += PERIOD;
            visited.values().forEach(last -> idleTimes.add(now, now - last));
        }
    }

    /// Of each place once a second.
    Samples idleTimes() {
        return idleTimes;
    }
}
