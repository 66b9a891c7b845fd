package rsal.navigation.device;

import java.time.Duration;
import java.time.Instant;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.function.IntToDoubleFunction;
import java.util.stream.IntStream;
import org.jspecify.annotations.Nullable;
import rsal.data.LaserScan;
import rsal.data.Odometry;
import rsal.data.Pose2d;
import rsal.data.RangeArray;
import rsal.data.Stamped;
import rsal.device.Health;

/// Looks at what a laser or sonars and wheels say before anything is made of it, and counts what is not to be used:
/// what is out of order in time, has another number of beams than before where that matters, or no number where one
/// must be.
final class ReadingValidator {
    private final boolean sameCount;
    private final Consumer<String> onFirst;
    private int skipped;
    private String why = "";
    private int beams;
    private @Nullable Instant lastScan;
    private @Nullable Instant lastOdometry;

    private ReadingValidator(boolean sameCount, Consumer<String> onFirst) {
        this.sameCount = sameCount;
        this.onFirst = onFirst;
    }

    /// For those to whom all scans must look alike.
    ///
    /// @param onFirst is given what is [#reported] when the first reading is skipped
    static ReadingValidator ofScansAlike(Consumer<String> onFirst) {
        return new ReadingValidator(true, onFirst);
    }

    /// For those who take each scan by itself: some lasers give now more beams and now fewer.
    ///
    /// @param onFirst as above
    static ReadingValidator ofAnyScans(Consumer<String> onFirst) {
        return new ReadingValidator(false, onFirst);
    }

    /// Whether a scan can be used.
    boolean accepts(Stamped<LaserScan> scan) {
        LaserScan value = scan.value();
        return accepts("scan", scan.time(), value.count(), fault(value));
    }

    /// Whether what sonars say can be used.
    boolean acceptsRanges(Stamped<RangeArray> ranges) {
        RangeArray value = ranges.value();
        return accepts("reading of sonars", ranges.time(), value.count(), fault(value));
    }

    private boolean accepts(String what, Instant time, int count, Optional<String> ofItself) {
        Optional<String> fault = backwards(lastScan, time).or(() -> ofItself).or(() -> otherCount(count));
        fault.ifPresent(f -> skip(what, f));
        if (fault.isEmpty()) {
            lastScan = time;
            beams = count;
        }
        return fault.isEmpty();
    }

    /// Skips what was accepted, since nothing tells any more where the robot was then.
    void skipTooOld() {
        skip("scan", "it is older than all odometry that is kept");
    }

    /// Whether what wheels say can be used.
    boolean acceptsOdometry(Stamped<Odometry> odometry) {
        Optional<String> fault = backwards(lastOdometry, odometry.time());
        if (fault.isEmpty() && !odometry.value().odomFromBase().isFinite()) {
            fault = Optional.of("it says '%s'".formatted(odometry.value().odomFromBase()));
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
    String reported() {
        return skipped == 0 ? "" : " Skipped so far: %d, the last since %s.".formatted(skipped, why);
    }

    /// Of one that has had nothing of use for so long.
    Health silence(String what, Duration patience) {
        return new Health.Stale("No %s for more than %d s.%s".formatted(what, patience.toSeconds(), reported()));
    }

    private void skip(String what, String fault) {
        skipped++;
        why = "of a bad %s: %s".formatted(what, fault);
        if (skipped == 1) {
            onFirst.accept(reported());
        }
    }

    private static Optional<String> backwards(@Nullable Instant last, Instant now) {
        return last != null && now.isBefore(last)
                ? Optional.of("it is %.3f s older than the one before"
                        .formatted(Duration.between(now, last).toNanos() / 1e9))
                : Optional.empty();
    }

    private Optional<String> otherCount(int count) {
        return sameCount && beams > 0 && count != beams
                ? Optional.of("it has %d beams, those before had %d".formatted(count, beams))
                : Optional.empty();
    }

    /// Why nothing can be made of a scan, whatever was before.
    static Optional<String> fault(LaserScan scan) {
        if (scan.count() == 0) {
            return Optional.of("it has no beams");
        }
        double last = scan.angle(scan.count() - 1);
        if (!(scan.baseFromLaser().isFinite() && Double.isFinite(scan.angleMin()) && Double.isFinite(last))) {
            return Optional.of("its beams have no direction");
        }
        return noReading(scan.count(), scan::distance);
    }

    /// The same of what sonars say.
    static Optional<String> fault(RangeArray ranges) {
        if (ranges.count() == 0) {
            return Optional.of("it has no ranges");
        }
        if (!ranges.baseFromSensors().stream().allMatch(Pose2d::isFinite)) {
            return Optional.of("its sensors have no direction");
        }
        return noReading(ranges.count(), ranges::distance);
    }

    private static Optional<String> noReading(int count, IntToDoubleFunction distance) {
        return IntStream.range(0, count).mapToDouble(distance).allMatch(Double::isNaN)
                ? Optional.of("all its ranges are NaN, or 0 m")
                : Optional.empty();
    }
}
