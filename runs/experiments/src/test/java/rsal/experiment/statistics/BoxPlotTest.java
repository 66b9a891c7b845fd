package rsal.experiment.statistics;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.Arrays;
import java.util.Random;
import org.junit.jupiter.api.Test;

class BoxPlotTest {
    /// As `quantile` of R has it by default.
    @Test
    void interpolatesQuartiles() {
        BoxPlot box = BoxPlot.of(4, 1, 3, 2);
        assertThat(box.first()).isEqualTo(1.75);
        assertThat(box.median()).isEqualTo(2.5);
        assertThat(box.third()).isEqualTo(3.25);
    }

    @Test
    void whatIsFarOutIsShownByItself() {
        BoxPlot box = BoxPlot.of(1, 2, 3, 4, 5, 100);
        assertThat(box.outside()).containsExactly(100.0);
        assertThat(box.high()).isEqualTo(5);
        assertThat(box.most()).isEqualTo(100);
    }

    @Test
    void ofOneValueItIsALine() {
        assertThat(BoxPlot.of(3)).isEqualTo(BoxPlot.of(3, 3, 3));
        assertThat(BoxPlot.of(3).low()).isEqualTo(BoxPlot.of(3).high());
    }

    /// Hyndman and Fan's definition 7 in words: the sorted values stand at equal distances from 0 to 1, and
    /// between two of them it goes straight.
    @Test
    void quantilesGoStraightFromValueToValue() {
        var random = new Random(5);
        for (int i = 0; i < 500; i++) {
            double[] values = random.doubles(1 + random.nextInt(30), -10, 10).toArray();
            double[] sorted = values.clone();
            Arrays.sort(sorted);
            double share = random.nextDouble();
            double expected = sorted[0];
            for (int k = 0; k + 1 < sorted.length; k++) {
                double from = (double) k / (sorted.length - 1);
                double to = (double) (k + 1) / (sorted.length - 1);
                if (from <= share && share <= to) {
                    expected = sorted[k] * (to - share) / (to - from) + sorted[k + 1] * (share - from) / (to - from);
                }
            }
            assertThat(BoxPlot.quantile(sorted, share)).as("try %d", i).isEqualTo(expected, within(1e-9));
            BoxPlot box = BoxPlot.of(values);
            assertThat(box.outside().size()
                            + Arrays.stream(values)
                                    .filter(v -> v >= box.low() && v <= box.high())
                                    .count())
                    .as("all are shown")
                    .isEqualTo(values.length);
        }
    }
}
