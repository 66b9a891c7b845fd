package rsal.experiment.report;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class ScaleTest {
    @ParameterizedTest
    @CsvSource({"0, 0", "0, 0.3", "7, 7", "-7, -7", "-3, 1e6"})
    void hasRoomForItsNumbersAndAFewThatAreReported(double least, double most) {
        Scale scale = Scale.of(least, most, 100, 300);
        assertThat(scale.at(least)).isBetween(100.0, 300.0);
        assertThat(scale.at(most)).isBetween(scale.at(least), 300.0);
        assertThat(scale.ticks()).hasSizeBetween(2, 9);
    }

    @Test
    void countsWhatNeverHappenedFromZeroToOne() {
        assertThat(Scale.of(0, 0, 100, 300).ticks()).contains(0.0, 1.0).allMatch(tick -> tick >= 0 && tick <= 1);
    }
}
