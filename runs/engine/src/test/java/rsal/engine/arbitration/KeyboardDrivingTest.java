package rsal.engine.arbitration;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import rsal.data.Twist2d;

class KeyboardDrivingTest {
    private static final long SECOND = 1_000_000_000L;
    private static final long START = -7 * SECOND; // nanoseconds may begin anywhere
    private static final long SILENCE = 4 * SECOND / 10; // the longest that it lets pass
    private static final long LEASE = KeyboardDriving.LEASE.toNanos();
    private static final Twist2d AHEAD = Twist2d.drive(0.4, 0);

    private final KeyboardDriving grip = new KeyboardDriving("page-1", START, true);

    @Test
    void holdsWhileItsDriverIsHeard() {
        for (long now = START; now < START + 20 * SECOND; now += SILENCE) {
            assertThat(grip.fadesAt(now)).isFalse();
            grip.want(AHEAD, now, true);
            assertThat(grip.wanted()).isEqualTo(AHEAD);
            assertThat(grip.isOverAt(now)).isFalse();
        }
    }

    @Test
    void stopsWithinHalfASecondWhenItsDriverFallsSilent() {
        grip.want(AHEAD, START, true);
        assertThat(grip.fadesAt(START + SILENCE)).isFalse();
        assertThat(grip.fadesAt(START + SILENCE + 1)).isTrue();
        assertThat(grip.wanted()).isEqualTo(Twist2d.STOP);
        assertThat(grip.fadesAt(START + SILENCE + 2)).as("told once").isFalse();
        assertThat(grip.isOverAt(START + LEASE)).isFalse();
        assertThat(grip.isOverAt(START + LEASE + 1)).isTrue();
    }

    @Test
    void aCommandThatComesLateIsAsOldAsItIs() {
        grip.want(AHEAD, START + SECOND, true);
        grip.want(AHEAD, START, true);
        assertThat(grip.fadesAt(START + SECOND + SILENCE)).isFalse();
        assertThat(grip.fadesAt(START + SECOND + SILENCE + 1)).isTrue();
    }

    @Test
    void afterAnEmergencyStopAllKeysMustHaveBeenReleased() {
        grip.want(AHEAD, START, true);
        grip.halt();
        assertThat(grip.wanted()).isEqualTo(Twist2d.STOP);
        grip.want(AHEAD, START, false);
        grip.want(Twist2d.STOP, START, false); // released, but still off
        grip.want(AHEAD, START, true);
        assertThat(grip.wanted()).isEqualTo(Twist2d.STOP);
        grip.want(Twist2d.STOP, START, true);
        grip.want(AHEAD, START, true);
        assertThat(grip.wanted()).isEqualTo(AHEAD);
    }

    @Test
    void whoBeginsWhileTheMotorsAreOffMustReleaseAllKeysToo() {
        var begun = new KeyboardDriving("page-1", START, false);
        begun.want(AHEAD, START, true);
        assertThat(begun.wanted()).isEqualTo(Twist2d.STOP);
    }
}
