package rsal.experiment.report;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class NumberFormatsTest {
    @ParameterizedTest
    @CsvSource({
        "0.039, 6.1e-4, 0.0390 ± 0.0006",
        "0.039, 1.2e-4, 0.03900 ± 0.00012",
        "17.51, 0.902, 17.5 ± 0.9",
        "17.28, 1.37, 17.3 ± 1.4",
        "76.73, 37.22, 77 ± 37",
        "0, 0, 0 ± 0",
        "-0.5, 0.0296, −0.50 ± 0.03",
        "1234567, 40000, (1.23 ± 0.04)e6",
        "0.000123, 0.00002, (1.23 ± 0.20)e-4",
    })
    void aValueHasAsManyDigitsAsItsErrorLeavesSure(double value, double error, String text) {
        assertThat(NumberFormats.withError(value, error)).isEqualTo(text);
    }
}
