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
}
