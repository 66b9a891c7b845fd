package rsal.agents.formation;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import org.junit.jupiter.api.Test;
import rsal.agents.formation.FormationSlots.Slot;
import rsal.data.Pose2d;
import rsal.metric.Metric;
import rsal.metric.MetricType;
import rsal.settings.Arguments;
import rsal.testkit.contract.MetricContract;
import rsal.testkit.fake.FakeRun;

class FormationMetricTest implements MetricContract {
    private final FakeRun run = new FakeRun();
    private final Metric formations = type().create(Arguments.defaults(List.of()), run);

    @Override
    public MetricType type() {
        return new FormationMetric();
    }

    /// The place of `r` moves by 1 m in a second.
    private void says(boolean formed) {
        var slot = new Slot(new Pose2d(0, 0, 0), new Pose2d(1, 0, 0));
        formations.onMessage(
                "leader", new FormationSlots("wedge", formed, Duration.ofSeconds(1), new TreeMap<>(Map.of("r", slot))));
    }

    private void steps(int from, int to) {
        for (int tenth = 10 * from + 1; tenth <= 10 * to; tenth++) {
            run.at(tenth / 10.0);
            formations.onStep();
        }
    }

    private double forming() {
        return formations.value("formationTime", List.of());
    }

    @Test
    void whatTakesUntilAllAreInPlaceCounts() {
        steps(0, 1);
        says(false);
        steps(1, 3);
        assertThat(forming()).isCloseTo(2, within(1e-6));
        assertThat(run.samples()).isEmpty();
        says(true);
        steps(3, 4);
        assertThat(forming()).isCloseTo(2, within(1e-6));
    }

    @Test
    void aLeaderWhoIsNotHeardOfForTwoSecondsLeadsNobody() {
        steps(0, 1);
        says(false);
        steps(1, 9);
        assertThat(forming()).isCloseTo(2, within(1e-6));
    }

    @Test
    void eachRobotIsComparedWithWhereItShouldBeNow() {
        run.place("r", "follower", new Pose2d(0, 0.5, 0));
        run.placeNowhere("lost", "follower");
        says(true);
        run.at(0.5);
        formations.onStep();
        assertThat(run.samples()).singleElement().satisfies(sample -> {
            assertThat(sample.robot()).isEqualTo("r");
            assertThat(sample.value()).isCloseTo(Math.hypot(0.5, 0.5), within(1e-9));
        });
    }
}
