package rsal.navigation.amcl;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class TrackingMonitorTest {
    private final TrackingMonitor monitor = new TrackingMonitor(15);

    /// Whether a pose that was right for long is refuted by scans of this kind.
    @ParameterizedTest
    @CsvSource({
        "60, 0, 0, false",
        "36, 12, 12, false", // a fifth through walls, a fifth short
        "40, 20, 0, false", // a wall was moved
        "36, 0, 24, false", // furniture
        "18, 24, 18, true", // carried elsewhere
        "6, 0, 54, true", // somebody all around, or elsewhere
        "20, 40, 0, true"
    })
    void reportsAPlaceThatChangedFromAWrongPose(int hits, int through, int shorter, boolean refuted) {
        monitor.trust();
        for (int i = 0; i < 60; i++) {
            monitor.add(hits, through, shorter);
        }
        assertThat(monitor.isRefuted()).isEqualTo(refuted);
        assertThat(monitor.isPlausible()).isEqualTo(!refuted);
        assertThat(monitor.explained()).isCloseTo(hits / 60.0, within(0.01));
    }

    @Test
    void oneScanThatFitsNowhereDoesNotRefute() {
        monitor.trust();
        monitor.add(0, 60, 0);
        assertThat(monitor.isPlausible()).isTrue();
        assertThat(monitor.explained()).isCloseTo(0.9, within(1e-9));
    }

    @Test
    void noBeamsSayNothing() {
        monitor.add(20, 3, 2);
        double before = monitor.probability();
        monitor.add(0, 0, 0);
        assertThat(monitor.probability()).isEqualTo(before);
    }

    @Test
    void knowsNothingAtFirst() {
        assertThat(monitor.probability()).isEqualTo(0.5);
        assertThat(monitor.speaksFor()).isFalse();
        monitor.add(60, 0, 0);
        assertThat(monitor.speaksFor()).isTrue();
        assertThat(monitor.isPlausible()).isFalse();
        monitor.restart();
        assertThat(monitor.probability()).isEqualTo(0.5);
    }
}
