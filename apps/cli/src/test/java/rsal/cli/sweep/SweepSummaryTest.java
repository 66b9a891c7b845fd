package rsal.cli.sweep;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class SweepSummaryTest {
    @ParameterizedTest
    @CsvSource({"0, false", "1, false", "2, true", "4, true", "5, false", "10, false"})
    void saysWhyIntervalsOfFewRunsAreWide(int runs, boolean reported) {
        assertThat(SweepSummary.aboutFewRuns(runs).contains("only %d runs".formatted(runs)))
                .isEqualTo(reported);
    }
}
