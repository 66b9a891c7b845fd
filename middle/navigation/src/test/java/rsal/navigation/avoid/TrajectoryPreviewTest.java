package rsal.navigation.avoid;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import rsal.data.Point2d;
import rsal.data.Twist2d;

class TrajectoryPreviewTest {
    private final TrajectoryPreview ahead = new TrajectoryPreview();

    @ParameterizedTest
    @CsvSource({"0.5,0", "0.5,0.8", "-0.3,0.4", "0.2,-20"})
    void isTheArcOfACommandForTwoSeconds(double vx, double omega) {
        ahead.on(Twist2d.drive(vx, omega));
        List<Point2d> points = ahead.points();
        assertThat(points).hasSizeBetween(2, Controller.PATH_POINTS);
        assertThat(points.getFirst()).isEqualTo(new Point2d(0, 0));
        Point2d end = omega == 0
                ? new Point2d(2 * vx, 0)
                : new Point2d(vx / omega * Math.sin(2 * omega), vx / omega * (1 - Math.cos(2 * omega)));
        assertThat(points.getLast().distanceTo(end)).isLessThan(1e-9);
    }

    @Test
    void straightOnTakesTwoPoints() {
        ahead.on(Twist2d.drive(0.5, 0));
        assertThat(ahead.points()).hasSize(2);
    }

    @Test
    void turnsIntoADirectionAndNotPastIt() {
        double turn = 0.7;
        ahead.into(turn, Twist2d.drive(0.5, 1.4));
        List<Point2d> points = ahead.points();
        double before = 0;
        for (int i = 1; i < points.size(); i++) {
            double bearing = bearing(points.get(i - 1), points.get(i));
            assertThat(bearing).isBetween(before, turn);
            before = bearing;
        }
        assertThat(before).isCloseTo(turn, within(0.03));
    }

    /// As when it creeps on, as there is no room to turn.
    @Test
    void goesStraightWhereItDoesNotTurnAsItShould() {
        ahead.into(1, Twist2d.drive(-0.1, 0));
        assertThat(ahead.points()).containsExactly(new Point2d(0, 0), new Point2d(-0.2, 0));
    }

    @Test
    void endsWhereItIsToEnd() {
        ahead.on(Twist2d.drive(0.5, 0));
        ahead.upTo(0.3);
        assertThat(ahead.points().getLast().distanceTo(new Point2d(0.3, 0))).isLessThan(1e-9);
        ahead.on(Twist2d.drive(0.5, 0));
        assertThat(ahead.points().getLast().distanceTo(new Point2d(1, 0))).isLessThan(1e-9);
    }

    @Test
    void isNothingOfOneThatStandsOrTurnsInPlace() {
        assertThat(ahead.points()).isEmpty();
        ahead.on(Twist2d.drive(0, 1));
        assertThat(ahead.points()).isEmpty();
        ahead.on(Twist2d.drive(1, 0));
        ahead.nowhere();
        assertThat(ahead.points()).isEmpty();
    }

    private static double bearing(Point2d from, Point2d to) {
        return Math.atan2(to.y() - from.y(), to.x() - from.x());
    }

    /// A piece for each 0.2 rad, fifteen at most.
    @ParameterizedTest
    @CsvSource({"0.05, 2", "0.09, 2", "0.11, 3", "0.75, 9", "-0.75, 9", "1.45, 16", "9, 16"})
    void hasAsManyPointsAsItBends(double omega, int points) {
        ahead.on(Twist2d.drive(0.5, omega));
        assertThat(ahead.points()).hasSize(points);
    }

    @Test
    void onAnArcItEndsWhereItIsToEnd() {
        ahead.on(Twist2d.drive(-0.5, 0.8));
        ahead.upTo(0.3);
        double seconds = 0.3 / 0.5;
        var end = new Point2d(-0.5 / 0.8 * Math.sin(0.8 * seconds), -0.5 / 0.8 * (1 - Math.cos(0.8 * seconds)));
        assertThat(ahead.points().getLast().distanceTo(end)).isLessThan(1e-9);
        ahead.upTo(0);
        assertThat(ahead.points()).isEmpty();
        ahead.upTo(-1);
        assertThat(ahead.points()).isEmpty();
        ahead.upTo(9);
        assertThat(ahead.points().getLast().x())
                .as("for two seconds")
                .isCloseTo(-0.5 / 0.8 * Math.sin(1.6), within(1e-9));
    }

    @Test
    void whoIsSlowerThanTwoCentimetersASecondStands() {
        ahead.on(Twist2d.drive(0.019, 0.1));
        assertThat(ahead.points()).isEmpty();
        ahead.on(Twist2d.drive(-0.021, 0.1));
        assertThat(ahead.points()).isNotEmpty();
    }

    /// What is missing decays as 1 - exp(-ω t / turn): by small steps of that.
    @ParameterizedTest
    @CsvSource({"0.7, 0.5, 1.4", "-0.7, 0.5, -1.4", "1.5, 0.3, 0.6", "-0.4, -0.2, -0.5"})
    void theTurnDecays(double turn, double vx, double omega) {
        ahead.into(turn, Twist2d.drive(vx, omega));
        double x = 0;
        double y = 0;
        int steps = 20_000;
        for (int i = 0; i < steps; i++) {
            double time = 2.0 * (i + 0.5) / steps;
            double theta = turn * (1 - Math.exp(-omega / turn * time));
            x += vx * 2 / steps * Math.cos(theta);
            y += vx * 2 / steps * Math.sin(theta);
        }
        assertThat(ahead.points().getLast().distanceTo(new Point2d(x, y))).isLessThan(0.02);
        ahead.into(-turn, Twist2d.drive(vx, omega));
        assertThat(ahead.points()).as("not as it should").containsExactly(new Point2d(0, 0), new Point2d(2 * vx, 0));
    }
}
