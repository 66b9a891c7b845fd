package rsal.agents.patrol;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.junit.jupiter.api.Test;
import rsal.data.Point2d;
import rsal.data.Pose2d;
import rsal.metric.Metric;
import rsal.metric.MetricType;
import rsal.settings.Arguments;
import rsal.testkit.contract.MetricContract;
import rsal.testkit.fake.FakeRun;
import rsal.testkit.fake.FakeRun.Sample;

class IdlenessMetricTest implements MetricContract {
    private static final Point2d DOOR = new Point2d(0, 0);
    private static final Point2d SAFE = new Point2d(10, 0);

    private final FakeRun run = new FakeRun();
    private final Metric watched = type().create(Arguments.defaults(List.of()), run);

    @Override
    public MetricType type() {
        return new IdlenessMetric();
    }

    private void steps(int from, int to) {
        for (int tenth = 10 * from + 1; tenth <= 10 * to; tenth++) {
            run.at(tenth / 10.0);
            watched.onStep();
        }
    }

    private void visits(Point2d place, Pose2d where) {
        run.place("guard-1", "guard", where);
        watched.onMessage("guard-1", new Visited("guard-1", place));
    }

    private List<Double> idleTimes() {
        return run.samples().stream().map(Sample::value).toList();
    }

    @Test
    void eachPlaceCountsOnceASecondFromWhenItIsWatched() {
        steps(0, 5);
        watched.onMessage("guard-1", new Watch(List.of(DOOR, SAFE)));
        steps(5, 8);
        visits(DOOR, new Pose2d(0.9, 0, 1));
        steps(8, 10);
        assertThat(idleTimes()).containsExactly(1.0, 1.0, 2.0, 2.0, 3.0, 3.0, 1.0, 4.0, 2.0, 5.0);
    }

    @Test
    void whoIsNotThereOrSomewhereElseDoesNotCount() {
        watched.onMessage("guard-1", new Watch(List.of(DOOR)));
        steps(0, 2);
        visits(DOOR, new Pose2d(1.1, 0, 0));
        visits(SAFE, new Pose2d(10, 0, 0));
        steps(2, 4);
        assertThat(idleTimes()).containsExactly(1.0, 2.0, 3.0, 4.0);
    }

    @Test
    void whoStaysAtAPlaceMakesNoFurtherVisitUntilItHasLeft() {
        watched.onMessage("guard-1", new Watch(List.of(DOOR)));
        steps(0, 10);
        visits(DOOR, new Pose2d(0, 0, 0));
        steps(10, 20);
        visits(DOOR, new Pose2d(0.5, 0, 0));
        assertThat(watched.value("visitGap", List.of())).isEqualTo(10);
        steps(20, 25);
        assertThat(idleTimes().getLast()).as("nobody left it alone before 20 s").isEqualTo(5);
        run.place("guard-1", "guard", new Pose2d(3, 0, 0));
        steps(25, 40);
        visits(DOOR, new Pose2d(0, 0, 0));
        assertThat(watched.value("visitGap", List.of())).isEqualTo((10 + 20) / 2.0);
    }
}
