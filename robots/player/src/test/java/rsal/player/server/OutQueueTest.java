package rsal.player.server;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicLong;
import java.util.concurrent.atomic.AtomicReference;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import rsal.player.message.Interface;
import rsal.player.message.MapInterface;
import rsal.player.message.Session;
import rsal.player.wire.Address;
import rsal.player.wire.MessageKind;
import rsal.player.wire.Packet;

@Timeout(30)
class OutQueueTest {
    private static final Packet ANSWER = Packet.of(Address.of(1, 0), MessageKind.ACK, Session.DEVICES, 0);

    private final AtomicLong now = new AtomicLong(); // [ns]
    private final OutQueue queue = new OutQueue(() -> 0, now::get);

    private static Packet data(Interface of, double time) {
        return Packet.of(Address.of(of.code(), 0), MessageKind.DATA, 1, time);
    }

    private static List<Packet> measured(double time) {
        return Stream.of(Interface.POSITION2D, Interface.LASER, Interface.SONAR)
                .map(each -> data(each, time))
                .toList();
    }

    private List<Packet> sent() throws InterruptedException {
        var sent = new ArrayList<Packet>();
        while (!queue.isIdle()) {
            sent.add(queue.take().orElseThrow());
        }
        return sent;
    }

    @Test
    void whoPullsIsBehindWhileThereIsDataThatItHasNotAskedFor() {
        queue.data(measured(1));
        assertThat(queue.isBehind()).as("it is pushed to").isFalse();
        queue.mode(true);
        queue.data(measured(1));
        assertThat(queue.isBehind()).as("it has not begun").isFalse();
        queue.round(ANSWER);
        assertThat(queue.isBehind()).as("it gets all there is").isFalse();
        queue.data(measured(1));
        assertThat(queue.isBehind()).isTrue();
        queue.round(ANSWER);
        queue.round(ANSWER);
        queue.data(measured(1));
        assertThat(queue.isBehind()).as("it waits for more itself").isFalse();
        queue.data(measured(1));
        now.addAndGet(999_999_999);
        assertThat(queue.isBehind()).isTrue();
        now.incrementAndGet();
        assertThat(queue.isBehind()).as("it has asked for nothing for a second").isFalse();
        now.decrementAndGet();
        queue.close();
        assertThat(queue.isBehind()).isFalse();
    }

    @Test
    void aRoundThatWaitedHasAllThatCameAtTheSameTime() throws Exception {
        queue.mode(true);
        queue.round(ANSWER);
        assertThat(sent()).containsExactly(ANSWER);
        queue.data(List.of());
        assertThat(sent()).as("none of it wanted").isEmpty();
        queue.data(measured(1));
        queue.data(measured(2));
        List<Packet> round = sent();
        assertThat(round.subList(0, 3)).isEqualTo(measured(1));
        assertThat(round.subList(3, round.size()))
                .extracting(packet -> packet.header().kind())
                .containsExactly(MessageKind.SYNCH);
        queue.round(ANSWER);
        assertThat(sent()).startsWith(ANSWER).containsAll(measured(2)).hasSize(5);
    }

    @Test
    void aRoundThatHasBegunIsNotTornByWhatIsNewer() throws Exception {
        queue.mode(true);
        queue.add(new Session.ReplaceRule(
                Session.ANY, Session.ANY, MessageKind.DATA.code(), Session.ANY, Session.REPLACE));
        queue.data(measured(1));
        queue.data(measured(2));
        queue.round(ANSWER);
        assertThat(queue.take()).contains(ANSWER);
        assertThat(queue.take()).contains(measured(2).getFirst());
        queue.data(measured(3));
        assertThat(sent()).startsWith(measured(2).get(1), measured(2).get(2)).hasSize(3);
        queue.round(ANSWER);
        assertThat(sent()).startsWith(ANSWER).containsAll(measured(3)).hasSize(5);
    }

    /// A rule holds for what is as it says in all that it names; what differs in one of these is queued.
    @ParameterizedTest
    @CsvSource({
        "4, 2, 1, 7, true",
        "4, 2, 1, -1, true",
        "4, 2, -1, 7, true",
        "4, -1, 1, 7, true",
        "-1, 2, 1, 7, true",
        "5, 2, 1, 7, false",
        "4, 3, 1, 7, false",
        "4, 2, 4, 7, false",
        "4, 2, 1, 8, false"
    })
    void aRuleHoldsForWhatIsAsItSays(int interf, int index, int type, int subtype, boolean holds) throws Exception {
        queue.add(new Session.ReplaceRule(interf, index, type, subtype, Session.REPLACE));
        Packet first = Packet.of(Address.of(4, 2), MessageKind.DATA, 7, 1);
        Packet second = Packet.of(Address.of(4, 2), MessageKind.DATA, 7, 2);
        queue.data(List.of(first));
        queue.data(List.of(second));
        assertThat(sent()).isEqualTo(holds ? List.of(second) : List.of(first, second));
    }

