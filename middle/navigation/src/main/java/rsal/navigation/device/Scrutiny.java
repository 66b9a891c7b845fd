package rsal.navigation.device;

import java.time.Duration;
import java.time.Instant;
import java.util.Optional;
import org.jspecify.annotations.Nullable;
import rsal.data.LaserScan;
import rsal.data.Odometry;
import rsal.data.Stamped;

/// Looks at what a laser and wheels say before anything is made of it, and counts what is not to be used: what is
/// out of order in time, has another number of beams than before, or no number where one must be.
final class Scrutiny {
    private int skipped;
    private String why = "";
    private int beams;
    private @Nullable Instant lastScan;
    private @Nullable Instant lastOdometry;

    /// Whether a scan can be used.
    boolean accepts(Stamped<LaserScan> scan) {
        Optional<String> fault = backwards(lastScan, scan.time()).or(() -> fault(scan.value()));
        fault.ifPresent(f -> skip("scan", f));
        if (fault.isEmpty()) {
            lastScan = scan.time();
            beams = scan.value().count();
        }
        return fault.isEmpty();
    }

    /// Whether what wheels say can be used.
    boolean acceptsOdometry(Stamped<Odometry> odometry) {
        Optional<String> fault = backwards(lastOdometry, odometry.time());
        if (fault.isEmpty() && !odometry.value().odomFromBase().isFinite()) {
            fault = Optional.of("it says (%s)".formatted(odometry.value().odomFromBase()));
        }
        fault.ifPresent(f -> skip("odometry", f));
        if (fault.isEmpty()) {
            lastOdometry = odometry.time();
        }
        return fault.isEmpty();
    }

    /// Takes the next as if they were the first.
    void reset() {
        beams = 0;
        lastScan = null;
        lastOdometry = null;
    }

    int skipped() {
        return skipped;
    }

    /// How many were skipped and why the last of them, to be put behind another sentence; empty when none was.
    String told() {
        return skipped == 0 ? "" : " Skipped so far: %d, the last since %s.".formatted(skipped, why);
    }

    private void skip(String what, String fault) {
        skipped++;
        why = "of a bad %s: %s".formatted(what, fault);
    }

    private static Optional<String> backwards(@Nullable Instant last, Instant now) {
        return last != null && now.isBefore(last)
                ? Optional.of("it is %.3f s older than the one before"
                        .formatted(Duration.between(now, last).toNanos() / 1e9))
                : Optional.empty();
    }

    private Optional<String> fault(LaserScan scan) {
        if (scan.count() == 0) {
            return Optional.of("it has no beams");
        }
        if (beams > 0 && scan.count() != beams) {
            return Optional.of("it has (%d) beams, those before had (%d)".formatted(scan.count(), beams));
        }
        double last = scan.angle(scan.count() - 1);
        if (!(scan.baseFromLaser().isFinite() && Double.isFinite(scan.angleMin()) && Double.isFinite(last))) {
            return Optional.of("its beams have no direction");
        }
        for (float range : scan.ranges()) {
            if (!Float.isNaN(range)) {
                return Optional.empty();
            }
        }
        return Optional.of("all its ranges are NaN");
    }
}
