package rsal.engine;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.junit.jupiter.api.Test;
import rsal.data.Point2d;
import rsal.data.Pose2d;
import rsal.scenario.condition.Measure.Function;

class PatrolMetricsTest {
    private static final Point2d DOOR = new Point2d(0, 0);
    private static final Point2d SAFE = new Point2d(10, 0);

    private final PatrolMetrics watched = new PatrolMetrics();

    private void look(int from, int to) {
        for (int tenth = 10 * from + 1; tenth <= 10 * to; tenth++) {
            watched.look(tenth / 10.0);
        }
    }

    @Test
    void eachPlaceCountsOnceASecondFromWhenItIsWatched() {
        look(0, 5);
        watched.watch(List.of(DOOR, SAFE), 5);
        look(5, 8);
        watched.visit(DOOR, new Pose2d(0.9, 0, 1), 8);
        look(8, 10);
        assertThat(watched.idleTimes().value(Function.MAX, 100)).hasValue(5);
        assertThat(watched.idleTimes().value(Function.MEAN, 100))
                .hasValue((1 + 2 + 3 + 1 + 2 + 1 + 2 + 3 + 4 + 5) / 10.0);
    }

    @Test
    void whoIsNotThereOrSomewhereElseDoesNotCount() {
        watched.watch(List.of(DOOR), 0);
        look(0, 2);
        watched.visit(DOOR, new Pose2d(1.1, 0, 0), 2);
        watched.visit(SAFE, new Pose2d(10, 0, 0), 2);
        look(2, 4);
        assertThat(watched.idleTimes().value(Function.MAX, 100)).hasValue(4);
    }
}
