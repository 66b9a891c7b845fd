package rsal.ros2.bridge;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import rsal.ros2.MemoryNetwork;
import rsal.ros2.cdr.CdrReader;
import rsal.ros2.cdr.InvalidCdr;
import rsal.ros2.link.ClockTopics;
import rsal.ros2.link.Profile;
import rsal.ros2.link.RosLink;
import rsal.ros2.link.RosPublisher.Publication;
import rsal.ros2.message.RosMessages;
import rsal.system.Bridge.Pace;

/// Programs that follow a run's time, whose real time the test is.
class ClockFollowersTest {
    private static final long MILLISECOND = 1_000_000;

    private final MemoryNetwork network = new MemoryNetwork();
    private final RosMessages messages = new RosMessages();
    private final RosLink first = network.join();
    private final RosLink second = network.join();
    private final List<Long> heard = new ArrayList<>();
    private long real = 5_000 * MILLISECOND;
    private int arrivals;
    private ClockFollowers followers = followers(true);

    private ClockFollowers followers(boolean isPaced) {
        return new ClockFollowers(network.join(), isPaced, () -> real, () -> arrivals++);
    }

    private void publish(long milliseconds) {
        followers.publish(milliseconds * MILLISECOND, clock(milliseconds));
    }

    private byte[] clock(long milliseconds) {
        return messages.clock(Instant.ofEpochMilli(milliseconds));
    }

    private static Publication follows(RosLink program) {
        return program.advertise(ClockTopics.REACHED, Profile.DEFAULT);
    }

    private void hear(RosLink program, Profile profile) {
        program.subscribe(ClockTopics.CLOCK, profile, bytes -> {
            try {
                heard.add(RosMessages.stamp(CdrReader.of(bytes)) / MILLISECOND);
            } catch (InvalidCdr e) {
                throw new AssertionError(e);
            }
        });
    }

    private void pass(long milliseconds) {
        real += milliseconds * MILLISECOND;
    }

    @Test
    void theRunWaitsForTheSlowestOfThoseThatSayWhatTheyHaveReached() {
        Publication one = follows(first);
        Publication other = follows(second);
        publish(10);
        assertThat(followers.pace()).as("they have not begun").isEqualTo(Pace.UNFOLLOWED);
        one.publish(clock(10));
        assertThat(followers.pace()).isEqualTo(Pace.FOLLOWED);
        other.publish(clock(10));
        publish(20);
        one.publish(clock(20));
        assertThat(followers.pace()).isEqualTo(Pace.AWAITED);
        assertThat(arrivals).as("nobody waited when they came").isZero();
        other.publish(clock(15));
        assertThat(followers.pace()).isEqualTo(Pace.AWAITED);
        other.publish(clock(20));
        assertThat(arrivals).isEqualTo(2);
        assertThat(followers.pace()).isEqualTo(Pace.FOLLOWED);
        other.publish(new byte[] {0, 1, 0, 0, 9}); // malformed
        assertThat(followers.pace()).isEqualTo(Pace.FOLLOWED);
    }

    @Test
    void whoLeavesIsNotWaitedFor() {
        Publication one = follows(first);
        publish(10);
        one.publish(clock(10));
        publish(20);
        assertThat(followers.pace()).isEqualTo(Pace.AWAITED);
        one.close();
        pass(250);
        assertThat(followers.pace()).isEqualTo(Pace.UNFOLLOWED);
    }

    @Test
    void whoStaysBehindForTooLongIsWaitedForAgainWhenItHasCaughtUp() {
        Publication one = follows(first);
        Publication other = follows(second);
        publish(10);
        one.publish(clock(10));
        other.publish(clock(10));
        publish(20);
        one.publish(clock(20));
        pass(ClockFollowers.PATIENCE.toMillis() - 1);
        assertThat(followers.pace()).isEqualTo(Pace.AWAITED);
        pass(1);
        assertThat(followers.pace()).isEqualTo(Pace.FOLLOWED);
        publish(30);
        one.publish(clock(30));
        assertThat(followers.pace()).isEqualTo(Pace.FOLLOWED);
        other.publish(clock(30));
        assertThat(followers.pace()).isEqualTo(Pace.FOLLOWED);
        publish(40);
        one.publish(clock(40));
        assertThat(followers.pace()).isEqualTo(Pace.AWAITED);
    }

