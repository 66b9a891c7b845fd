package rsal.navigation.device;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Instant;
import java.util.Arrays;
import java.util.List;
import org.junit.jupiter.api.Test;
import rsal.data.LaserScan;
import rsal.data.Odometry;
import rsal.data.Pose2d;
import rsal.data.RangeArray;
import rsal.data.Stamped;
import rsal.data.Twist2d;

class ReadingValidatorTest {
    private final ReadingValidator scrutiny = ReadingValidator.ofScansAlike(_ -> {});

    private static Stamped<LaserScan> scan(double seconds, double angleMin, float... ranges) {
        return new Stamped<>(
                Instant.ofEpochMilli((long) (1000 * seconds)),
                "laser",
                new LaserScan(Pose2d.ORIGIN, angleMin, 0.1, 0.02, 5, ranges));
    }

    private static Stamped<Odometry> odometry(double seconds, double x) {
        return new Stamped<>(
                Instant.ofEpochMilli((long) (1000 * seconds)),
                "odom",
                new Odometry(new Pose2d(x, 0, 0), Twist2d.STOP, false));
    }

    private static float[] ranges(int count, float range) {
        var ranges = new float[count];
        Arrays.fill(ranges, range);
        return ranges;
    }

    @Test
    void someBeamsMayBeBrokenOrSeeNothing() {
        assertThat(scrutiny.accepts(scan(1, -1, Float.NaN, 2, Float.POSITIVE_INFINITY)))
                .isTrue();
        assertThat(scrutiny.accepts(scan(1.1, -1, ranges(3, Float.POSITIVE_INFINITY))))
                .isTrue();
        assertThat(scrutiny.reported()).isEmpty();
    }

    @Test
    void skipsAndCountsWhatIsOfNoUse() {
        assertThat(scrutiny.accepts(scan(1, -1, 2, 2, 2))).isTrue();
        assertThat(scrutiny.accepts(scan(1.1, -1, ranges(3, Float.NaN)))).isFalse();
        assertThat(scrutiny.reported()).contains("1,").contains("NaN");
        assertThat(scrutiny.accepts(scan(1.2, -1, 2, 2))).isFalse();
        assertThat(scrutiny.reported()).contains("2,").contains("2 beams").contains("had 3");
        assertThat(scrutiny.accepts(scan(1.3, -1))).isFalse();
        assertThat(scrutiny.accepts(scan(1.4, Double.NaN, 2, 2, 2))).isFalse();
        assertThat(scrutiny.reported()).contains("direction");
        assertThat(scrutiny.accepts(scan(0.5, -1, 2, 2, 2))).isFalse();
        assertThat(scrutiny.reported()).contains("5,").contains("0.500 s older");
        assertThat(scrutiny.accepts(scan(1.5, -1, 2, 2, 2))).isTrue();
        assertThat(scrutiny.skipped()).isEqualTo(5);
    }

    @Test
    void noughtIsNoReadingWhereItIsNotTooClose() {
        assertThat(ReadingValidator.fault(new LaserScan(Pose2d.ORIGIN, -1, 1, 0, 5, new float[3])))
                .isPresent();
        assertThat(ReadingValidator.fault(new RangeArray(List.of(Pose2d.ORIGIN), 0.5, 0, 5, new float[1])))
                .isPresent();
        assertThat(ReadingValidator.fault(new LaserScan(Pose2d.ORIGIN, -1, 1, 0.02, 5, new float[3])))
                .isEmpty();
    }

    @Test
    void scansMayHaveOtherNumbersOfBeamsWhereThatDoesNotMatter() {
        ReadingValidator any = ReadingValidator.ofAnyScans(_ -> {});
        assertThat(any.accepts(scan(1, -1, 2, 2, 2))).isTrue();
        assertThat(any.accepts(scan(1.1, -1, 2, 2))).isTrue();
        assertThat(any.accepts(scan(1.2, -1))).isFalse();
        assertThat(any.accepts(scan(1, -1, 2, 2))).isFalse();
        assertThat(any.reported()).contains("2,").contains("0.100 s older");
    }

    @Test
    void sonarsAreLookedAtLikewise() {
        ReadingValidator any = ReadingValidator.ofAnyScans(_ -> {});
        assertThat(any.acceptsRanges(sonars(1, Pose2d.ORIGIN, 2))).isTrue();
        assertThat(any.acceptsRanges(sonars(1.1, Pose2d.ORIGIN, Float.NaN))).isFalse();
        assertThat(any.reported()).contains("reading of sonars").contains("NaN");
        assertThat(any.acceptsRanges(sonars(1.2, new Pose2d(0, 0, Double.NaN), 2)))
                .isFalse();
        assertThat(any.acceptsRanges(sonars(0.9, Pose2d.ORIGIN, 2))).isFalse();
        assertThat(any.reported()).contains("3,").contains("0.100 s older");
    }

    private static Stamped<RangeArray> sonars(double seconds, Pose2d mount, float range) {
        return new Stamped<>(
                Instant.ofEpochMilli((long) (1000 * seconds)),
                "base",
                new RangeArray(List.of(mount), 0.5, 0.1, 5, new float[] {range}));
    }

    @Test
    void wheelsMustSayAPlaceAndInOrder() {
        assertThat(scrutiny.acceptsOdometry(odometry(1, 0))).isTrue();
        assertThat(scrutiny.acceptsOdometry(odometry(2, Double.NaN))).isFalse();
        assertThat(scrutiny.acceptsOdometry(odometry(0.9, 0))).isFalse();
        assertThat(scrutiny.reported()).contains("2,").contains("odometry").contains("0.100 s older");
    }

    @Test
    void anewItTakesOthers() {
        assertThat(scrutiny.accepts(scan(5, -1, 2, 2, 2))).isTrue();
        scrutiny.reset();
        assertThat(scrutiny.accepts(scan(1, -1, 2, 2))).isTrue();
    }
}
