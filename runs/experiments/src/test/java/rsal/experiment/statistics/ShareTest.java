package rsal.experiment.statistics;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class ShareTest {
    /// As `prop.test(count, of, correct = FALSE)` of R.
    @ParameterizedTest
    @CsvSource({
        "0, 10, 0, 0.2775328",
        "10, 10, 0.7224672, 1",
        "7, 10, 0.3967781, 0.8922087",
        "1, 2, 0.0945312, 0.9054688"
    })
    void isAsWilsonSays(int count, int of, double low, double high) {
        ConfidenceInterval interval = new Share(count, of).interval();
        assertThat(interval.low()).isEqualTo(low, within(1e-6));
        assertThat(interval.high()).isEqualTo(high, within(1e-6));
    }

    /// What the interval is by definition: all probabilities that the score test does not refuse.
    @Test
    void holdsWhatAScoreTestDoesNotRefuse() {
        for (int of : new int[] {1, 2, 5, 17, 100}) {
            for (int count = 0; count <= of; count++) {
                Share share = new Share(count, of);
                ConfidenceInterval interval = share.interval();
                for (int i = 1; i < 2000; i++) {
                    double p = i / 2000.0;
                    double score = Math.abs(share.value() - p) / Math.sqrt(p * (1 - p) / of);
                    if (Math.abs(score - 1.959964) > 1e-3) {
                        assertThat(interval.holds(p)).as("%s, p = %s", share, p).isEqualTo(score < 1.959964);
                    }
                }
            }
        }
    }

    @Test
    void refusesWhatIsNone() {
        assertThatIllegalArgumentException().isThrownBy(() -> new Share(3, 2));
        assertThatIllegalArgumentException().isThrownBy(() -> new Share(0, 0));
    }
}
