package rsal.scenario.text;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class CsvLineTest {
    @Test
    void quotesWhatNeedsIt() {
        assertThat(CsvLine.of(Stream.of("a", "b, c", "say \"d\"", "", "e\nf")))
                .isEqualTo("a,\"b, c\",\"say \"\"d\"\"\",,\"e\nf\"\n");
    }

    @ParameterizedTest
    @ValueSource(strings = {"=1+1", "+cmd", "-cmd", "@SUM(A1)", "\t=1", "=HYPERLINK(1)", "-1-1", "--"})
    void noCellIsAFormula(String words) {
        assertThat(CsvLine.of(Stream.of(words))).isEqualTo("'" + words + "\n");
    }

    @ParameterizedTest
    @ValueSource(strings = {"-1", "+1", "-1.5", "-1.5e-7", "-2.0E10", "-Infinity", "NaN", "-", "0"})
    void numbersStay(String number) {
        assertThat(CsvLine.of(Stream.of(number))).isEqualTo(number + "\n");
    }
}
