package rsal.behavior;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.time.Instant;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.Random;
import java.util.stream.IntStream;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import rsal.data.LaserScan;
import rsal.data.Pose2d;
import rsal.data.RangeArray;

class SectorFusionTest {
    private static final Pose2d LASER = new Pose2d(0.1, 0, 0);
    private static final Pose2d SONAR = Pose2d.ofDegrees(0, 0, 0);

    @Test
    void rangesCountFromTheBaseNotFromTheSensor() {
        Surroundings around = fuse(scan(2), null);
        assertThat(around.range(Surroundings.sector(0.001))).isCloseTo(2.1f, within(0.01f));
    }

    @Test
    void whereNobodyLooksIsUnknown() {
        Surroundings around = fuse(scan(2), null);
        assertThat(around.range(Surroundings.sector(Math.PI))).isNaN();
        assertThat(fuse(null, null).range(0)).isNaN();
    }

    @Test
    void farThingsAndNoThingsAreNothing() {
        assertThat(fuse(scan(5.5f), null).range(Surroundings.sector(0.001))).isInfinite();
        assertThat(fuse(scan(Float.POSITIVE_INFINITY), null).range(Surroundings.sector(0.001)))
                .isInfinite();
    }

    @Test
    void tooCloseIsAtTheLeastRangeAndBrokenIsUnknown() {
        assertThat(fuse(scan(Float.NEGATIVE_INFINITY), null).nearest(-0.1, 0.1)).isCloseTo(0.15, within(0.01));
        assertThat(fuse(scan(Float.NaN), null).things()).isZero();
    }

    @Test
    void noughtIsNoReadingWhereNothingIsTooClose() {
        var none = new LaserScan(LASER, Math.toRadians(-90), Math.toRadians(0.5), 0, 30, ranges(0));
        assertThat(fuse(none, null).things()).isZero();
    }

    @Test
    void theSmallerRangeCounts() {
        assertThat(fuse(scan(3), sonar(1)).nearest(-0.05, 0.05)).as("glass").isCloseTo(1, within(0.05));
        assertThat(fuse(scan(2), sonar(4)).nearest(-0.05, 0.05)).as("cloth").isCloseTo(2.1, within(0.05));
    }

    @Test
    void aSonarDoesNotBlurWhatTheLaserSeesToo() {
        float[] ranges = ranges(3);
        ranges[180 + 8] = 1; // one beam, 4° to the left
        Surroundings around =
                fuse(new LaserScan(LASER, Math.toRadians(-90), Math.toRadians(0.5), 0.05, 30, ranges), sonar(1.1f));
        assertThat(around.range(Surroundings.sector(Math.toRadians(-3)))).isCloseTo(3.1f, within(0.05f));
    }

    @Test
    void sonarsAloneFillTheInnerHalfOfTheirCones() {
        Surroundings around = fuse(null, sonar(2));
        assertThat(around.range(Surroundings.sector(Math.toRadians(6)))).isCloseTo(2f, within(0.01f));
        assertThat(around.range(Surroundings.sector(Math.toRadians(12)))).isNaN();
    }

    @Test
    void remembersWhatTheLaserSawUntilItIsAMinuteOld() {
        float[] ranges = ranges(Float.POSITIVE_INFINITY);
        ranges[0] = 1; // straight to the right
        var scan = new LaserScan(Pose2d.ORIGIN, Math.toRadians(-90), Math.toRadians(0.5), 0.05, 30, ranges);
        var fusion = new SectorFusion(5);
        fusion.fuse(Instant.EPOCH, Pose2d.ORIGIN, Optional.of(scan), Optional.empty());
        Pose2d ahead = new Pose2d(0.5, 0, 0);
        Surroundings later = fusion.fuse(Instant.ofEpochSecond(59), ahead, Optional.empty(), Optional.empty());
        assertThat(later.things()).isEqualTo(1);
        assertThat(later.nearest(Math.toRadians(-125), Math.toRadians(-105)))
                .isCloseTo(Math.hypot(0.5, 1), within(0.05));
        assertThat(fusion.fuse(Instant.ofEpochSecond(61), ahead, Optional.empty(), Optional.empty())
                        .things())
                .isZero();
    }

