package rsal.navigation.avoid;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

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
        assertThat(recalled.x(0)).isCloseTo(-0.2, within(1e-6));
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

    /// Where it was seen, as seen from where the robot has come to since: a quarter to the left and half a
    /// meter on.
    @Test
    void whatIsRecalledIsWhereItWasSeen() {
        Pose2d then = new Pose2d(5, -3, 2);
        var memory = new ObstacleMemory(1, Duration.ofSeconds(5));
        memory.note(AHEAD, seen, then, Instant.EPOCH);
        Pose2d now = then.compose(new Pose2d(0.5, 0.1, Math.PI / 2));
        memory.recall(AHEAD, now, Instant.EPOCH, 0.25, recalled);
        assertThat(recalled.count()).as("the other is looked at").isEqualTo(1);
        assertThat(recalled.x(0)).isCloseTo(-0.5, within(1e-6)); // (0.3, -0.4) is 0.5 m to the right of there
        assertThat(recalled.y(0)).isCloseTo(0.2, within(1e-6));
    }

    /// As seen from the laser, not from the base.
    @Test
    void theLaserLooksFromWhereItIsMounted() {
        var mounted = new LaserScan(new Pose2d(0.4, 0, 0), -Math.PI / 2, Math.PI / 180, 0.1, 5, new float[181]);
        blindSpot.recall(mounted, Pose2d.ORIGIN, Instant.EPOCH, 0.25, recalled);
        assertThat(recalled.count()).as("both are 0.1 m behind the laser").isEqualTo(2);
        seen.clear();
        seen.add(0.35, 0.5); // behind the laser
        seen.add(0.45, 0.5);
        var memory = new ObstacleMemory(1, Duration.ofSeconds(5));
        memory.note(mounted, seen, Pose2d.ORIGIN, Instant.EPOCH);
        recalled.clear();
        memory.recall(AHEAD, new Pose2d(0.9, 0, 0), Instant.EPOCH, 0.25, recalled);
        assertThat(recalled.count()).isEqualTo(1);
        assertThat(recalled.x(0)).isCloseTo(-0.45, within(1e-6));
    }

    /// Those that are forgotten leave no gap: each of the others stays what it was.
    @Test
    void whatIsKeptStaysWhatItWas() {
        seen.clear();
        for (int i = 0; i < 6; i++) {
            seen.add(0.1 + 0.1 * i, 0.5);
            if (i % 3 == 2) {
                seen.keepRoom(i, 0.2); // may move
            }
        }
        var memory = new ObstacleMemory(1, Duration.ofSeconds(5));
        memory.note(AHEAD, seen, Pose2d.ORIGIN, Instant.EPOCH);
        memory.recall(AHEAD, new Pose2d(0.25, 0, 0), Instant.EPOCH, 0.3, recalled); // those from 0.3 m on are seen
        assertThat(recalled.count()).isEqualTo(2);
        recalled.clear();
        memory.recall(AHEAD, new Pose2d(0.9, 0, 0), Instant.EPOCH, 0.3, recalled);
        assertThat(recalled.count()).as("and forgotten").isEqualTo(2);
        memory.note(AHEAD, seen, Pose2d.ORIGIN, Instant.ofEpochSecond(4));
        recalled.clear();
        memory.recall(AHEAD, new Pose2d(0.75, 0, 0), Instant.ofEpochSecond(6), 0.3, recalled);
        assertThat(recalled.count()).isEqualTo(8);
        for (int i = 0; i < 8; i++) {
            int from = i < 2 ? i : i - 2;
            assertThat(recalled.x(i)).isCloseTo(0.1 + 0.1 * from - 0.75, within(1e-6));
            assertThat(recalled.room(i)).isEqualTo(from % 3 == 2 ? 0.3f : 0);
        }
        recalled.clear();
        memory.recall(AHEAD, new Pose2d(0.75, 0, 0), Instant.ofEpochSecond(10), 0.3, recalled);
        assertThat(recalled.count()).as("what may move is forgotten after 5 s").isEqualTo(6);
    }

    @Test
    void fiveSecondsAreNotOver() {
        recallAt(new Pose2d(0.5, 0, 0), 5);
        assertThat(recalled.count()).isEqualTo(2);
    }

    @Test
    void itRemembersAThousandPlaces() {
        var memory = new ObstacleMemory(1, Duration.ofSeconds(5));
        for (int round = 0; round < 30; round++) {
            seen.clear();
            for (int i = 0; i < 40; i++) {
                seen.add(0.1, (i - 20) * 0.04 + 0.001 * round);
            }
            memory.note(AHEAD, seen, Pose2d.ORIGIN, Instant.EPOCH);
        }
        memory.recall(AHEAD, new Pose2d(0.5, 0, 0), Instant.EPOCH, 0.25, recalled);
        assertThat(recalled.count()).isEqualTo(1024);
    }

    /// A thing that is as good as where the one before is adds nothing, and changes nothing of that.
    @Test
    void whoMovesBesideAWallKeepsNoRoomFromTheWall() {
        seen.clear();
        seen.add(0.3, 0.4);
        var memory = new ObstacleMemory(1, Duration.ofSeconds(5));
        memory.note(AHEAD, seen, Pose2d.ORIGIN, Instant.EPOCH);
        seen.keepRoom(0, 0.2);
        memory.note(AHEAD, seen, Pose2d.ORIGIN, Instant.EPOCH);
        memory.recall(AHEAD, new Pose2d(0.5, 0, 0), Instant.EPOCH, 0.25, recalled);
        assertThat(recalled.count()).isEqualTo(1);
        assertThat(recalled.room(0)).isZero();
    }
}
