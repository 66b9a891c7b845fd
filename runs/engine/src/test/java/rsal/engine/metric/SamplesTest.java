package rsal.engine.metric;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import rsal.scenario.condition.MetricExpression.Function;
import rsal.scenario.condition.MetricExpression.Quantile;

class SamplesTest {
    private static final double END = 2_000_000; // s

    @Test
    void quantilesAreByNearestRankToo() {
        Samples samples = of(15, 20, 35, 40, 50);
        assertThat(samples.value(new Quantile(0), END)).hasValue(15);
        assertThat(samples.value(new Quantile(0.2), END)).hasValue(15);
        assertThat(samples.value(new Quantile(0.21), END)).hasValue(20);
        assertThat(samples.value(new Quantile(1), END)).hasValue(50);
        assertThat(times(100, 1).value(new Quantile(0.07), END)).hasValue(1);
    }

    /// 1 for 2 s, 4 for 1 s, 0 for 7 s.
    @Test
    void weightsEachValueByHowLongItWasTheNewest() {
        var samples = new Samples();
        samples.add(10, 1);
        assertThat(samples.value(Function.TIME_WEIGHTED_MEAN, 10)).hasValue(1);
        samples.add(12, 4);
        samples.add(13, 0);
        assertThat(samples.value(Function.TIME_WEIGHTED_MEAN, 20)).hasValue((1 * 2 + 4 * 1) / 10.0);
        assertThat(samples.value(Function.MEAN, 20)).hasValue(5 / 3.0);
        assertThat(samples.value(Function.LAST, 20)).hasValue(0);
        var other = new Samples();
        other.add(12.5, 6);
        Samples all = Samples.together(List.of(samples, other), 20);
        assertThat(all.value(Function.TIME_WEIGHTED_MEAN, 20)).hasValue((6 + 6 * 7.5) / (10 + 7.5));
        assertThat(all.value(Function.LAST, 20)).hasValue(0);
        assertThat(Samples.together(List.of(other, samples), 20).value(Function.LAST, 20))
                .hasValue(0);
    }

    @Test
    void percentilesAreByNearestRank() {
        Samples samples = of(15, 20, 35, 40, 50);
        assertThat(samples.value(Function.P50, END)).hasValue(35);
        assertThat(samples.value(Function.P95, END)).hasValue(50);
        assertThat(of(1).value(Function.P99, END)).hasValue(1);
        assertThat(of(2, 1).value(Function.P50, END)).hasValue(1);
    }

    @Test
    void knowsLeastGreatestAndMean() {
        Samples samples = of(3, 1, 2);
        assertThat(samples.value(Function.MIN, END)).hasValue(1);
        assertThat(samples.value(Function.MAX, END)).hasValue(3);
        assertThat(samples.value(Function.MEAN, END)).hasValue(2);
    }

    @Test
    void hasNothingToSayWithoutSamples() {
        assertThat(new Samples().value(Function.P95, END)).isEmpty();
    }

    @Test
    void joinsThoseOfSeveralRobots() {
        Samples all = Samples.together(List.of(of(1, 2), of(10)), END);
        assertThat(all.value(Function.MAX, END)).hasValue(10);
        assertThat(all.value(Function.P50, END)).hasValue(2);
    }

    @Test
    void thinsOutWhatIsTooMuchToKeep() {
        var random = new SplittableRandom(1);
        var samples = new Samples();
        for (int i = 0; i < 1_000_000; i++) {
            samples.add(i, random.nextDouble());
        }
        samples.add(1_000_000, 7);
        assertThat(samples.value(Function.P95, END).getAsDouble()).isCloseTo(0.95, within(0.01));
        assertThat(samples.value(Function.MAX, END)).hasValue(7); // even if it was not kept
    }

    @Test
    void joinsThoseThatWereThinnedOutByHowManyTheyWere() {
        Samples all = Samples.together(List.of(times(200_000, 0), times(20_000, 11)), END);
        assertThat(all.value(Function.MEAN, END)).hasValue(1);
        assertThat(all.value(Function.P50, END)).hasValue(0);
        assertThat(all.value(Function.P95, END)).hasValue(11);

        Samples few = Samples.together(List.of(times(20_000, 11), times(200_000, 0)), END);
        assertThat(few.value(Function.MEAN, END)).hasValue(1);
        assertThat(few.value(Function.P50, END)).hasValue(0);
        // less than one in twenty
        Samples nineInTen = Samples.together(List.of(times(200_000, 0), times(8_000, 1)), END);
        assertThat(nineInTen.value(Function.P95, END)).hasValue(0);
    }

    private static Samples times(int count, double value) {
        var samples = new Samples();
        for (int i = 0; i < count; i++) {
            samples.add(i, value);
        }
        return samples;
    }

    private static Samples of(double... values) {
        var samples = new Samples();
        for (int i = 0; i < values.length; i++) {
            samples.add(i, values[i]);
        }
        return samples;
    }
}
