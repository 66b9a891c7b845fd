package rsal.scenario.run;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.SplittableRandom;
import java.util.stream.DoubleStream;
import org.junit.jupiter.api.Test;
import rsal.scenario.condition.Measure.Function;

class SamplesTest {
    @Test
    void percentilesAreByNearestRank() {
        Samples samples = of(15, 20, 35, 40, 50);
        assertThat(samples.value(Function.P50)).hasValue(35);
        assertThat(samples.value(Function.P95)).hasValue(50);
        assertThat(of(1).value(Function.P99)).hasValue(1);
        assertThat(of(2, 1).value(Function.P50)).hasValue(1);
    }

    @Test
    void knowsLeastGreatestAndMean() {
        Samples samples = of(3, 1, 2);
        assertThat(samples.value(Function.MIN)).hasValue(1);
        assertThat(samples.value(Function.MAX)).hasValue(3);
        assertThat(samples.value(Function.MEAN)).hasValue(2);
    }

    @Test
    void hasNothingToSayWithoutSamples() {
        assertThat(new Samples().value(Function.P95)).isEmpty();
    }

    @Test
    void joinsThoseOfSeveralRobots() {
        Samples all = of(1, 2);
        all.addAll(of(10));
        assertThat(all.value(Function.MAX)).hasValue(10);
        assertThat(all.value(Function.P50)).hasValue(2);
    }

    @Test
    void thinsOutWhatIsTooMuchToKeep() {
        var random = new SplittableRandom(1);
        var samples = new Samples();
        for (int i = 0; i < 1_000_000; i++) {
            samples.add(random.nextDouble());
        }
        samples.add(7);
        assertThat(samples.value(Function.P95).getAsDouble()).isCloseTo(0.95, within(0.01));
        assertThat(samples.value(Function.MAX)).hasValue(7); // even if it was not kept
    }

    @Test
    void joinsThoseThatWereThinnedOutByHowManyTheyWere() {
        Samples all = times(200_000, 0);
        all.addAll(times(20_000, 11));
        assertThat(all.value(Function.MEAN)).hasValue(1);
        assertThat(all.value(Function.P50)).hasValue(0);
        assertThat(all.value(Function.P95)).hasValue(11);

        Samples few = times(20_000, 11);
        few.addAll(times(200_000, 0));
        assertThat(few.value(Function.MEAN)).hasValue(1);
        assertThat(few.value(Function.P50)).hasValue(0);
        Samples nineInTen = times(200_000, 0);
        nineInTen.addAll(times(8_000, 1)); // less than one in twenty
        assertThat(nineInTen.value(Function.P95)).hasValue(0);
    }

    private static Samples times(int count, double value) {
        var samples = new Samples();
        for (int i = 0; i < count; i++) {
            samples.add(value);
        }
        return samples;
    }

    private static Samples of(double... values) {
        var samples = new Samples();
        DoubleStream.of(values).forEach(samples::add);
        return samples;
    }
}
