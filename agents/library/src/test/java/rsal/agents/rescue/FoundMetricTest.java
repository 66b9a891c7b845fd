package rsal.agents.rescue;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.OptionalInt;
import org.junit.jupiter.api.Test;
import rsal.data.Point2d;
import rsal.data.Pose2d;
import rsal.metric.Metric;
import rsal.metric.MetricType;
import rsal.metric.ThingState;
import rsal.settings.Arguments;
import rsal.testkit.contract.MetricContract;
import rsal.testkit.fake.FakeRun;
import rsal.testkit.fake.FakeRun.Event;

class FoundMetricTest implements MetricContract {
    private final FakeRun run = new FakeRun();
    private final Metric findings = type().create(Arguments.defaults(List.of()), run);

    @Override
    public MetricType type() {
        return new FoundMetric();
    }

    private void says(int marker, double x) {
        findings.onMessage("scout-1", new VictimFound("scout-1", marker, new Point2d(x, 2)));
    }

    private double found(String group) {
        return findings.value("found", List.of(group));
    }

    @Test
    void whoSaysWhereItIsAndIsRightHasFoundIt() {
        run.place(new ThingState("victim-1", "victim", OptionalInt.of(7), new Pose2d(5, 2, 0)));
        run.place(new ThingState("box-1", "box", OptionalInt.empty(), new Pose2d(5, 2, 0)));
        says(8, 5);
        says(7, 6.1);
        assertThat(found("victim")).isZero();
        says(7, 5.9);
        says(7, 5.1);
        assertThat(found("victim")).isEqualTo(1);
        assertThat(found("box")).isZero();
        assertThat(run.events()).containsExactly(new Event("found", "victim-1", "is found by scout-1"));
    }
}
