package rsal.experiment.statistics;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.Random;
import org.junit.jupiter.api.Test;

class HolmTest {
    /// statsmodels 0.15.0 (Python): `multipletests([…], method="holm")[1]`.
    @Test
    void isAsStatsmodelsHasIt() {
        assertThat(Holm.corrected(0.01, 0.04, 0.03, 0.005, 0.2))
                .containsExactly(new double[] {0.04, 0.09, 0.09, 0.025, 0.2}, within(1e-12));
        assertThat(Holm.corrected()).isEmpty();
        assertThat(Holm.corrected(0.7)).containsExactly(0.7);
    }

    /// Where nothing differs, one family of ten comparisons in twenty has a false alarm, not four.
    @Test
    void raisesAFalseAlarmInOneFamilyOfTwenty() {
        var random = new Random(3);
        int families = 20_000;
        int alarms = 0;
        for (int i = 0; i < families; i++) {
            double[] corrected = Holm.corrected(random.doubles(10, 0, 1).toArray());
            for (double p : corrected) {
                if (p < 0.05) {
                    alarms++;
                    break;
                }
            }
        }
        assertThat((double) alarms / families).isLessThan(0.05 + 4 * Math.sqrt(0.05 * 0.95 / families));
    }
}
