package rsal.navigation.mpc;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.Arrays;
import java.util.SplittableRandom;
import java.util.function.DoubleUnaryOperator;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import rsal.data.Point2d;
import rsal.data.Pose2d;
import rsal.navigation.avoid.Obstacles;

class TimeFieldTest {
    private static final int SIDE = 60; // cells
    private static final double RESOLUTION = 0.1; // m
    private static final double SPEED = 0.5; // m/s
    private static final Point2d ORIGIN = new Point2d(0, 0);

    private final RollingMap map = new RollingMap(SIDE, RESOLUTION, 100);
    private final Obstacles obstacles = new Obstacles(10);

    /// Slow near obstacles, as the controller has it.
    private static double cautious(double distance) {
        return distance < 0.25 ? 0 : distance < 0.6 ? 0.2 : SPEED;
    }

    private TimeField field(DoubleUnaryOperator speeds) {
        map.note(obstacles, Pose2d.ORIGIN);
        return new TimeField(map, speeds);
    }

    @ParameterizedTest
    @CsvSource({"2, 0", "-2, 0", "0, 2", "0, -2"})
    void straightAwayFromTheGoalTimeIsDistanceBySpeed(double x, double y) {
        TimeField field = field(_ -> SPEED);
        field.spread(new Point2d(0.05, 0.05), new Point2d(x, y));
        assertThat(field.at(x + 0.05, y + 0.05)).isCloseTo(2 / SPEED, within(1e-3));
        assertThat(field.at(x / 2 + 0.05, y / 2 + 0.05)).isCloseTo(1 / SPEED, within(1e-3));
    }

    @Test
    void acrossCellsTimeIsThatOfTheStraightLineToAFewPercent() {
        TimeField field = field(_ -> SPEED);
        field.spread(new Point2d(0.05, 0.05), new Point2d(2, 2));
        for (double angle = 0; angle < 2 * Math.PI; angle += 0.1) {
            assertThat(field.at(0.05 + 2 * Math.cos(angle), 0.05 + 2 * Math.sin(angle)))
                    .as("at %.1f rad", angle)
                    .isCloseTo(2 / SPEED, within(0.06 * 2 / SPEED));
        }
    }

    @ParameterizedTest
    @ValueSource(doubles = {-3, -2, -1, 0, 1, 2, 3})
    void directionsLeadToTheGoal(double angle) {
        TimeField field = field(_ -> SPEED);
        field.spread(new Point2d(0.05, 0.05), new Point2d(2, 2));
        double direction = field.direction(0.05 - 1.5 * Math.cos(angle), 0.05 - 1.5 * Math.sin(angle));
        assertThat(Math.abs(Math.IEEEremainder(direction - angle, 2 * Math.PI)))
                .isLessThan(0.12); // the error of cells of 0.1 m
    }

    @Test
    void aGoalOutsideIsHeadedForAsIfNothingWereBeyondTheMap() {
        TimeField field = field(_ -> SPEED);
        field.spread(new Point2d(13.05, 0.05), ORIGIN);
        assertThat(field.at(2.05, 0.05) - field.at(2.55, 0.05)).isCloseTo(0.5 / SPEED, within(1e-3));
        assertThat(field.at(2.95 - 1e-9, 0.05)).isCloseTo(0, within(1e-3)); // counted from the border's nearest cell
        double toCorner = Math.hypot(13.05 - 2.75, 2.75 - 0.05) - (13.05 - 2.95);
        assertThat(field.at(2.75, 2.75)).isCloseTo(toCorner / SPEED, within(0.1));
        assertThat(Math.abs(field.direction(1.05, 2.05) - Math.atan2(-2, 12))).isLessThan(0.05);
    }

    @ParameterizedTest
    @CsvSource({"9, 0.3", "-9, 0.3", "0.3, 9", "0.3, -9", "9, 9", "-9, -9"})
    void goalsOutsideAreHeadedForOnAllSides(double x, double y) {
        TimeField field = field(_ -> SPEED);
        field.spread(new Point2d(x, y), ORIGIN);
        double direction = field.direction(0, 0);
        assertThat(Math.abs(Math.IEEEremainder(direction - Math.atan2(y, x), 2 * Math.PI)))
                .isLessThan(0.05);
    }

    @Test
    void noTimeIsKnownOutsideOrWhereTheRobotCannotBe() {
        for (double y = -3; y <= 3; y += 0.05) {
            obstacles.add(1, y); // from border to border
        }
        TimeField field = field(TimeFieldTest::cautious);
        field.spread(new Point2d(2, 0), new Point2d(2, 0));
        assertThat(field.at(2.5, 0)).isFinite();
        assertThat(field.at(-1, 0)).isInfinite();
        assertThat(field.direction(-1, 0)).isNaN();
        assertThat(field.at(3.2, 0)).isInfinite();
        assertThat(field.at(-3.2, 0)).isInfinite();
        assertThat(field.at(0, 3.2)).isInfinite();
        assertThat(field.at(0, -3.2)).isInfinite();
    }

