package rsal.navigation.mpc;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.HashMap;
import java.util.Map;
import java.util.SplittableRandom;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import rsal.data.LaserScan;
import rsal.data.Pose2d;
import rsal.navigation.avoid.Obstacles;

class RollingMapTest {
    private static final int SIDE = 40; // cells
    private static final double RESOLUTION = 0.1; // m
    private static final double NOTES = 9.5;

    private final RollingMap map = new RollingMap(SIDE, RESOLUTION, NOTES);
    private final Obstacles obstacles = new Obstacles(10);

    @BeforeEach
    void begin() {
        obstacles.clear();
    }

    @Test
    void distancesAreThoseToTheCellOfThePointThatWasSeen() {
        obstacles.add(1.05, -0.45);
        map.note(obstacles, Pose2d.ORIGIN);
        assertThat(map.distance(1.05, -0.45)).isZero();
        assertThat(map.distance(1.09, -0.41)).isZero(); // the same cell
        assertThat(map.distance(1.15, -0.45)).isCloseTo(0.1f, within(1e-6f));
        assertThat(map.distance(1.35, -0.05)).isCloseTo(0.5f, within(1e-6f));
        assertThat(map.distance(-0.95, -0.45)).isCloseTo(2f, within(1e-6f));
    }

    @Test
    void pointsAreInTheBaseFrameAndCellsInThatOfOdometry() {
        obstacles.add(1, 0.5);
        map.note(obstacles, new Pose2d(10.05, 20.05, Math.PI / 2));
        assertThat(map.distance(9.55, 21.05)).isZero();
    }

    @Test
    void nothingIsNearWhereNothingWasSeen() {
        map.note(obstacles, Pose2d.ORIGIN);
        assertThat(map.distance(0, 0)).isGreaterThan(1e3f);
        assertThat(map.distance(5, 0)).isEqualTo(Float.POSITIVE_INFINITY);
    }

    @Test
    void cellsBeginAtWholeMultiplesOfTheirSideAroundTheRobot() {
        map.note(obstacles, new Pose2d(0.57, -0.13, 1));
        assertThat(map.x(0)).isCloseTo(-1.5 + 0.05, within(1e-9));
        assertThat(map.y(0)).isCloseTo(-2.2 + 0.05, within(1e-9));
        assertThat(map.cell(map.x(3), map.y(5))).isEqualTo(5 * SIDE + 3);
    }

    @ParameterizedTest
    @CsvSource({"-2.01, 0", "2.01, 0", "0, -2.01", "0, 2.01"})
    void thereIsNoCellOutside(double x, double y) {
        map.note(obstacles, Pose2d.ORIGIN);
        assertThat(map.cell(x, y)).isEqualTo(-1);
    }

    @ParameterizedTest
    @CsvSource({"-1.99, 0, 0, 20", "1.99, 0, 39, 20", "0, -1.99, 20, 0", "0, 1.99, 20, 39"})
    void theCellsAtTheBorderBelongToTheMap(double x, double y, int column, int row) {
        map.note(obstacles, Pose2d.ORIGIN);
        assertThat(map.cell(x, y)).isEqualTo(row * SIDE + column);
    }

    /// One sight of a thing is forgotten sooner than many.
    @ParameterizedTest
    @CsvSource({"1, 2", "2, 4", "3, 6", "20, 9"}) // log odds 0.63, 1.26, 1.89 and 3.13, by 0.37
    void whatIsNotSeenAgainIsForgotten(int sights, int notes) {
        obstacles.add(1, 0);
        for (int i = 0; i < sights; i++) {
            map.note(obstacles, Pose2d.ORIGIN);
        }
        obstacles.clear();
        int kept = 0;
        for (map.note(obstacles, Pose2d.ORIGIN); map.distance(1, 0) == 0; map.note(obstacles, Pose2d.ORIGIN)) {
            kept++;
        }
        assertThat(kept).isEqualTo(notes);
    }

    @Test
    void aResetForgetsAll() {
        obstacles.add(1, 0);
        map.note(obstacles, Pose2d.ORIGIN);
        map.reset();
        obstacles.clear();
        map.note(obstacles, new Pose2d(0.5, 0, 0));
        assertThat(map.distance(1, 0)).isGreaterThan(1e3f);
    }

    /// What was seen stays where it is in the odometry frame, until the map has moved on from there.
    @ParameterizedTest
    @CsvSource({"1, 0", "-1, 0", "0, 1", "0, -1", "1, -1"})
    void theMapMovesAlong(double forwardX, double forwardY) {
        obstacles.add(0.55, 0.35);
        obstacles.add(-1.95, -1.95);
        map.note(obstacles, Pose2d.ORIGIN);
        obstacles.clear();
        map.note(obstacles, new Pose2d(1.2 * forwardX, 1.2 * forwardY, 0));
        assertThat(map.distance(0.55, 0.35)).isZero();
        assertThat(map.x(0)).isCloseTo(-1.95 + RESOLUTION * Math.round(12 * forwardX), within(1e-9));
        assertThat(map.y(0)).isCloseTo(-1.95 + RESOLUTION * Math.round(12 * forwardY), within(1e-9));
    }