    /// A wall beside the tail, which the laser saw before and a sonar on that side is too near to measure.
    @Test
    void remembersWhatASonarHearsButCanNotMeasureUntilItHearsNothingSoNear() {
        float[] ranges = ranges(Float.POSITIVE_INFINITY);
        ranges[2] = 0.15f; // 89° to the right
        var right = new LaserScan(Pose2d.ORIGIN, Math.toRadians(-90), Math.toRadians(0.5), 0.05, 30, ranges);
        var ahead = new LaserScan(Pose2d.ORIGIN, 0, Math.toRadians(0.5), 0.05, 30, ranges(5));
        var fusion = new SectorFusion(5);
        fusion.fuse(Instant.EPOCH, Pose2d.ORIGIN, Optional.of(right), Optional.empty());

        Surroundings near = fuse(fusion, 100, ahead, toTheRight(Float.NEGATIVE_INFINITY));
        assertThat(near.range(Surroundings.sector(Math.toRadians(-89)))).isCloseTo(0.15f, within(0.01f));
        Surroundings far = fuse(fusion, 200, ahead, toTheRight(2));
        assertThat(far.range(Surroundings.sector(Math.toRadians(-89)))).isCloseTo(2f, within(0.01f));
        Surroundings later = fuse(fusion, 300, ahead, null);
        assertThat(later.range(Surroundings.sector(Math.toRadians(-89)))).isNaN();
    }

    /// A wall 1 m to the left, which a laser sees, too. What a sonar hears up to 0.1 m and 5 % nearer is the same;
    /// nearer
    /// than that is glass.
    @Test
    void whatASonarHearsNearerThanTheLaserSeesIsThereToo() {
        float[] ranges = new float[721];
        for (int i = 0; i < ranges.length; i++) {
            double up = Math.sin(Math.toRadians(-180 + 0.5 * i));
            ranges[i] = up > 0.1 ? (float) (1 / up) : Float.POSITIVE_INFINITY;
        }
        var scan = new LaserScan(Pose2d.ORIGIN, -Math.PI, Math.toRadians(0.5), 0.05, 30, ranges);
        for (double x : new double[] {-0.3, 0, 0.4}) {
            for (double y : new double[] {-0.2, 0.1}) {
                var baseFromSonar = new Pose2d(x, y, Math.PI / 2);
                for (float range = 0.4f; range < 1.4f; range += 0.02f) {
                    var round = new RangeArray(List.of(baseFromSonar), 0.3, 0.1, 5, new float[] {range});
                    boolean same = 1 - y <= range + 0.1 + 0.05 * range;
                    boolean sure = Math.abs(1 - y - (range + 0.1 + 0.05 * range)) > 0.02; // sectors are coarse
                    Surroundings around = fuse(scan, round);
                    double bearing = Math.atan2(y + range, x);
                    double seen = around.nearest(bearing - 0.02, bearing + 0.02);
                    double nearer = Math.hypot(x, y + range);
                    if (sure && !same) {
                        assertThat(seen).as("%s, %s, %s", x, y, range).isCloseTo(nearer, within(0.06));
                    } else if (sure && y + range < 0.97) {
                        assertThat(seen).as("%s, %s, %s", x, y, range).isGreaterThan(nearer);
                    }
                }
            }
        }
    }

    /// Half of its cone to each side of its axis.
    @Test
    void aSonarFillsAllSectorsOfItsConesInnerHalf() {
        for (double fieldOfView : new double[] {0.2, 0.6, 1.4}) {
            var round = new RangeArray(List.of(new Pose2d(0, 0, 1)), fieldOfView, 0.1, 5, new float[] {2});
            Surroundings around = fuse(null, round);
            for (double angle = -1; angle <= 1; angle += 0.01) {
                boolean inside = Math.abs(angle) < fieldOfView / 4 - Surroundings.WIDTH;
                boolean outside = Math.abs(angle) > fieldOfView / 4 + Surroundings.WIDTH;
                float range = around.range(Surroundings.sector(1 + angle));
                if (inside || outside) {
                    assertThat(Float.isNaN(range))
                            .as("%s, %s", fieldOfView, angle)
                            .isEqualTo(outside);
                }
            }
        }
    }

