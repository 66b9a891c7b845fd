package rsal.server.history;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import java.util.List;
import java.util.Optional;
import java.util.stream.DoubleStream;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import rsal.server.message.Messages.DeviceNumbers;
import rsal.server.message.Messages.NumberInfo;
import rsal.server.message.Messages.PastNumbers;
import rsal.server.message.Messages.PlottedNumbers;

class NumberHistoryTest {
    private static final int A_SAMPLE = 7; // of one number takes as much as so many

    private final NumberHistory history = new NumberHistory(10 * A_SAMPLE + 10);

    private static PlottedNumbers numbers(double time, DeviceNumbers... devices) {
        return new PlottedNumbers(time, List.of(devices));
    }

    private static DeviceNumbers device(String device, double... values) {
        return new DeviceNumbers(
                device,
                IntStream.range(0, values.length)
                        .mapToObj(i -> new NumberInfo(
                                "n" + i, "", "", Double.isNaN(values[i]) ? Optional.empty() : Optional.of(values[i])))
                        .toList());
    }

    private static List<Optional<Double>> values(Double... values) {
        return List.of(values).stream().map(Optional::of).toList();
    }

    @Test
    void reportsWhatANumberWasAndWhereItWasNone() {
        var large = new NumberHistory();
        large.keep("r1", numbers(0, device("base", 1, 2)));
        large.keep("r1", numbers(0.5, device("base", 3, Double.NaN)));
        large.keep("r1", numbers(1, device("laser", 7), device("base", 4, 5)));
        large.keep("r2", numbers(1, device("base", 8)));
        assertThat(large.past("r1", "base", "n0"))
                .isEqualTo(new PastNumbers(List.of(0.0, 0.5, 1.0), values(1.0, 3.0, 4.0)));
        assertThat(large.past("r1", "base", "n1").values())
                .containsExactly(Optional.of(2.0), Optional.empty(), Optional.of(5.0));
        assertThat(large.past("r1", "laser", "n0").values())
                .containsExactly(Optional.empty(), Optional.empty(), Optional.of(7.0));
        assertThat(large.past("nobody", "base", "n0")).isEqualTo(new PastNumbers(List.of(), List.of()));
    }

    @Test
    void whatIsNotNewerIsNotKept() {
        history.keep("r1", numbers(1, device("base", 1)));
        history.keep("r1", numbers(1, device("base", 2)));
        history.keep("r1", numbers(0.5, device("base", 3)));
        assertThat(history.past("r1", "base", "n0").values()).isEqualTo(values(1.0));
    }

    @Test
    void whenThereAreManyItReachesBackMoreCoarsely() {
        DoubleStream.iterate(0, time -> time < 21, time -> time + 1)
                .forEach(time -> history.keep("r1", numbers(time, device("base", time))));
        List<Double> times = history.past("r1", "base", "n0").times();
        assertThat(times).startsWith(0.0).endsWith(20.0).hasSizeLessThanOrEqualTo(10);
    }

    @Test
    void whereNothingIsReportedItDoesNotGrowForEver() {
        for (int i = 0; i < 100; i++) {
            history.keep("r1", numbers(i));
        }
        assertThat(history.past("r1", "base", "n0").times()).startsWith(0.0).hasSizeLessThan(20);
    }

    /// As of a robot that sees something now and then.
    @Test
    void wordsOfWhatComesAndGoesAreKeptOnce() {
        var large = new NumberHistory();
        for (int i = 0; i < 100; i++) {
            large.keep("r1", i % 2 == 0 ? numbers(i, device("base", i)) : numbers(i, device("base", i, 1, 2)));
            large.keep("r2", numbers(i, device("base", i)));
        }
        assertThat(large.lists()).isEqualTo(2);
        assertThat(large.past("r1", "base", "n0").values()).hasSize(100).doesNotContain(Optional.empty());
        assertThat(large.past("r1", "base", "n1").values()).contains(Optional.empty(), Optional.of(1.0));
    }

    @Test
    void asksTwiceASecondOfTheRun() {
        assertThat(isDue(0, 0)).isTrue();
        assertThat(isDue(0.45, 10)).isFalse();
        assertThat(isDue(0.5, 11)).isTrue();
        assertThat(isDue(0.95, 100)).as("which is slow").isFalse();
    }

    @Test
    void asksFourTimesASecondWhenTheRunGoesByFasterAndGoesOnAsItSlowsDown() {
        assertThat(isDue(0, 0)).isTrue();
        assertThat(isDue(200, 0.2)).isFalse();
        assertThat(isDue(250, 0.25)).isTrue();
        assertThat(isDue(250.5, 0.75)).isTrue();
    }

    private boolean isDue(double time, double now) {
        return history.isDue(Duration.ofNanos((long) (time * 1e9)), (long) (now * 1e9));
    }

    @Test
    void ofManyRobotsThoseAreAskedThatSomebodyWantedToKnowAboutLast() {
        List<String> many = IntStream.range(0, 100).mapToObj(i -> "r" + i).toList();
        history.want("r70");
        history.want("gone");
        history.want("r80");
        assertThat(history.chosen(many)).hasSize(20).startsWith("r80", "r70", "r0", "r1");
        assertThat(history.chosen(many.subList(0, 20))).isEqualTo(many.subList(0, 20));
    }
}