    /// What is replaced is like the new one in device, kind and subtype.
    @Test
    void onlyWhatIsLikeItIsReplaced() throws Exception {
        queue.add(new Session.ReplaceRule(Session.ANY, Session.ANY, Session.ANY, Session.ANY, Session.REPLACE));
        List<Packet> others = List.of(
                Packet.of(Address.of(5, 2), MessageKind.DATA, 7, 1),
                Packet.of(Address.of(4, 3), MessageKind.DATA, 7, 1),
                Packet.of(Address.of(4, 2), MessageKind.COMMAND, 7, 1),
                Packet.of(Address.of(4, 2), MessageKind.DATA, 8, 1));
        queue.data(others);
        queue.data(List.of(Packet.of(Address.of(4, 2), MessageKind.DATA, 7, 1)));
        Packet newest = Packet.of(Address.of(4, 2), MessageKind.DATA, 7, 2);
        queue.data(List.of(newest));
        assertThat(sent())
                .isEqualTo(Stream.concat(others.stream(), Stream.of(newest)).toList());
    }

    @Test
    void theFirstRuleThatHoldsCounts() throws Exception {
        queue.add(new Session.ReplaceRule(4, 2, Session.ANY, Session.ANY, Session.IGNORE));
        queue.add(new Session.ReplaceRule(Session.ANY, Session.ANY, Session.ANY, Session.ANY, Session.REPLACE));
        Packet other = Packet.of(Address.of(5, 2), MessageKind.DATA, 7, 1);
        queue.data(List.of(Packet.of(Address.of(4, 2), MessageKind.DATA, 7, 1), other));
        assertThat(sent()).containsExactly(other);
    }

    private static CompletableFuture<Boolean> waiting(Waiting what) {
        var done = new CompletableFuture<Boolean>();
        Thread.ofVirtual().start(() -> {
            try {
                done.complete(what.isOver());
            } catch (InterruptedException e) {
                done.completeExceptionally(e);
            }
        });
        return done;
    }

    private interface Waiting {
        boolean isOver() throws InterruptedException;
    }

    private CompletableFuture<Boolean> someoneWhoHasToWait() {
        CompletableFuture<Boolean> asking = waiting(() -> {
            queue.awaitRoom();
            return true;
        });
        assertWaits(asking);
        return asking;
    }

    private static void assertWaits(CompletableFuture<Boolean> waiting) {
        assertThat(waiting.copy()
                        .completeOnTimeout(false, 200, TimeUnit.MILLISECONDS)
                        .join())
                .isFalse();
    }

    @Test
    void whoAsksTooMuchWaitsUntilAnAnswerIsTaken() throws Exception {
        for (int i = 0; i < 256; i++) {
            queue.awaitRoom();
            queue.answer(ANSWER);
        }
        CompletableFuture<Boolean> asking = someoneWhoHasToWait();
        assertThat(queue.take()).contains(ANSWER);
        assertThat(asking.join()).isTrue();
    }

    @Test
    void whoAsksForTooLargeAnswersWaits() throws Exception {
        var tile = new MapInterface.Tile(0, 0, 1, 1, 1, 1, new byte[1 << 20]);
        Packet large = Packet.of(Address.of(Interface.MAP.code(), 0), MessageKind.ACK, MapInterface.TILE, 0, tile);
        for (int i = 0; i < 4; i++) {
            queue.awaitRoom();
            queue.answer(large);
        }
        CompletableFuture<Boolean> asking = someoneWhoHasToWait();
        queue.take();
        assertThat(asking.join()).isTrue();
    }

    @Test
    void nobodyWaitsForAClientThatIsGone() {
        for (int i = 0; i < 256; i++) {
            queue.answer(ANSWER);
        }
        CompletableFuture<Boolean> asking = waiting(() -> {
            queue.awaitRoom();
            return true;
        });
        var empty = new OutQueue(() -> 0, now::get);
        CompletableFuture<Boolean> sending = waiting(() -> empty.take().isEmpty());
        queue.close();
        empty.close();
        assertThat(asking.join()).isTrue();
        assertThat(sending.join()).isTrue();
    }

    @ParameterizedTest
    @ValueSource(strings = {"data", "answer", "round", "push"})
    void whoeverSendsIsWokenByWhatThereIsToSend(String what) throws Exception {
        Packet packet = data(Interface.LASER, 1);
        if (what.equals("push")) {
            queue.mode(true);
            queue.data(List.of(packet));
        }
        var taken = new AtomicReference<Packet>();
        CompletableFuture<Boolean> sending = waiting(() -> {
            queue.take().ifPresent(taken::set);
            return true;
        });
        assertWaits(sending);
        switch (what) {
            case "data" -> queue.data(List.of(packet));
            case "answer" -> queue.answer(ANSWER);
            case "round" -> queue.round(ANSWER);
            default -> queue.mode(false);
        }
        assertThat(sending.join()).isTrue();
        assertThat(taken).hasValue(what.equals("answer") || what.equals("round") ? ANSWER : packet);
    }