    @Test
    void anAloneOneThatStaysBehindIsNoFollower() {
        Publication one = follows(first);
        publish(10);
        one.publish(clock(10));
        publish(20);
        pass(ClockFollowers.PATIENCE.toMillis());
        assertThat(followers.pace()).isEqualTo(Pace.UNFOLLOWED);
    }

    /// So that a message that was lost stops nobody.
    @Test
    void theNewestTimeIsRepeatedWhileTheRunWaits() {
        hear(first, Profile.SENSOR_DATA);
        Publication one = follows(first);
        publish(10);
        one.publish(clock(10));
        publish(20);
        for (int i = 0; i < 12; i++) {
            assertThat(followers.pace()).isEqualTo(Pace.AWAITED);
            pass(10);
        }
        assertThat(heard).containsExactly(10L, 20L, 20L, 20L);
    }

    /// They get each time once: only the newest ten are kept for them.
    @Test
    void nothingIsRepeatedForThoseThatAcknowledge() {
        hear(second, Profile.DEFAULT);
        network.delay(second, ClockFollowers.WINDOW + 1);
        publish(10);
        assertThat(followers.pace()).isEqualTo(Pace.AWAITED);
        pass(200);
        assertThat(followers.pace()).isEqualTo(Pace.AWAITED);
        assertThat(heard).containsExactly(10L);
        Publication one = follows(first);
        one.publish(clock(5));
        pass(200);
        assertThat(followers.pace()).isEqualTo(Pace.AWAITED);
        assertThat(heard).as("it would lose the first").containsExactly(10L);
        network.delay(second, ClockFollowers.WINDOW - 1);
        assertThat(followers.pace()).isEqualTo(Pace.AWAITED);
        assertThat(heard).containsExactly(10L, 10L);
    }

    @Test
    void manyArrivalsWakeTheRunOnce() {
        Publication one = follows(first);
        publish(10);
        one.publish(clock(5));
        assertThat(followers.pace()).isEqualTo(Pace.AWAITED);
        for (int i = 0; i < 1_000; i++) {
            one.publish(clock(6));
        }
        assertThat(arrivals).isEqualTo(1);
        assertThat(followers.pace()).isEqualTo(Pace.AWAITED);
        one.publish(clock(10));
        assertThat(arrivals).isEqualTo(2);
    }

    @Test
    void reliableSubscribersMayLackWhatIsKeptForThem() {
        hear(first, Profile.SENSOR_DATA);
        network.delay(first, 1_000);
        publish(10);
        assertThat(followers.pace()).as("best effort").isEqualTo(Pace.UNFOLLOWED);
        hear(second, Profile.DEFAULT);
        network.delay(second, ClockFollowers.WINDOW);
        assertThat(followers.pace()).isEqualTo(Pace.FOLLOWED);
        network.delay(second, ClockFollowers.WINDOW + 1);
        assertThat(followers.pace()).isEqualTo(Pace.AWAITED);
        pass(ClockFollowers.PATIENCE.toMillis());
        assertThat(followers.pace()).isEqualTo(Pace.UNFOLLOWED);
        network.delay(second, 0);
        assertThat(followers.pace()).isEqualTo(Pace.FOLLOWED);
    }

    @Test
    void nobodyHoldsARunBackThatIsNotPaced() {
        followers.close();
        followers = followers(false);
        Publication one = follows(first);
        publish(10);
        one.publish(clock(10));
        publish(20);
        assertThat(followers.pace()).isEqualTo(Pace.FREE);
    }
}
