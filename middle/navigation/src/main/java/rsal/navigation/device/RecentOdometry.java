package rsal.navigation.device;

import java.time.Duration;
import java.time.Instant;
import java.util.Optional;
import org.jspecify.annotations.Nullable;
import rsal.data.Odometry;
import rsal.data.Pose2d;
import rsal.data.Stamped;

/// The two newest readings of odometry, which tell where a robot was when something was measured between them.
final class RecentOdometry {
    private @Nullable Stamped<Odometry> older;
    private @Nullable Stamped<Odometry> newest;

    void add(Stamped<Odometry> odometry) {
        older = newest;
        newest = odometry;
    }

    /// Where the base is now, as far as it is known.
    Optional<Pose2d> newest() {
        return Optional.ofNullable(newest).map(reading -> reading.value().odomFromBase());
    }

    /// Where the base was at a time: between the two, or at the newest when that is older. Empty before the first.
    Optional<Pose2d> odomFromBase(Instant time) {
        if (newest == null) {
            return Optional.empty();
        }
        Pose2d to = newest.value().odomFromBase();
        if (older == null || !time.isBefore(newest.time())) {
            return Optional.of(to);
        }
        double span = seconds(older.time(), newest.time());
        double share = span > 0 ? Math.clamp(seconds(older.time(), time) / span, 0, 1) : 1;
        return Optional.of(older.value().odomFromBase().towards(to, share));
    }

    private static double seconds(Instant from, Instant to) {
        return Duration.between(from, to).toNanos() / 1e9;
    }
}