    @Test
    void aClientHas256RulesAtMost() {
        var rule = new Session.ReplaceRule(4, 2, Session.ANY, Session.ANY, Session.IGNORE);
        for (int i = 0; i < 256; i++) {
            assertThat(queue.add(rule)).isTrue();
        }
        assertThat(queue.add(rule)).isFalse();
    }

    @Test
    void anAnswerGoesAtOnceToWhoPullsWithAllThatCameBefore() throws Exception {
        queue.mode(true);
        queue.data(measured(1));
        assertThat(queue.isIdle()).as("it has to ask for data").isTrue();
        queue.answer(ANSWER);
        queue.data(measured(2));
        var all = new ArrayList<>(measured(1));
        all.add(ANSWER);
        assertThat(sent()).isEqualTo(all);
    }

    @Test
    void whoIsPushedToGetsAllInTheOrderInWhichItCame() throws Exception {
        queue.data(measured(1));
        queue.answer(ANSWER);
        queue.data(measured(2));
        var all = new ArrayList<>(measured(1));
        all.add(ANSWER);
        all.addAll(measured(2));
        assertThat(queue.isIdle()).isFalse();
        assertThat(sent()).isEqualTo(all);
    }

    @Test
    void whatIsMoreThan1024MessagesIsLostAndTheNextSynchCountsIt() throws Exception {
        var at = new OutQueue(() -> 7.5, now::get);
        at.mode(true);
        for (int i = 0; i < OutQueue.MOST + 3; i++) {
            at.data(List.of(data(Interface.LASER, i)));
        }
        at.round(ANSWER);
        assertThat(at.take()).contains(ANSWER);
        for (int i = 0; i < OutQueue.MOST; i++) {
            assertThat(at.take()).contains(data(Interface.LASER, i));
        }
        Packet synch = at.take().orElseThrow();
        assertThat(synch.header().kind()).isEqualTo(MessageKind.SYNCH);
        assertThat(synch.header().subtype()).isEqualTo(Session.OVERFLOW);
        assertThat(synch.header().time()).isEqualTo(7.5);
        assertThat(synch.body(Session.Lost.class).messages()).isEqualTo(3);
        at.data(measured(1));
        at.round(ANSWER);
        Packet next = null;
        while (!at.isIdle()) {
            next = at.take().orElseThrow();
        }
        assertThat(next).isNotNull();
        assertThat(next.header().subtype()).as("nothing was lost since").isEqualTo(Session.COMPLETE);
    }

    @Test
    void messagesThatGoAlreadyCountAmongTheMost() throws Exception {
        queue.mode(true);
        for (int i = 0; i < OutQueue.MOST; i++) {
            queue.data(List.of(data(Interface.LASER, i)));
        }
        queue.answer(ANSWER); // all of it goes
        queue.data(List.of(data(Interface.LASER, -1))); // and this is too much
        assertThat(sent()).hasSize(OutQueue.MOST + 1).doesNotContain(data(Interface.LASER, -1));
        queue.data(measured(1));
        queue.round(ANSWER);
        assertThat(sent()).contains(measured(1).toArray(Packet[]::new));
    }

    @Test
    void aRoundWithoutDataWaitsAlsoWhereThereAreOtherMessages() throws Exception {
        queue.mode(true);
        Packet command = Packet.of(Address.of(4, 2), MessageKind.COMMAND, 7, 1);
        queue.data(List.of(command));
        queue.round(ANSWER);
        assertThat(sent()).as("no synch").containsExactly(ANSWER, command);
        queue.mode(false);
        queue.data(measured(1));
        assertThat(sent()).as("pushed: no round is wanted any more").isEqualTo(measured(1));
    }

    @Test
    void aRefusalIsAnAnswerAndDataIsNone() throws Exception {
        Packet refusal = Packet.of(Address.of(1, 0), MessageKind.NACK, Session.DEVICES, 0);
        for (int i = 0; i < 256; i++) {
            queue.awaitRoom();
            queue.answer(refusal);
        }
        CompletableFuture<Boolean> asking = someoneWhoHasToWait();
        assertThat(queue.take()).contains(refusal);
        assertThat(asking.join()).isTrue();
        queue.answer(refusal);
        queue.data(measured(1));
        while (queue.take().orElseThrow().header().kind() != MessageKind.DATA) {
            // the answers before it
        }
        for (int i = 0; i < 255; i++) {
            queue.answer(refusal);
        }
        queue.awaitRoom();
        queue.answer(refusal);
        someoneWhoHasToWait().cancel(true);
        queue.close();
    }
}
