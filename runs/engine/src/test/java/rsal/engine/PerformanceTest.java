package rsal.engine;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import rsal.engine.report.Histogram;
import rsal.engine.report.LossReason;
import rsal.engine.report.Performance;
import rsal.engine.report.TopicTraffic;
import rsal.time.Phase;

class PerformanceTest {
    @Test
    void thoseOfTwoRunsAreAddedUp() {
        var one = new Performance(
                Duration.ofSeconds(10),
                times(3_000, 10_000, 10_001, 6_000_000_000L),
                Map.of(Phase.WORLD, Duration.ofMillis(1), Phase.THINK, Duration.ofMillis(5)),
                Map.of(Phase.OBSERVE, Duration.ofMillis(10)),
                List.of(
                        new TopicTraffic("hello", 3, 2, Map.of(LossReason.CHANCE, 1L)),
                        new TopicTraffic("pose", 7, 7, Map.of())),
                Map.of("agent", 4L));
        var other = new Performance(
                Duration.ofSeconds(1),
                times(4_000),
                Map.of(Phase.WORLD, Duration.ofMillis(2)),
                Map.of(Phase.OBSERVE, Duration.ofMillis(20), Phase.DEVICES, Duration.ofMillis(40)),
                List.of(
                        new TopicTraffic("alarm", 1, 1, Map.of()),
                        new TopicTraffic("hello", 10, 1, Map.of(LossReason.CHANCE, 4L, LossReason.RANGE, 5L))),
                Map.of("agent", 1L, "fault", 1L));
        Performance both = one.plus(other);
        assertThat(both.time()).isEqualTo(Duration.ofSeconds(11));
        assertThat(both.steps().counts()).startsWith(3L, 1L, 0L).endsWith(0L, 1L);
        assertThat(both.steps().count()).isEqualTo(5);
        assertThat(both.steps().sum()).isEqualTo(Duration.ofNanos(6_000_027_001L));
        assertThat(both.phases())
                .isEqualTo(Map.of(
                        Phase.WORLD,
                        Duration.ofMillis(3),
                        Phase.DEVICES,
                        Duration.ZERO,
                        Phase.THINK,
                        Duration.ofMillis(5),
                        Phase.OBSERVE,
                        Duration.ZERO));
        assertThat(both.processors())
                .isEqualTo(Map.of(
                        Phase.WORLD,
                        Duration.ZERO,
                        Phase.DEVICES,
                        Duration.ofMillis(40),
                        Phase.THINK,
                        Duration.ZERO,
                        Phase.OBSERVE,
                        Duration.ofMillis(30)));
        assertThat(both.topics())
                .containsExactly(
                        new TopicTraffic("alarm", 1, 1, Map.of()),
                        new TopicTraffic("hello", 13, 3, Map.of(LossReason.CHANCE, 5L, LossReason.RANGE, 5L)),
                        new TopicTraffic("pose", 7, 7, Map.of()));
        assertThat(both.events()).isEqualTo(Map.of("agent", 5L, "fault", 1L));
        assertThat(Performance.NONE.plus(one)).isEqualTo(one);
    }

    @Test
    void topicsOfManyRunsStayBounded() {
        Performance all = Performance.NONE;
        for (int run = 0; run < 5; run++) {
            int from = 400 * run;
            List<TopicTraffic> topics = IntStream.range(from, from + 400)
                    .mapToObj(i -> new TopicTraffic("topic " + i, 1, 0, Map.of()))
                    .toList();
            all = all.plus(new Performance(Duration.ZERO, Histogram.EMPTY, Map.of(), Map.of(), topics, Map.of()));
        }
        assertThat(all.topics()).hasSize(800 + 1);
        assertThat(all.topics()).contains(new TopicTraffic("…", 3 * 400, 0, Map.of()));
        assertThat(all.topics().stream().mapToLong(TopicTraffic::said).sum()).isEqualTo(5 * 400);
    }

    private static Histogram times(long... nanos) {
        var times = new StepTimes();
        for (long one : nanos) {
            times.took(one);
        }
        return times.soFar();
    }
}
