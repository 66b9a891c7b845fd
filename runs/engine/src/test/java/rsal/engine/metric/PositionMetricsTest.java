package rsal.engine.metric;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import rsal.data.Point2d;
import rsal.data.Pose2d;
import rsal.engine.metric.ReachedMetrics.There;
import rsal.scenario.Place;
import rsal.scenario.Place.Disc;
import rsal.scenario.Place.Rectangle;

class PositionMetricsTest {
    private final PositionMetrics positions = new PositionMetrics(List.of(
            new Place("den", new Disc(new Point2d(0, 0), 1)),
            new Place("hall", new Rectangle(new Point2d(-2, -1), new Point2d(5, 1)))));

    @Test
    void knowsTheNearestOfTwoRoles() {
        assertThat(positions.distance("prey", "hunter")).isNaN();
        look("prey", 0, 0, "prey", 9, 0, "hunter", 3, 4, "hunter", 9, 1);
        assertThat(positions.distance("prey", "hunter")).isEqualTo(1);
        assertThat(positions.distance("hunter", "prey")).isEqualTo(1);
        assertThat(positions.distance("prey", "prey")).isEqualTo(9);
        look("prey", 0, 0);
        assertThat(positions.distance("prey", "prey")).isNaN();
    }

    @Test
    void countsWhoIsInAPlace() {
        look("prey", 0, 0, "prey", 0, 1, "prey", 0, 1.001, "hunter", 4.9, -1);
        assertThat(positions.within("prey", "den")).isEqualTo(2);
        assertThat(positions.within("prey", "hall")).isEqualTo(2);
        assertThat(positions.within("hunter", "hall")).isEqualTo(1);
        assertThat(positions.within("hunter", "den")).isZero();
    }

    @Test
    void countsThoseWhoComeNotThoseWhoStartThere() {
        look("prey", 0, 0, "hunter", 3, 0);
        assertThat(positions.visits("prey", "den")).isZero();
        look("prey", 2, 0, "hunter", 0.5, 0);
        look("prey", 0, 0, "hunter", 0, 0);
        assertThat(positions.visits("prey", "den")).isOne();
        assertThat(positions.visits("hunter", "den")).isOne();
    }

    @Test
    void countsOnceWhoTurnsAtTheBorder() {
        look("prey", 2, 0);
        for (int i = 0; i < 10; i++) {
            look("prey", 0.99, 0);
            look("prey", 1.05, 0);
        }
        assertThat(positions.visits("prey", "den")).isOne();
        look("prey", 1.2, 0);
        look("prey", 0.99, 0);
        assertThat(positions.visits("prey", "den")).isEqualTo(2);
    }

    /// A step.
    ///
    /// @param robots role, x, y of each
    private void look(Object... robots) {
        var there = new ArrayList<There>();
        for (int i = 0; i < robots.length; i += 3) {
            double x = ((Number) robots[i + 1]).doubleValue();
            double y = ((Number) robots[i + 2]).doubleValue();
            there.add(new There("robot-" + i, (String) robots[i], new Pose2d(x, y, 0)));
        }
        positions.look(there);
    }
}