    @Test
    void theMapStaysAsLongAsTheRobotIsNearItsMiddle() {
        map.note(obstacles, Pose2d.ORIGIN);
        map.note(obstacles, new Pose2d(0.99, -0.99, 0));
        assertThat(map.x(0)).isCloseTo(-1.95, within(1e-9));
        map.note(obstacles, new Pose2d(1.01, 0, 0));
        assertThat(map.x(0)).isCloseTo(-0.95, within(1e-9));
    }

    @Test
    void nothingIsLeftOfAPlaceThatIsFarAway() {
        obstacles.add(1, 0);
        map.note(obstacles, Pose2d.ORIGIN);
        obstacles.clear();
        map.note(obstacles, new Pose2d(100, 0, 0));
        map.note(obstacles, Pose2d.ORIGIN);
        assertThat(map.distance(1, 0)).isGreaterThan(1e3f);
    }

    /// Against evidence that is kept by place, however far away: a robot drives at random among things that come and
    /// go.
    @ParameterizedTest
    @ValueSource(longs = {1, 2, 3, 4, 5, 6})
    void itIsOccupiedWhereEvidenceSaysSo(long seed) {
        var random = new SplittableRandom(seed);
        var slow = new ObviousMap();
        Pose2d pose = new Pose2d(random.nextDouble(-5, 5), random.nextDouble(-5, 5), random.nextDouble(-3, 3));
        for (int note = 0; note < 60; note++) {
            obstacles.clear();
            obstacles.add(scan(random));
            map.note(obstacles, pose);
            slow.note(obstacles, pose);
            for (int row = 0; row < SIDE; row++) {
                for (int column = 0; column < SIDE; column++) {
                    boolean occupied = map.distance(row * SIDE + column) == 0;
                    assertThat(occupied)
                            .as("note %d, column %d, row %d", note, column, row)
                            .isEqualTo(slow.isOccupied(slow.left + column, slow.bottom + row));
                }
            }
            pose = pose.compose(new Pose2d(random.nextDouble(0.3), random.nextDouble(-0.1, 0.1), 0.2));
        }
    }

    /// All around; some beams hit nothing.
    private static LaserScan scan(SplittableRandom random) {
        var ranges = new float[90];
        for (int i = 0; i < ranges.length; i++) {
            ranges[i] = random.nextInt(3) == 0 ? Float.POSITIVE_INFINITY : (float) random.nextDouble(0.2, 2.4);
        }
        return new LaserScan(Pose2d.ORIGIN, 0, 2 * Math.PI / ranges.length, 0, 5, ranges);
    }

    /// The same rules without an array that moves: log odds by cell of the odometry frame.
    private static final class ObviousMap {
        private final Map<Long, Float> evidence = new HashMap<>();
        private final Map<Long, Boolean> occupied = new HashMap<>();
        private boolean empty = true;
        private int left; // cells
        private int bottom;

        private static long key(int column, int row) {
            return ((long) column << 32) ^ (row & 0xffff_ffffL);
        }

        boolean isOccupied(int column, int row) {
            return occupied.getOrDefault(key(column, row), false);
        }

        private boolean isInside(int column, int row) {
            return column >= left && column < left + SIDE && row >= bottom && row < bottom + SIDE;
        }

        void note(Obstacles obstacles, Pose2d pose) {
            double half = SIDE * RESOLUTION / 2;
            if (empty) {
                left = (int) Math.floor((pose.x() - half) / RESOLUTION);
                bottom = (int) Math.floor((pose.y() - half) / RESOLUTION);
                empty = false;
            }
            double offX = pose.x() - left * RESOLUTION - half;
            double offY = pose.y() - bottom * RESOLUTION - half;
            if (Math.abs(offX) > 1 || Math.abs(offY) > 1) {
                left += (int) Math.round(offX / RESOLUTION);
                bottom += (int) Math.round(offY / RESOLUTION);
                evidence.keySet().removeIf(key -> !isInside((int) (key >> 32), key.intValue()));
            }
            for (int i = 0; i < Obstacles.SIGHTS; i++) {
                see(pose, 2 * Math.PI * i / Obstacles.SIGHTS, Math.min(obstacles.sight(i) - 0.12, half));
            }
            for (int i = 0; i < obstacles.count(); i++) {
                var place = pose.transform(obstacles.at(i));
                int column = cell(place.x(), left);
                int row = cell(place.y(), bottom);
                if (isInside(column, row)) {
                    float before = evidence.getOrDefault(key(column, row), 0f);
                    evidence.put(key(column, row), Math.clamp(before + 1, 1f, 3.5f));
                }
            }
            occupied.clear();
            evidence.replaceAll((key, value) -> {
                occupied.put(key, value > 0);
                return value > 0 ? value - (float) (3.5f / NOTES) : value;
            });
        }

        private void see(Pose2d pose, double direction, double far) {
            long last = Long.MIN_VALUE;
            for (double along = 0; along < far; along += RESOLUTION) {
                int column = cell(pose.x() + along * Math.cos(pose.theta() + direction), left);
                int row = cell(pose.y() + along * Math.sin(pose.theta() + direction), bottom);
                if (!isInside(column, row)) {
                    return;
                }
                long key = key(column, row);
                if (key != last && evidence.getOrDefault(key, 0f) > -1.5f) {
                    evidence.merge(key, -0.35f, Float::sum);
                }
                last = key;
            }
        }

        private static int cell(double at, int first) {
            return first + (int) Math.floor((at - first * RESOLUTION) / RESOLUTION);
        }
    }
}
