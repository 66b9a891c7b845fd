package rsal.ros2.device;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import java.time.Instant;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;

/// Messages of a robot whose clock is another one, 20 a second, each some milliseconds on its way.
class RobotClockTest {
    private static final long MILLISECOND = 1_000_000; // ns
    private static final Duration SOON = Duration.ofMillis(60);

    private final SplittableRandom random = new SplittableRandom(7);
    private Instant now = Instant.EPOCH;
    private final RobotClock clock = new RobotClock(() -> now, false);
    private long stamp = 1_700_000_000_000L * MILLISECOND; // of the robot, when it sends
    private Instant sent = now;

    /// @param pace of the robot's time
    /// @return the longest time by which a message was dated wrongly
    private Duration run(double seconds, double pace) {
        Duration worst = Duration.ZERO;
        for (int i = 0; i < seconds * 20; i++) {
            sent = sent.plusMillis(50);
            stamp += (long) (50 * MILLISECOND * pace);
            now = sent.plusMillis(2 + random.nextInt(30)); // on its way
            clock.learn(stamp);
            Duration error = Duration.between(clock.time(stamp), sent).abs();
            worst = worst.compareTo(error) > 0 ? worst : error;
        }
        return worst;
    }

    @Test
    void messagesAreDatedWhenTheyWereSent() {
        run(1, 1);
        assertThat(run(60, 1)).isLessThan(Duration.ofMillis(10));
        assertThat(Math.abs(clock.stamp() - stamp)).isLessThan(50 * MILLISECOND);
    }

    @Test
    void clocksThatDriftAreFollowed() {
        run(1, 1);
        assertThat(run(300, 1.0005)).isLessThan(Duration.ofMillis(20));
        assertThat(run(300, 0.9995)).isLessThan(Duration.ofMillis(20));
    }

    @Test
    void clocksThatAreSetAreFollowedAtOnce() {
        run(5, 1);
        stamp -= 3_600_000 * MILLISECOND;
        assertThat(run(5, 1)).isLessThan(SOON);
        stamp += 7_200_000 * MILLISECOND;
        assertThat(run(5, 1)).isLessThan(SOON);
    }

    @Test
    void aSimulatorThatWasPausedIsFollowedAtOnce() {
        run(5, 1);
        sent = sent.plusSeconds(7);
        assertThat(run(30, 1)).isLessThan(SOON);
    }

    /// As its pace is not known at first, its messages seem older by and by, then they are dated when they come.
    @Test
    void aSlowSimulatorIsNotedWithinAWindow() {
        run(11, 0.5);
        assertThat(run(30, 0.5)).isLessThan(SOON);
        assertThat(clock.stamp()).isEqualTo(stamp);
        assertThat(run(11, 1)).isLessThan(SOON);
        assertThat(run(30, 1)).isLessThan(SOON);
    }

    /// Of a simulator whose time the run follows; its `/clock` may come after a message with that stamp.
    @Test
    void messagesOfTheRunsOwnClockHaveItsTime() {
        var shared = new RobotClock(() -> now, true);
        now = Instant.ofEpochSecond(500);
        assertThat(shared.learn(499_000 * MILLISECOND)).isFalse();
        assertThat(shared.time(499_000 * MILLISECOND)).isEqualTo(Instant.ofEpochSecond(499));
        assertThat(shared.time(500_010 * MILLISECOND)).isEqualTo(now);
        assertThat(shared.time(0)).isEqualTo(now);
        assertThat(shared.stamp()).isEqualTo(500_000 * MILLISECOND);
        assertThat(shared.learn(497_000 * MILLISECOND)).isTrue(); // it was reset
    }

    @Test
    void whatHasNoStampWasMeasuredNow() {
        run(1, 1);
        assertThat(clock.time(0)).isEqualTo(now);
    }
}
