package rsal.server.history;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import rsal.server.history.DownsampledSeries.Entry;

class DownsampledSeriesTest {
    private static final Duration SPACING = Duration.ofMillis(500);

    private final DownsampledSeries<float[]> series = new DownsampledSeries<>(10_000, SPACING, Bytes::beyond);

    private static Duration seconds(double seconds) {
        return Duration.ofMillis(Math.round(1000 * seconds));
    }

    private static float[] numbered(int number) {
        float[] values = new float[100];
        values[0] = number;
        return values;
    }

    private float at(double seconds) {
        return series.at(seconds(seconds)).orElseThrow().value()[0];
    }

    @Test
    void hasTheNewestByATimeAndTheFirstBeforeThat() {
        assertThat(series.at(Duration.ZERO)).isEmpty();
        series.keep(seconds(1), numbered(1));
        series.keep(seconds(2), numbered(2));
        assertThat(at(0)).isEqualTo(1);
        assertThat(at(1.9)).isEqualTo(1);
        assertThat(at(2)).isEqualTo(2);
        assertThat(at(1e6)).isEqualTo(2);
        assertThat(series.isDue(seconds(2.4))).isFalse();
        assertThat(series.isDue(seconds(2.5))).isTrue();
    }

    /// While a run is paused, people change it.
    @Test
    void whatIsOfTheSameTimeIsReplaced() {
        series.keep(seconds(1), numbered(1));
        long bytes = series.bytes();
        assertThat(series.endsAt(seconds(1))).isTrue();
        series.keep(seconds(1), numbered(2));
        assertThat(at(1)).isEqualTo(2);
        assertThat(series.bytes()).isEqualTo(bytes);
    }

    @Test
    void howeverLongItIsItAllIsThereWithinItsBytes() {
        for (int i = 0; i < 5000; i++) {
            if (series.isDue(seconds(i))) {
                series.keep(seconds(i), numbered(i));
            }
            assertThat(series.bytes()).isLessThanOrEqualTo(10_000);
        }
        assertThat(at(0)).isZero();
        for (int i = 0; i < 5000; i += 250) {
            assertThat(at(i)).isBetween(i - 1000F, (float) i);
        }
    }

    /// As a run is that goes on by steps.
    @Test
    void whatIsKeptMoreOftenMakesTheRestNoCoarser() {
        for (int i = 0; i < 10; i++) {
            series.keep(seconds(i), numbered(i));
        }
        for (int i = 1; i <= 10_000; i++) {
            series.keep(seconds(9.001 + i / 1e5), numbered(100 + i)); // rounded to a ms: some take the place of others
            assertThat(series.bytes()).isLessThanOrEqualTo(10_000);
            assertThat(at(1e6)).as("the newest").isEqualTo(100 + i);
        }
        assertThat(series.isDue(seconds(9.7))).isTrue();
        for (int i = 0; i < 10; i++) {
            assertThat(at(i)).isEqualTo(i);
        }
    }

    @Test
    void reportsWhatBecameAnother() {
        var words = new DownsampledSeries<Optional<String>>(10_000, SPACING, Bytes::beyond);
        words.keep(seconds(1), Optional.of("a"));
        words.keep(seconds(2), Optional.empty());
        words.keep(seconds(3), Optional.of("a"));
        words.keep(seconds(4), Optional.of("b"));
        words.keep(seconds(5), Optional.of("c"));
        assertThat(words.until(seconds(4.5), word -> word))
                .isEqualTo(List.of(new Entry<>(seconds(1), "a"), new Entry<>(seconds(4), "b")));
    }
}
