package rsal.bench.measurement;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.tuple;
import static org.assertj.core.api.Assertions.within;

import java.util.Optional;
import java.util.Random;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class ConfidenceTest {
    @Test
    void isAsTablesHaveIt() {
        assertThat(Confidence.margin(1, 3)).isEqualTo(12.706, within(1e-9)); // s / √n = 1
        assertThat(Confidence.margin(2, 4, 4, 4, 5, 5, 7, 9)).isEqualTo(2.365 * 2.13809 / Math.sqrt(8), within(1e-4));
        assertThat(Confidence.margin(4)).isNaN();
    }

    @Test
    void theIntervalLiesAroundTheMean() {
        assertThat(Confidence.less("a.s", "s", 1, 3, 5))
                .extracting(Result::name, result -> Math.round(1e3 * result.value()))
                .containsExactly(tuple("a.s", 3000L), tuple("a.s.low", -1969L), tuple("a.s.high", 7969L));
        assertThat(Confidence.more("a.s", "s", 4))
                .containsExactly(new Result("a.s", 4, 4, 4, "s", "more", Optional.empty()));
    }

    /// So often the interval holds the true mean.
    @ParameterizedTest
    @ValueSource(ints = {5, 30, 60})
    void holdsTheMeanInNineteenOfTwenty(int size) {
        var random = new Random(size);
        int runs = 20_000;
        long held = IntStream.range(0, runs)
                .filter(_ -> {
                    double[] values =
                            random.doubles(size).map(_ -> random.nextGaussian()).toArray();
                    double mean = IntStream.range(0, size)
                            .mapToDouble(i -> values[i])
                            .average()
                            .orElseThrow();
                    return Math.abs(mean) <= Confidence.margin(values);
                })
                .count();
        assertThat(held / (double) runs).isEqualTo(0.95, within(0.006));
    }
}