    @Test
    void theWaveEndsSomeTimeAfterItReachedTheRobot() {
        TimeField field = field(_ -> 0.2);
        field.spread(new Point2d(0.05, 0.05), new Point2d(0.55, 0.05)); // 2.5 s away
        assertThat(field.at(1.05, 0.05)).isCloseTo(5, within(0.01));
        assertThat(field.at(1.55, 0.05)).isInfinite(); // 7.5 s away
    }

    @Test
    void eachSpreadForgetsTheOneBefore() {
        TimeField field = field(_ -> SPEED);
        field.spread(new Point2d(0.05, 0.05), ORIGIN);
        field.spread(new Point2d(1.05, 0.05), new Point2d(-1, 0));
        assertThat(field.at(0.05, 0.05)).isCloseTo(2, within(1e-3));
    }

    @Test
    void betweenFourCellsTimeIsLinear() {
        TimeField field = field(_ -> SPEED);
        field.spread(new Point2d(0.05, 0.05), new Point2d(2, 2));
        double a = field.at(1.05, 0.55);
        double b = field.at(1.15, 0.55);
        double c = field.at(1.05, 0.65);
        double d = field.at(1.15, 0.65);
        assertThat(field.at(1.08, 0.57)).isCloseTo(0.8 * (0.7 * a + 0.3 * b) + 0.2 * (0.7 * c + 0.3 * d), within(1e-5));
    }

    /// Against values that are mended until none changes any more, in any order.
    @ParameterizedTest
    @ValueSource(longs = {1, 2, 3, 4, 5, 6, 7, 8})
    void timesSolveTheEikonalEquation(long seed) {
        var random = new SplittableRandom(seed);
        for (int i = 0; i < 12; i++) {
            obstacles.add(random.nextDouble(-2.9, 2.9), random.nextDouble(-2.9, 2.9));
        }
        TimeField field = field(TimeFieldTest::cautious);
        int goal;
        do {
            goal = random.nextInt(SIDE * SIDE);
        } while (map.distance(goal) < 0.3);
        Point2d place = new Point2d(map.x(goal % SIDE), map.y(goal / SIDE));
        field.spread(place, new Point2d(50, 50)); // nowhere: the wave goes everywhere
        double[] obvious = obvious(goal);
        for (int row = 1; row < SIDE - 1; row++) {
            for (int column = 1; column < SIDE - 1; column++) {
                int cell = row * SIDE + column;
                double expected = obvious[cell];
                double time = field.at(map.x(column) + 1e-9, map.y(row) + 1e-9);
                double least = IntStream.of(0, 1, SIDE, SIDE + 1)
                        .mapToDouble(beside -> obvious[cell + beside])
                        .min()
                        .orElseThrow();
                if (expected > least + 1) { // what is beside it across a corner is taken for as far
                    assertThat(time).isGreaterThan(least);
                } else {
                    assertThat(time).as("%d, %d", column, row).isCloseTo(expected, within(0.02 + 0.02 * expected));
                }
            }
        }
    }

    /// Of places at a goal's cell, by Gauss-Seidel's iterations over all cells.
    private double[] obvious(int goal) {
        var times = new double[SIDE * SIDE];
        Arrays.fill(times, Double.POSITIVE_INFINITY);
        times[goal] = 0;
        boolean changed = true;
        while (changed) {
            changed = false;
            for (int cell = 0; cell < times.length; cell++) {
                double time = solved(times, cell);
                if (time < times[cell] - 1e-9) {
                    times[cell] = time;
                    changed = true;
                }
            }
        }
        return times;
    }

    private double solved(double[] times, int cell) {
        double speed = cautious((Math.floor(map.distance(cell) * 100) + 0.5) / 100);
        if (speed == 0) {
            return Double.POSITIVE_INFINITY;
        }
        int column = cell % SIDE;
        int row = cell / SIDE;
        double beside = Math.min(
                column > 0 ? times[cell - 1] : Double.POSITIVE_INFINITY,
                column < SIDE - 1 ? times[cell + 1] : Double.POSITIVE_INFINITY);
        double above = Math.min(
                row > 0 ? times[cell - SIDE] : Double.POSITIVE_INFINITY,
                row < SIDE - 1 ? times[cell + SIDE] : Double.POSITIVE_INFINITY);
        double step = RESOLUTION / speed;
        if (!(Math.abs(beside - above) < step)) {
            return Math.min(beside, above) + step;
        }
        // (t − beside)² + (t − above)² = step²
        double sum = beside + above;
        return (sum + Math.sqrt(sum * sum - 2 * (beside * beside + above * above - step * step))) / 2;
    }
}