    /// A beam of a coarse scanner stands for all between it and half way to the next ones.
    @Test
    void beamsOfACoarseScannerFillWhatIsBetweenThem() {
        float[] ranges = {2, 3, 4};
        var scan = new LaserScan(Pose2d.ORIGIN, Math.toRadians(-20), Math.toRadians(20), 0.05, 30, ranges);
        Surroundings around = fuse(scan, null);
        for (double degrees = -29; degrees <= 29; degrees += 1) {
            float expected = degrees < -10 ? 2 : degrees < 10 ? 3 : 4;
            if (Math.abs(Math.abs(degrees) - 10) > 1) {
                assertThat(around.range(Surroundings.sector(Math.toRadians(degrees))))
                        .as("%s°", degrees)
                        .isCloseTo(expected, within(1e-5f));
            }
        }
        assertThat(around.range(Surroundings.sector(Math.toRadians(33)))).isNaN();
        assertThat(around.range(Surroundings.sector(Math.toRadians(-33)))).isNaN();
    }

    /// What was seen stays where it is in the world while the robot drives and turns.
    @Test
    void remembersWhereThingsAreWhileItDrivesAndTurns() {
        var random = new Random(5);
        for (int draw = 0; draw < 200; draw++) {
            int beam = random.nextInt(361);
            float range = 1 + random.nextFloat();
            float[] ranges = ranges(Float.POSITIVE_INFINITY);
            ranges[beam] = range;
            var scan = new LaserScan(Pose2d.ORIGIN, Math.toRadians(-90), Math.toRadians(0.5), 0.05, 30, ranges);
            Pose2d before = new Pose2d(random.nextDouble() * 4, random.nextDouble() * 4, random.nextDouble() * 6);
            var move = new Pose2d(random.nextDouble() - 0.5, random.nextDouble() - 0.5, random.nextDouble() * 6 - 3);
            var fusion = new SectorFusion(5);
            fusion.fuse(Instant.EPOCH, before, Optional.of(scan), Optional.empty());
            Surroundings later =
                    fusion.fuse(Instant.ofEpochSecond(2), before.compose(move), Optional.empty(), Optional.empty());
            double angle = Math.toRadians(-90 + 0.5 * beam);
            Pose2d there = move.inverse().compose(new Pose2d(range * Math.cos(angle), range * Math.sin(angle), 0));
            double bearing = Math.atan2(there.y(), there.x());
            assertThat(later.things()).isEqualTo(1);
            assertThat(later.nearest(bearing - 0.03, bearing + 0.03))
                    .as("draw %d", draw)
                    .isCloseTo(Math.hypot(there.x(), there.y()), within(0.03));
        }
    }

    /// Whoever has fused readings of other sensors before sees the same as one who has not.
    @Test
    void sensorsMayBeOthersThanBefore() {
        var random = new Random(3);
        for (boolean withLaser : new boolean[] {false, true}) {
            var used = new SectorFusion(5);
            for (int round = 0; round < 200; round++) {
                var laser = withLaser ? Optional.of(allAround(random)) : Optional.<LaserScan>empty();
                var sonars = Optional.of(sonars(random));
                var fresh = new SectorFusion(5);
                Surroundings seen = used.fuse(Instant.EPOCH, Pose2d.ORIGIN, laser, sonars);
                Surroundings expected = fresh.fuse(Instant.EPOCH, Pose2d.ORIGIN, laser, sonars);
                for (int sector = 0; sector < Surroundings.SECTORS; sector++) {
                    assertThat(Float.compare(seen.range(sector), expected.range(sector)))
                            .as("round %d, sector %d", round, sector)
                            .isZero();
                }
            }
        }
    }

