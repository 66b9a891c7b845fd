package rsal.agents.pursuit.strategy;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.HashMap;
import java.util.Map;
import rsal.data.Point2d;

/// How fast and whereto robots drive, by their poses of the last seconds.
final class Direction {
    private static final double MEMORY = 2.5; // s
    private static final double LEAST = 0.5; // s between two poses that give a velocity

    private record Seen(double time, Point2d place) {}

    private final Map<String, Deque<Seen>> tracks = new HashMap<>(); // only looked up by id

    void note(String robot, double time, Point2d place) {
        Deque<Seen> track = tracks.computeIfAbsent(robot, _ -> new ArrayDeque<>());
        track.addLast(new Seen(time, place));
        while (track.getFirst().time < time - MEMORY) {
            track.removeFirst();
        }
    }

    /// [m/s]; zero while little is known.
    Point2d velocity(String robot) {
        Deque<Seen> track = tracks.getOrDefault(robot, new ArrayDeque<>());
        if (track.isEmpty()) {
            return new Point2d(0, 0);
        }
        Seen first = track.getFirst();
        Seen last = track.getLast();
        double time = last.time - first.time;
        return time < LEAST
                ? new Point2d(0, 0)
                : new Point2d((last.place.x() - first.place.x()) / time, (last.place.y() - first.place.y()) / time);
    }
}
