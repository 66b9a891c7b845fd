package rsal.experiment.statistics;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;
import static org.assertj.core.api.Assertions.within;

import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class MeanTest {
    @Test
    void isAsByHand() {
        Mean mean = Mean.of(1, 2, 3, 4);
        assertThat(mean.value()).isEqualTo(2.5);
        assertThat(mean.deviation()).isEqualTo(Math.sqrt(5.0 / 3), within(1e-12));
        double margin = 3.182446 * Math.sqrt(5.0 / 3) / 2; // qt(0.975, 3) of R
        assertThat(mean.interval().orElseThrow().low()).isEqualTo(2.5 - margin, within(1e-6));
        assertThat(mean.interval().orElseThrow().high()).isEqualTo(2.5 + margin, within(1e-6));
    }

    /// SciPy 1.17.1: `ttest_rel([29.89, 29.93, …], [30.02, 29.99, …])`, its `pvalue` and `confidence_interval()`.
    @Test
    void comparesPairsAsSciPyDoes() {
        Mean mean = Mean.of(-0.13, -0.06, -0.39, 0.01, 0.01, -0.01);
        assertThat(mean.pValue().orElseThrow()).isEqualTo(0.19143688433660136, within(1e-9));
        assertThat(mean.interval().orElseThrow().low()).isEqualTo(-0.2567288938447377, within(1e-9));
        assertThat(mean.interval().orElseThrow().high()).isEqualTo(0.06672889384473878, within(1e-9));
        assertThat(mean.standardized().orElseThrow()).isEqualTo(-0.6164414002968925, within(1e-9));
        assertThat(Mean.of(0, 0).pValue()).hasValue(1);
        assertThat(Mean.of(2, 2).pValue()).hasValue(0);
        assertThat(Mean.of(2, 2).standardized()).isEmpty();
        assertThat(Mean.of(2).pValue()).isEmpty();
    }

    @Test
    void ofOneValueNobodyKnowsHowSureItIs() {
        assertThat(Mean.of(7).interval()).isEmpty();
        assertThatIllegalArgumentException().isThrownBy(Mean::of);
    }

    /// Of 20,000 intervals, 95 % hold the truth, give or take 4 standard errors.
    @ParameterizedTest
    @ValueSource(ints = {2, 3, 10})
    void holdsTheTruthAsOftenAsItSays(int count) {
        var random = new Random(17);
        int trials = 20_000;
        int held = 0;
        for (int i = 0; i < trials; i++) {
            double[] sample = random.doubles(count)
                    .map(_ -> 5 + 3 * random.nextGaussian())
                    .toArray();
            held += Mean.of(sample).interval().orElseThrow().holds(5) ? 1 : 0;
        }
        assertThat((double) held / trials).isEqualTo(0.95, within(4 * Math.sqrt(0.95 * 0.05 / trials)));
    }
}
