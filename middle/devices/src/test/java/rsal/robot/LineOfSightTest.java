package rsal.robot;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Arrays;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import rsal.data.LaserScan;
import rsal.data.Pose2d;

/// A scanner looks ahead, a beam for each degree from −90° to 90°.
class LineOfSightTest {
    private static final int BEAMS = 181;

    @Test
    void aWallNearerThanTheOtherIsInTheWay() {
        assertThat(LineOfSight.isBlocked(all(1.0f), Pose2d.ORIGIN, new Pose2d(1.5, 0, 2)))
                .isTrue();
        assertThat(LineOfSight.isBlocked(all(1.0f), Pose2d.ORIGIN, new Pose2d(0.7, 1.3, 2)))
                .isTrue();
    }

    @Test
    void theOtherItselfIsNotInTheWay() {
        assertThat(LineOfSight.isBlocked(all(1.2f), Pose2d.ORIGIN, new Pose2d(1.5, 0, 0)))
                .isFalse();
        assertThat(LineOfSight.isBlocked(all(0.1f), Pose2d.ORIGIN, new Pose2d(0.3, 0, 0)))
                .as("too near for anything to be between")
                .isFalse();
    }

    @Test
    void aBoxBesideItIsNotInTheWay() {
        LaserScan scan = all(1.0f);
        scan.ranges()[90] = Float.POSITIVE_INFINITY; // straight ahead nothing is seen
        assertThat(LineOfSight.isBlocked(scan, Pose2d.ORIGIN, new Pose2d(1.5, 0, 0)))
                .isFalse();
        scan.ranges()[90] = Float.NaN;
        assertThat(LineOfSight.isBlocked(scan, Pose2d.ORIGIN, new Pose2d(1.5, 0, 0)))
                .as("a beam without a reading tells nothing")
                .isFalse();
    }

    @Test
    void nobodyKnowsWhatIsBehindTheRobot() {
        assertThat(LineOfSight.isBlocked(all(0.5f), Pose2d.ORIGIN, new Pose2d(-1.5, 0, 0)))
                .isFalse();
        Pose2d turned = Pose2d.ofDegrees(2, 1, 180);
        assertThat(LineOfSight.isBlocked(all(0.5f), turned, new Pose2d(0.5, 1, 0)))
                .isTrue();
    }

    @Test
    void neverLooksBesideTheScan() {
        var random = new SplittableRandom(1);
        for (int i = 0; i < 10_000; i++) {
            Pose2d here = new Pose2d(random.nextDouble(), random.nextDouble(), random.nextDouble(-4, 4));
            Pose2d other = new Pose2d(random.nextDouble(-3, 3), random.nextDouble(-3, 3), 0);
            boolean blocked = LineOfSight.isBlocked(all(0.2f), here, other);
            double ahead = Math.abs(here.bearingTo(other.position()));
            if (ahead > Math.PI / 2) {
                assertThat(blocked).isFalse();
            }
        }
    }

    private static LaserScan all(float range) {
        var ranges = new float[BEAMS];
        Arrays.fill(ranges, range);
        return new LaserScan(Pose2d.ORIGIN, -Math.PI / 2, Math.PI / (BEAMS - 1), 0.02, 8, ranges);
    }
}
