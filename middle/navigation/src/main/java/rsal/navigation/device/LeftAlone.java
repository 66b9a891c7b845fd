package rsal.navigation.device;

import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import rsal.data.Point2d;
import rsal.data.Pose2d;
import rsal.navigation.grid.ScanMapper.PosedScan;

/// Frontiers to which nobody is sent, as a robot was there or couldn't get there. Each has one more chance after a
/// while, since what stood in the way may have gone, and all of them when a loop closed, since then they lie
/// elsewhere.
final class LeftAlone {
    static final Duration WHILE = Duration.ofMinutes(10);
    private static final double SAME = 0.7; // m; places that are nearer are one
    private static final double MOVED = 0.3; // m; of a scan, by which the map is another

    private final List<Place> places = new ArrayList<>();
    private final List<List<Pose2d>> maps = new ArrayList<>(); // by robot, where its scans were

    private record Place(Point2d place, Instant since, boolean again) {}

    void add(Point2d place, Instant now) {
        boolean again = places.removeIf(known -> isSame(known.place, place));
        places.add(new Place(place, now, again));
    }

    /// Those to which nobody is to be sent now.
    List<Point2d> at(Instant now) {
        return places.stream()
                .filter(p -> p.again || p.since.plus(WHILE).isAfter(now))
                .map(Place::place)
                .toList();
    }

    static boolean isSame(Point2d one, Point2d other) {
        return one.distanceTo(other) < SAME;
    }

    /// Learns where scans lie now.
    ///
    /// @param scans by robot, in the order in which they joined
    void follow(List<List<PosedScan>> scans) {
        for (int robot = 0; robot < scans.size(); robot++) {
            if (maps.size() <= robot) {
                maps.add(new ArrayList<>());
            }
            List<Pose2d> before = maps.get(robot);
            List<PosedScan> now = scans.get(robot);
            boolean moved = now.size() < before.size(); // another map
            for (int i = 0; i < before.size() && !moved; i++) {
                moved = before.get(i).distanceTo(now.get(i).mapFromBase()) > MOVED;
            }
            if (moved) {
                places.clear();
                before.clear();
            }
            now.stream().skip(before.size()).map(PosedScan::mapFromBase).forEach(before::add);
        }
    }
}
