package rsal.player.device;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import java.time.Instant;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class ServerClockTest {
    private static final Instant START = Instant.parse("2026-01-01T12:00:00Z");

    private final ServerClock clock = new ServerClock();

    private static Instant at(double seconds) {
        return START.plusNanos(Math.round(seconds * 1e9));
    }

    private static double seconds(Instant instant) {
        return Duration.between(START, instant).toNanos() * 1e-9;
    }

    @Test
    void aReadingThatCameSlowlyIsAsOldAsItsWayWasLonger() {
        var random = new SplittableRandom(3);
        double error = 0;
        for (int i = 0; i < 500; i++) {
            double taken = 0.1 * i;
            double distance = 0.001 + (i % 10 == 0 ? 0 : 0.05 * random.nextDouble());
            Instant reported = clock.taken(777 + taken, at(taken + distance));
            assertThat(reported).isBeforeOrEqualTo(at(taken + distance));
            if (i > 0) { // whoever came first can't be judged
                error = Math.max(error, Math.abs(seconds(reported) - taken));
            }
        }
        assertThat(error).isLessThan(0.0011);
    }

    @ParameterizedTest
    @ValueSource(doubles = {0.1, 0.5, 0.9, 1.1, 2, 10})
    void aServerWhoseTimeGoesAtAnotherSpeedIsNeverFarOff(double speed) {
        Instant last = Instant.MIN;
        for (int i = 0; i < 1000; i++) {
            Instant now = at(0.1 * i);
            Instant reported = clock.taken(0.1 * i * speed, now);
            assertThat(reported)
                    .isBetween(now.minus(Duration.ofMillis(201)), now)
                    .isAfterOrEqualTo(last);
            last = reported;
        }
    }

    @Test
    void aServerThatBeginsAgainIsBelievedAtOnce() {
        for (int i = 0; i < 100; i++) {
            clock.taken(1000 + 0.1 * i, at(0.1 * i));
        }
        Instant now = at(10);
        assertThat(clock.taken(0, now)).isBetween(now.minus(Duration.ofMillis(201)), now);
        for (int i = 1; i < 100; i++) {
            clock.taken(0.1 * i, at(10 + 0.1 * i));
        }
        assertThat(clock.taken(10, at(20))).isEqualTo(at(20));
    }

    @ParameterizedTest
    @ValueSource(doubles = {Double.NaN, Double.POSITIVE_INFINITY, Double.NEGATIVE_INFINITY, 1e300, -1e12})
    void whatIsNoTimeIsNow(double stamp) {
        assertThat(clock.taken(stamp, at(1))).isEqualTo(at(1));
    }

    @Test
    void inStepWithItsServerItIsExact() {
        for (int i = 0; i < 100; i++) {
            assertThat(clock.taken(0.1 * i, Instant.EPOCH.plusMillis(100L * i)))
                    .isEqualTo(Instant.EPOCH.plusMillis(100L * i));
        }
    }
}
