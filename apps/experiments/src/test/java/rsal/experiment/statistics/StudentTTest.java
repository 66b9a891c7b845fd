package rsal.experiment.statistics;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

class StudentTTest {
    /// Abramowitz and Stegun, table 26.10, two-sided 95 %.
    @ParameterizedTest
    @CsvSource({"1, 12.706", "2, 4.303", "3, 3.182", "4, 2.776", "9, 2.262", "10, 2.228", "29, 2.045", "120, 1.980"})
    void isAsInTables(int freedom, double t) {
        assertThat(StudentT.critical(0.95, freedom)).isEqualTo(t, within(0.0005));
    }

    @Test
    void getsNearTheNormalDistribution() {
        assertThat(StudentT.critical(0.95, 100_000)).isEqualTo(1.96, within(0.0001));
    }

    /// With t = √n tan θ the density is cosⁿ⁻¹ θ but for a factor.
    @ParameterizedTest
    @ValueSource(ints = {1, 2, 3, 4, 7, 12, 31, 100})
    void isTheAreaUnderTheDensity(int freedom) {
        for (double t : new double[] {0.01, 0.5, 1, 2, 5, 40}) {
            double area = area(Math.atan(t / Math.sqrt(freedom)), freedom) / area(Math.PI / 2, freedom);
            assertThat(StudentT.within(t, freedom)).as("t = %s", t).isEqualTo(area, within(1e-7));
        }
    }

    private static double area(double to, int freedom) {
        int pieces = 20_000;
        double sum = 0;
        for (int i = 0; i < pieces; i++) {
            sum += Math.pow(Math.cos((i + 0.5) * to / pieces), freedom - 1) * to / pieces;
        }
        return sum;
    }
}
