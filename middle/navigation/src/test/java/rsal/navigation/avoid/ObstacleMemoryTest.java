package rsal.navigation.avoid;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import java.time.Instant;
import java.util.Arrays;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import rsal.data.LaserScan;
import rsal.data.Pose2d;

class ObstacleMemoryTest {
    /// Looks at the half plane ahead.
    private static final LaserScan AHEAD =
            new LaserScan(Pose2d.ORIGIN, -Math.PI / 2, Math.PI / 180, 0.1, 5, new float[181]);

    private final ObstacleMemory blindSpot = new ObstacleMemory(1, Duration.ofSeconds(5));
    private final Obstacles seen = new Obstacles(3);
    private final Obstacles recalled = new Obstacles(3);

    @BeforeEach
    void seeAPostAndAPerson() {
        seen.add(0.3, 0.4);
        seen.add(0.3, -0.4);
        seen.keepRoom(1, 0.2);
        blindSpot.note(AHEAD, seen, Pose2d.ORIGIN, Instant.EPOCH);
    }

    @Test
    void whatOthersThanTheLaserPerceiveIsNotRemembered() {
        seen.clear();
        seen.add(-0.3, 0.2); // behind the robot, where a sonar may hear it
        blindSpot.note(AHEAD, seen, Pose2d.ORIGIN, Instant.EPOCH);
        recallAt(Pose2d.ORIGIN, 1);
        assertThat(recalled.count()).isZero();
    }

    @Test
    void whatTheLaserLooksAtIsNotRecalled() {
        recallAt(new Pose2d(0.1, 0, 0), 1);
        assertThat(recalled.count()).isZero();
    }

    @Test
    void whatLiesWhereBeamsAreBrokenIsRecalled() {
        float[] ranges = new float[181];
        Arrays.fill(ranges, Float.POSITIVE_INFINITY);
        ranges[90 + 53] = Float.NaN; // towards the post, 53° to the left
        var broken = new LaserScan(
                Pose2d.ORIGIN, AHEAD.angleMin(), AHEAD.angleIncrement(), AHEAD.rangeMin(), AHEAD.rangeMax(), ranges);
        blindSpot.recall(broken, Pose2d.ORIGIN, Instant.EPOCH.plusSeconds(1), 0.25, recalled);
        assertThat(recalled.count()).isEqualTo(1);
        assertThat(recalled.y(0)).isPositive();
    }

    @Test
    void whatCameToLieBehindIsRecalled() {
        recallAt(new Pose2d(0.5, 0, 0), 1);
        assertThat(recalled.count()).isEqualTo(2);
        assertThat(recalled.x(0)).isCloseTo(-0.2, org.assertj.core.api.Assertions.within(1e-6));
        assertThat(recalled.room(0)).isZero();
        assertThat(recalled.room(1)).isEqualTo(0.25f);
    }

    @Test
    void wallsStayAndOthersFade() {
        recallAt(new Pose2d(0.5, 0, 0), 6);
        assertThat(recalled.count()).isEqualTo(1);
        assertThat(recalled.room(0)).isZero();
    }

    @Test
    void whatIsOutOfReachIsForgotten() {
        recallAt(new Pose2d(2, 0, 0), 1);
        assertThat(recalled.count()).isZero();
        recallAt(new Pose2d(0.5, 0, 0), 2);
        assertThat(recalled.count()).isZero();
    }

    private void recallAt(Pose2d odomFromBase, int second) {
        blindSpot.recall(AHEAD, odomFromBase, Instant.ofEpochSecond(second), 0.25, recalled);
    }
}
