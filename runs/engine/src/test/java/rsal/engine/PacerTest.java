package rsal.engine;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;

class PacerTest {
    private static final long SECOND = 1_000_000_000;

    private long now = 5 * SECOND;
    private final Pacer pace = new Pacer(() -> now, 2);

    @Test
    void holdsTheRunBackToItsSpeed() {
        assertThat(pace.early(SECOND)).isEqualTo(SECOND / 2);
        now += SECOND / 4;
        assertThat(pace.early(SECOND)).isEqualTo(SECOND / 4);
        now += SECOND / 4;
        assertThat(pace.early(SECOND)).isZero();
    }

    @Test
    void aNewSpeedCountsFromNowOn() {
        pace.speed(0.5, SECOND);
        assertThat(pace.early(2 * SECOND)).isEqualTo(2 * SECOND);
    }

    @Test
    void aLimitHoldsItBackFurtherUntilItIsGone() {
        pace.limit(1, SECOND);
        assertThat(pace.early(2 * SECOND)).isEqualTo(SECOND);
        now += SECOND / 2;
        pace.limit(1, SECOND); // which is no new one
        assertThat(pace.early(2 * SECOND)).isEqualTo(SECOND / 2);
        pace.speed(Double.POSITIVE_INFINITY, 2 * SECOND);
        assertThat(pace.early(3 * SECOND)).isEqualTo(SECOND);
        pace.limit(Double.POSITIVE_INFINITY, 2 * SECOND);
        assertThat(pace.early(1000 * SECOND)).isZero();
        pace.speed(0.5, SECOND);
        pace.limit(1, SECOND);
        assertThat(pace.early(2 * SECOND)).isEqualTo(2 * SECOND);
    }

    @Test
    void doesNotHurryAfterAPauseOrADelay() {
        now += 60 * SECOND;
        pace.restart(SECOND);
        assertThat(pace.early(2 * SECOND)).isEqualTo(SECOND / 2);
        now += 60 * SECOND;
        assertThat(pace.early(2 * SECOND)).isNegative();
        assertThat(pace.early(3 * SECOND)).isEqualTo(SECOND / 2); // not 59 s late
    }

    @Test
    void isAheadWhenItGoesAsFastAsItCanAndFasterThanRealTime() {
        now += SECOND;
        assertThat(pace.isAhead(3 * SECOND)).as("it has a speed").isFalse();
        pace.speed(Double.POSITIVE_INFINITY, 0);
        now += SECOND;
        assertThat(pace.isAhead(SECOND / 2)).isFalse();
        assertThat(pace.isAhead(2 * SECOND)).isTrue();
    }

    @Test
    void neverWaitsWhenItShallGoAsFastAsItCan() {
        pace.speed(Double.POSITIVE_INFINITY, 0);
        assertThat(pace.early(1000 * SECOND)).isZero();
    }

    @Test
    void measuresTheSpeedThatItHas() {
        assertThat(pace.rate(0)).isZero();
        now += SECOND;
        assertThat(pace.rate(3 * SECOND)).isCloseTo(3, within(1e-9));
        now += SECOND / 10;
        assertThat(pace.rate(4 * SECOND)).isCloseTo(3, within(1e-9)); // too short to tell
    }
}