    private static LaserScan allAround(Random random) {
        var ranges = new float[random.nextBoolean() ? 180 : 360];
        for (int i = 0; i < ranges.length; i++) {
            ranges[i] = 0.3f + 8 * random.nextFloat();
        }
        double increment = 2 * Math.PI / ranges.length;
        return new LaserScan(Pose2d.ORIGIN, -Math.PI + increment / 2, increment, 0.05, 30, ranges);
    }

    private static RangeArray sonars(Random random) {
        double turn = 10 * random.nextInt(3);
        List<Pose2d> mounts = IntStream.range(0, 4 + random.nextInt(2))
                .mapToObj(i -> Pose2d.ofDegrees(0.1, 0.05 * i, turn + 30 * i))
                .toList();
        var ranges = new float[mounts.size()];
        for (int i = 0; i < ranges.length; i++) {
            ranges[i] = random.nextInt(5) == 0 ? Float.NaN : 6 * random.nextFloat();
        }
        return new RangeArray(mounts, Math.toRadians(random.nextBoolean() ? 15 : 30), 0.2, 5, ranges);
    }

    private static RangeArray toTheRight(float range) {
        return new RangeArray(List.of(Pose2d.ofDegrees(0, 0, -90)), Math.toRadians(30), 0.2, 5, new float[] {range});
    }

    private static Surroundings fuse(SectorFusion fusion, long millis, LaserScan scan, @Nullable RangeArray sonars) {
        return fusion.fuse(
                Instant.EPOCH.plusMillis(millis), Pose2d.ORIGIN, Optional.of(scan), Optional.ofNullable(sonars));
    }

    /// Turns that are no whole sectors, to the left by 40° in all.
    @ParameterizedTest
    @ValueSource(ints = {100, 60, 45, 32, 8})
    void whatItRemembersStaysWhereItIsWhileTheRobotTurns(int updates) {
        float[] ranges = ranges(Float.POSITIVE_INFINITY);
        ranges[2] = 1; // 89° to the right
        var scan = new LaserScan(Pose2d.ORIGIN, Math.toRadians(-90), Math.toRadians(0.5), 0.05, 30, ranges);
        var fusion = new SectorFusion(5);
        Surroundings around = fusion.fuse(Instant.EPOCH, Pose2d.ORIGIN, Optional.of(scan), Optional.empty());
        for (int update = 1; update <= updates; update++) {
            around = fusion.fuse(
                    Instant.EPOCH.plusMillis(90L * update),
                    Pose2d.ofDegrees(0, 0, 40.0 * update / updates),
                    Optional.empty(),
                    Optional.empty());
        }
        assertThat(around.things()).isEqualTo(1);
        assertThat(around.nearest(Math.toRadians(-131), Math.toRadians(-127))).isCloseTo(1, within(0.01));
    }

    @Test
    void whatSonarsHearIsNotRememberedEvenWhereTheLaserLooks() {
        var fusion = new SectorFusion(5);
        fusion.fuse(Instant.EPOCH, Pose2d.ORIGIN, Optional.of(scan(3)), Optional.of(sonar(1)));
        Surroundings later = fusion.fuse(Instant.ofEpochMilli(100), Pose2d.ORIGIN, Optional.empty(), Optional.empty());
        assertThat(later.nearest(-0.05, 0.05)).isCloseTo(3.1, within(0.05));
    }

    /// Without a memory.
    private static Surroundings fuse(LaserScan scan, RangeArray sonar) {
        return new SectorFusion(5)
                .fuse(Instant.EPOCH, Pose2d.ORIGIN, Optional.ofNullable(scan), Optional.ofNullable(sonar));
    }

    private static LaserScan scan(float range) {
        return new LaserScan(LASER, Math.toRadians(-90), Math.toRadians(0.5), 0.05, 30, ranges(range));
    }

    private static float[] ranges(float range) {
        var ranges = new float[361];
        Arrays.fill(ranges, range);
        return ranges;
    }

    private static RangeArray sonar(float range) {
        return new RangeArray(List.of(SONAR), Math.toRadians(30), 0.1, 5, new float[] {range});
    }
}
