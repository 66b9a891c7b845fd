package rsal.engine.communication;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import rsal.agent.Message;
import rsal.agent.message.Text;
import rsal.device.Subscription;
import rsal.scenario.fault.PlannedFault.Mishap;
import rsal.scenario.fault.PlannedFault.OfMessages;
import rsal.scenario.fault.Span;

class ChannelFaultsTest {
    private static final int MANY = 20_000;

    private final List<String> lost = new ArrayList<>();
    private final ChannelFaults channelFaults =
            new ChannelFaults((message, listener) -> lost.add(message.sender() + " to " + listener));

    private static Message<Text> from(String sender) {
        return new Message<>(Text.TOPIC, sender, "", Instant.EPOCH, new Text("hi"));
    }

    private static OfMessages all(double share, Mishap mishap) {
        return new OfMessages(List.of(), Optional.empty(), Optional.empty(), share, mishap);
    }

    private List<Duration> copies() {
        return channelFaults.copies(from("bob"), "amy");
    }

    private Subscription begin(OfMessages messages) {
        return channelFaults.begin(messages, new SplittableRandom(5));
    }

    @Test
    void withoutMishapsAllComesAtOnce() {
        assertThat(copies()).containsExactly(Duration.ZERO);
    }

    @Test
    void asManyAreLostAsWereAskedFor() {
        begin(all(0.2, new Mishap.Lost()));
        int heard = 0;
        for (int i = 0; i < MANY; i++) {
            heard += copies().size();
        }
        double deviation = Math.sqrt(MANY * 0.2 * 0.8);
        assertThat((double) heard).isCloseTo(0.8 * MANY, within(4 * deviation));
        assertThat(lost).hasSize(MANY - heard).contains("bob to amy");
    }

    @Test
    void whatIsLostIsLostAtRandomNotInTurn() {
        begin(all(0.5, new Mishap.Lost()));
        int changes = 0;
        boolean before = false;
        for (int i = 0; i < MANY; i++) {
            boolean heard = !copies().isEmpty();
            changes += heard == before ? 0 : 1;
            before = heard;
        }
        assertThat((double) changes).isCloseTo(MANY / 2.0, within(4 * Math.sqrt(MANY / 4.0)));
    }

    @Test
    void whatIsLateComesWithinItsTimes() {
        begin(all(1, new Mishap.Late(Span.of(0.5, 1.5))));
        double sum = 0;
        for (int i = 0; i < MANY; i++) {
            assertThat(copies()).hasSize(1);
            double late = copies().getFirst().toNanos() / 1e9;
            assertThat(late).isBetween(0.5, 1.5);
            sum += late;
        }
        assertThat(sum / MANY).isCloseTo(1, within(4 / Math.sqrt(12.0 * MANY)));
    }

    @Test
    void whatIsDoubledComesTwiceAndWhatIsLateThenToo() {
        begin(all(1, new Mishap.Doubled(Span.of(2, 2))));
        assertThat(copies()).containsExactly(Duration.ZERO, Duration.ofSeconds(2));
        begin(all(1, new Mishap.Late(Span.of(1, 1))));
        assertThat(copies()).containsExactly(Duration.ofSeconds(1), Duration.ofSeconds(3));
    }

    @Test
    void onlySomeMessagesAreConcerned() {
        begin(new OfMessages(
                List.of("te*"), Optional.of(Set.of("bob")), Optional.of(Set.of("amy")), 1, new Mishap.Lost()));
        begin(new OfMessages(List.of("pose"), Optional.empty(), Optional.empty(), 1, new Mishap.Lost()));
        assertThat(channelFaults.copies(from("bob"), "amy")).isEmpty();
        assertThat(channelFaults.copies(from("bob"), "zoe")).hasSize(1);
        assertThat(channelFaults.copies(from("joe"), "amy")).hasSize(1);
    }

    @Test
    void whenItIsOverAllIsHeardAgain() {
        var one = begin(all(1, new Mishap.Lost()));
        var other = begin(all(1, new Mishap.Lost()));
        one.cancel();
        assertThat(copies()).isEmpty();
        other.cancel();
        assertThat(copies()).hasSize(1);
    }

    @Test
    void theSilentAreSoUntilItIsOver() {
        var silence = channelFaults.silence(Set.of("bob"));
        assertThat(channelFaults.isSilent("bob")).isTrue();
        assertThat(channelFaults.isSilent("amy")).isFalse();
        silence.cancel();
        assertThat(channelFaults.isSilent("bob")).isFalse();
    }

    @Test
    void doubledAgainAndAgainThereAreOnlySoMany() {
        for (int i = 0; i < 40; i++) {
            begin(all(1, new Mishap.Doubled(Span.of(1, 1))));
            assertThat(copies()).hasSize(Math.min(64, 2 << Math.min(i, 10)));
        }
    }

    @Test
    void whatIsOnItsWayDoesNotReachTheSilent() {
        Message<Text> message = from("bob");
        assertThat(channelFaults.reaches(message, "amy")).isTrue();
        channelFaults.silence(Set.of("amy"));
        assertThat(channelFaults.reaches(message, "amy")).isFalse();
        assertThat(channelFaults.reaches(message, "zoe")).isTrue();
    }

    @Test
    void blocksWhatIsLostForSureWhateverItIsAbout() {
        assertThat(channelFaults.blocks("bob", "amy")).isFalse();
        Subscription all = begin(all(1, new Mishap.Lost()));
        assertThat(channelFaults.blocks("bob", "amy")).isTrue();
        all.cancel();
        begin(all(0.99, new Mishap.Lost()));
        begin(all(1, new Mishap.Late(Span.of(1, 1))));
        begin(new OfMessages(List.of("pose"), Optional.empty(), Optional.empty(), 1, new Mishap.Lost()));
        assertThat(channelFaults.blocks("bob", "amy")).isFalse();
        begin(new OfMessages(List.of(), Optional.of(Set.of("bob")), Optional.of(Set.of("amy")), 1, new Mishap.Lost()));
        assertThat(channelFaults.blocks("bob", "amy")).isTrue();
        assertThat(channelFaults.blocks("amy", "bob")).isFalse();
        assertThat(channelFaults.blocks("bob", "zoe")).isFalse();
    }

    @Test
    void theSilentAreBlockedBothWays() {
        channelFaults.silence(Set.of("zoe"));
        assertThat(channelFaults.blocks("zoe", "amy")).isTrue();
        assertThat(channelFaults.blocks("amy", "zoe")).isTrue();
        assertThat(channelFaults.blocks("amy", "bob")).isFalse();
    }
}
