package rsal.navigation.amcl;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

class KldTest {
    /// Equation 12 of the paper: n = χ²(k−1, 1−δ) / 2ε, with the quantiles from a table of the χ² distribution.
    @ParameterizedTest
    @CsvSource({"3, 9.210", "6, 15.086", "11, 23.209", "21, 37.566", "51, 76.154", "101, 135.807"})
    void isNearTheExactBound(int bins, double chiSquared) {
        double exact = chiSquared / (2 * 0.05);
        assertThat((double) new Kld(0.05, 2.326).particles(bins)).isCloseTo(exact, within(0.01 * exact + 1));
    }

    @ParameterizedTest
    @ValueSource(ints = {0, 1})
    void oneBinNeedsOneParticle(int bins) {
        assertThat(new Kld(0.05, 2.33).particles(bins)).isEqualTo(1);
    }
}
