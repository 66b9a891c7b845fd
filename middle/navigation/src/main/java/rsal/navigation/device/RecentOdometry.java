package rsal.navigation.device;

import java.time.Duration;
import java.time.Instant;
import java.util.ArrayDeque;
import java.util.Deque;
import java.util.Optional;
import rsal.data.Odometry;
import rsal.data.Pose2d;
import rsal.data.Stamped;

/// The newest readings of odometry, which tell where a robot was when something was measured between them: scans may
/// come late.
final class RecentOdometry {
    /// For so long they are kept, two at least.
    private static final Duration KEPT = Duration.ofSeconds(1);
    /// What was measured by no more than this before the robot was heard of first, was measured where it is then.
    private static final Duration SLACK = Duration.ofMillis(500);

    private final Deque<Stamped<Odometry>> readings = new ArrayDeque<>(); // oldest first

    /// @param odometry no older than those before; an older one begins again, as its clock was set
    void add(Stamped<Odometry> odometry) {
        if (!readings.isEmpty() && odometry.time().isBefore(readings.getLast().time())) {
            readings.clear();
        }
        readings.add(odometry);
        Instant border = odometry.time().minus(KEPT);
        while (readings.size() > 2 && readings.getFirst().time().isBefore(border)) {
            readings.removeFirst();
        }
    }

    /// Where the base is now, as far as it is known.
    Optional<Pose2d> newest() {
        return Optional.ofNullable(readings.peekLast()).map(RecentOdometry::pose);
    }

    /// Where the base was at a time: between two of them, or at the newest when that is older. Empty before the first,
    /// and when nothing tells any more.
    Optional<Pose2d> odomFromBase(Instant time) {
        if (readings.isEmpty() || hasForgotten(time)) {
            return Optional.empty();
        }
        Stamped<Odometry> later = readings.getLast();
        if (!time.isBefore(later.time())) {
            return Optional.of(pose(later));
        }
        for (var older = readings.descendingIterator(); older.hasNext(); ) {
            Stamped<Odometry> earlier = older.next();
            if (!time.isBefore(earlier.time())) {
                double share = seconds(earlier.time(), time) / seconds(earlier.time(), later.time());
                return Optional.of(pose(earlier).towards(pose(later), share));
            }
            later = earlier;
        }
        return Optional.of(pose(later));
    }

    /// Whether nothing tells any more where the base was at a time, though it has been told of since.
    boolean hasForgotten(Instant time) {
        if (readings.isEmpty()) {
            return false;
        }
        Instant oldest = readings.getFirst().time();
        boolean full = !readings.getLast().time().isBefore(oldest.plus(KEPT));
        return time.isBefore(full ? oldest : oldest.minus(SLACK));
    }

    private static Pose2d pose(Stamped<Odometry> reading) {
        return reading.value().odomFromBase();
    }

    private static double seconds(Instant from, Instant to) {
        return Duration.between(from, to).toNanos() / 1e9;
    }
}
