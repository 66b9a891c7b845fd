package rsal.navigation.amcl;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class LocalizationMonitorTest {
    private static final int BEAMS = 60;

    private final LocalizationMonitor evidence = new LocalizationMonitor(15);

    @Test
    void beamsThatEndAtWallsMakeAPosePlausible() {
        assertThat(evidence.isPlausible()).isFalse();
        double before = evidence.probability();
        for (int i = 0; i < 6; i++) {
            evidence.add(BEAMS, 0, 0);
            assertThat(evidence.probability()).isGreaterThan(before);
            before = evidence.probability();
        }
        assertThat(evidence.isPlausible()).isTrue();
        assertThat(evidence.isRefuted()).isFalse();
    }

    @Test
    void aFifthThroughWallsRefutesWhatWasRightForLong() {
        evidence.trust();
        for (int i = 0; i < 12; i++) {
            evidence.add(BEAMS * 6 / 10, BEAMS / 5, BEAMS / 5);
        }
        assertThat(evidence.isRefuted()).isTrue();
        assertThat(evidence.probability()).isLessThan(0.2);
    }

    @Test
    void oneScanThatFitsNowhereDoesNot() {
        evidence.trust();
        evidence.add(0, BEAMS, 0);
        assertThat(evidence.isPlausible()).isTrue();
    }

    /// As much as maps and lasers are wrong where robots are right.
    @ParameterizedTest
    @ValueSource(longs = {1, 2, 3, 4, 5, 6})
    void aFewThroughWallsAndSomebodyInSightAreUsual(long seed) {
        var random = new SplittableRandom(seed);
        evidence.trust();
        for (int i = 0; i < 500; i++) {
            int through = random.nextInt(6);
            int shorter = random.nextInt(20);
            evidence.add(BEAMS - through - shorter, through, shorter);
            assertThat(evidence.isPlausible()).as("scan %d", i).isTrue();
        }
    }

    @Test
    void whatIsSeenAllTheTimeBeforeWallsIsNotEverybody() {
        evidence.trust();
        for (int i = 0; i < 60; i++) {
            evidence.add(BEAMS / 10, 0, BEAMS * 9 / 10);
        }
        assertThat(evidence.isRefuted()).isTrue();
    }

    @Test
    void fewBeamsSayLittleAndNoneSaysNothing() {
        var few = new LocalizationMonitor(15);
        few.add(0, 2, 0);
        evidence.add(0, 15, 0);
        assertThat(few.probability()).isBetween(evidence.probability(), 0.5);
        double before = evidence.probability();
        evidence.add(0, 0, 0);
        assertThat(evidence.probability()).isEqualTo(before);
    }
}
