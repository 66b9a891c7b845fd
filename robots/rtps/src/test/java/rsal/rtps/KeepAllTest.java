package rsal.rtps;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.ByteBuffer;
import java.time.Duration;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Collections;
import java.util.Deque;
import java.util.List;
import java.util.Optional;
import java.util.SplittableRandom;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import rsal.rtps.SimulatedNetwork.Node;
import rsal.rtps.discovery.Qos;
import rsal.rtps.wire.EntityId;
import rsal.rtps.wire.Guid;
import rsal.rtps.wire.GuidPrefix;
import rsal.rtps.wire.NumberSet;
import rsal.rtps.wire.Submessage.AckNack;
import rsal.rtps.wire.Submessage.Content;
import rsal.testkit.Rounds;

/// Writers that keep all until their readers have it, and readers that refuse what they have no room for.
class KeepAllTest {
    private static final String TYPE = "std_msgs::msg::dds_::String_";
    private static final Duration SOON = Duration.ofMillis(300);
    private static final Duration LEASE = Duration.ofSeconds(10);
    private static final Qos ALL = Qos.DEFAULT.keep(Qos.KEEP_ALL);
    private static final int ROOM = 8; // samples that a writer keeps
    private static final int ROOM_BYTES = 100_000;
    private static final RtpsLimits SMALL = RtpsLimits.DEFAULT.keeping(ROOM, ROOM_BYTES);
    private static final int COUNT = 200;

    /// Has room for some samples, until somebody takes them.
    private static final class Store implements SampleListener {
        private final int capacity;
        private final Deque<Integer> waiting = new ArrayDeque<>();
        private final List<Integer> taken = new ArrayList<>();

        Store(int capacity) {
            this.capacity = capacity;
        }

        @Override
        public void onSample(Sample sample) {
            assertThat(waiting).hasSizeLessThan(capacity);
            waiting.add(sample.payload().getInt(sample.payload().position()));
        }

        @Override
        public boolean hasRoom() {
            return waiting.size() < capacity;
        }

        /// Takes the first one, if there is one.
        void take(Node node, SampleReader reader, long now) {
            boolean wasFull = !hasRoom();
            if (!waiting.isEmpty()) {
                taken.add(waiting.removeFirst());
            }
            if (wasFull) {
                node.participant.resume(reader, now);
            }
        }
    }

    private static byte[] sample(int number, int size) {
        return ByteBuffer.allocate(size).putInt(0, number).array();
    }

    private static SampleWriter writer(Node node, SimulatedNetwork network, Qos qos) {
        return node.participant.createWriter("rt/chatter", TYPE, qos, "", network.now());
    }

    private static SampleReader reader(Node node, SimulatedNetwork network, SampleListener listener) {
        return node.participant.createReader("rt/chatter", TYPE, ALL, "", listener, network.now());
    }

    private static Node join(SimulatedNetwork network, Duration lease) {
        return network.join(SMALL, GraphListener.NONE, lease);
    }

    private static void waitFor(SampleWriter writer, SampleReader reader, SimulatedNetwork network) {
        for (int i = 0; i < 600 && (writer.matched() == 0 || reader.matched() == 0); i++) {
            network.run(Duration.ofMillis(100));
        }
        assertThat(writer.matched()).isEqualTo(1);
        assertThat(reader.matched()).isEqualTo(1);
    }

    private static List<Integer> numbers(int count) {
        return IntStream.range(0, count).boxed().toList();
    }

    /// Written as fast as there is room, to a reader that takes a sample every 5 ms. Some are in fragments.
    @ParameterizedTest
    @ValueSource(doubles = {0, 0.1, 0.3, 0.5})
    void everythingArrivesOnceAndInOrderThoughAllIsSmall(double loss) {
        for (int seed = 0; seed < Rounds.of(3, 100); seed++) {
            var network = new SimulatedNetwork(seed, loss).doubling();
            var random = new SplittableRandom(seed);
            Node talker = join(network, Duration.ofMinutes(5)); // for many announcements can get lost
            Node listener = join(network, Duration.ofMinutes(5));
            var store = new Store(5);
            SampleReader reader = reader(listener, network, store);
            SampleWriter writer = writer(talker, network, ALL);
            waitFor(writer, reader, network);
            int written = 0;
            for (int i = 0; i < 400_000 && store.taken.size() < COUNT; i++) {
                int size = random.nextInt(10) == 0 ? 5_000 : 100;
                while (written < COUNT && talker.write(writer, sample(written, size))) {
                    written++;
                }
                assertThat(written - store.taken.size()).isLessThanOrEqualTo(ROOM + 5);
                network.run(Duration.ofMillis(1));
                if (i % 5 == 0) {
                    store.take(listener, reader, network.now());
                }
            }
            assertThat(store.taken).as("seed %d", seed).isEqualTo(numbers(COUNT));
            network.run(Duration.ofSeconds(20));
            assertThat(writer.isAcknowledged()).isTrue();
        }
    }

    @Test
    void aWriterIsFullOfSamplesThatAReaderLacksAndSaysWhenItHasRoom() {
        var network = new SimulatedNetwork(1, 0);
        Node talker = join(network, LEASE);
        Node listener = join(network, LEASE);
        var store = new Store(2);
        SampleReader reader = reader(listener, network, store);
        SampleWriter writer = writer(talker, network, ALL);
        var reported = new ArrayList<Long>();
        writer.onRoom(() -> reported.add(network.now()));
        waitFor(writer, reader, network);
        int written = 0;
        for (int i = 0; i < 100; i++) {
            written += talker.write(writer, sample(written, 100)) ? 1 : 0;
            network.run(Duration.ofMillis(10));
        }
        assertThat(written).isEqualTo(ROOM + 2);
        assertThat(reported).isEmpty();
        assertThat(writer.isAcknowledged()).isFalse();
        store.take(listener, reader, network.now());
        network.run(Duration.ofMillis(30));
        assertThat(reported).hasSize(1);
        assertThat(talker.write(writer, sample(written, 100))).isTrue();
        assertThat(talker.write(writer, sample(written, 100))).isFalse();
    }

    @Test
    void bytesAreBoundedTooButNotTheOnlySample() {
        var network = new SimulatedNetwork(2, 0);
        Node talker = join(network, LEASE);
        Node listener = join(network, LEASE);
        var store = new Store(1);
        SampleReader reader = reader(listener, network, store);
        SampleWriter writer = writer(talker, network, ALL);
        waitFor(writer, reader, network);
        assertThat(talker.write(writer, sample(0, 100))).isTrue();
        network.run(SOON);
        assertThat(talker.write(writer, sample(1, 2 * ROOM_BYTES))).isTrue(); // the store is full, the writer was empty
        assertThat(talker.write(writer, sample(2, 100))).isFalse();
        network.run(SOON);
        store.take(listener, reader, network.now());
        network.run(SOON);
        assertThat(talker.write(writer, sample(2, ROOM_BYTES - 100))).isTrue();
        assertThat(talker.write(writer, sample(3, 200))).isFalse();
        for (int i = 0; i < 3; i++) {
            store.take(listener, reader, network.now());
            network.run(SOON);
        }
        assertThat(store.taken).isEqualTo(numbers(3));
    }

    /// Fills a writer whose reader takes nothing.
    private static int fill(Node talker, SampleWriter writer, SimulatedNetwork network) {
        int written = 0;
        while (talker.write(writer, sample(written, 100))) {
            written++;
            network.run(Duration.ofMillis(5));
        }
        return written;
    }

    @Test
    void aReaderThatDiesFreesTheWriter() {
        var network = new SimulatedNetwork(3, 0);
        Node talker = join(network, LEASE);
        Node listener = join(network, LEASE);
        SampleReader reader = reader(listener, network, new Store(3));
        SampleWriter writer = writer(talker, network, ALL);
        var reported = new ArrayList<Long>();
        writer.onRoom(() -> reported.add(network.now()));
        waitFor(writer, reader, network);
        assertThat(fill(talker, writer, network)).isEqualTo(ROOM + 3);
        listener.crash();
        network.run(Duration.ofMillis(6_900));
        assertThat(talker.write(writer, sample(0, 100))).isFalse();
        network.run(Duration.ofMillis(3_600)); // its lease has ended
        assertThat(reported).hasSize(1);
        for (int i = 0; i < 10 * ROOM; i++) {
            assertThat(talker.write(writer, sample(i, 100))).isTrue();
        }
    }

    @Test
    void aReaderThatIsRemovedFreesTheWriter() {
        var network = new SimulatedNetwork(4, 0);
        Node talker = join(network, LEASE);
        Node listener = join(network, LEASE);
        SampleReader reader = reader(listener, network, new Store(0));
        SampleWriter writer = writer(talker, network, ALL);
        waitFor(writer, reader, network);
        assertThat(fill(talker, writer, network)).isEqualTo(ROOM);
        listener.participant.remove(reader, network.now());
        network.run(SOON);
        assertThat(talker.write(writer, sample(0, 100))).isTrue();
    }

    /// The slowest one counts, and the others do not wait for what is written.
    @Test
    void allReadersGetAll() {
        var network = new SimulatedNetwork(5, 0.2);
        Node talker = join(network, LEASE);
        Node slow = join(network, LEASE);
        Node quick = join(network, LEASE);
        var store = new Store(3);
        var all = new Store(COUNT);
        SampleReader slowReader = reader(slow, network, store);
        reader(quick, network, all);
        SampleWriter writer = writer(talker, network, ALL);
        for (int i = 0; i < 100 && (writer.matched() < 2 || slowReader.matched() == 0); i++) {
            network.run(Duration.ofMillis(100));
        }
        int written = 0;
        for (int i = 0; i < 100_000 && store.taken.size() < COUNT; i++) {
            written += written < COUNT && talker.write(writer, sample(written, 100)) ? 1 : 0;
            network.run(Duration.ofMillis(1));
            if (i % 7 == 0) {
                store.take(slow, slowReader, network.now());
            }
        }
        assertThat(store.taken).isEqualTo(numbers(COUNT));
        assertThat(List.copyOf(all.waiting)).isEqualTo(numbers(COUNT));
    }

    @Test
    void neighborsOfTheParticipantRefuseToo() {
        var network = new SimulatedNetwork(6, 0);
        Node node = join(network, LEASE);
        var store = new Store(3);
        SampleReader reader = reader(node, network, store);
        SampleWriter writer = writer(node, network, ALL);
        var reported = new ArrayList<Long>();
        writer.onRoom(() -> reported.add(network.now()));
        assertThat(fill(node, writer, network)).isEqualTo(ROOM + 3);
        for (int i = 0; i < ROOM + 3; i++) {
            store.take(node, reader, network.now());
        }
        assertThat(store.taken).isEqualTo(numbers(ROOM + 3));
        assertThat(reported).hasSize(1);
    }

    /// A writer that keeps the last ones never waits: a reader that refuses loses what the writer keeps no
    /// longer, but nothing that has come.
    @Test
    void whatWasAcceptedOrIsKeptArrivesOfWritersThatKeepTheLast() {
        var network = new SimulatedNetwork(7, 0);
        Node talker = join(network, LEASE);
        Node listener = join(network, LEASE);
        var store = new Store(3);
        SampleReader reader = reader(listener, network, store);
        SampleWriter writer = writer(talker, network, Qos.DEFAULT);
        waitFor(writer, reader, network);
        for (int i = 0; i < 1_000; i++) {
            assertThat(talker.write(writer, sample(i, 100))).isTrue();
            network.run(Duration.ofMillis(1));
        }
        for (int i = 0; i < 1_000 && !store.taken.contains(999); i++) {
            store.take(listener, reader, network.now());
            network.run(Duration.ofMillis(20));
        }
        assertThat(store.taken)
                .isSorted()
                .doesNotHaveDuplicates()
                .startsWith(0, 1, 2, 3)
                .endsWith(998, 999);
        assertThat(store.taken).hasSizeBetween(3 + SMALL.early(), 3 + SMALL.early() + 10);
    }

    @Test
    void lateReadersGetTheNewestOfLatchedWritersThatThereIsRoomFor() {
        var network = new SimulatedNetwork(8, 0);
        Node talker = join(network, LEASE);
        SampleWriter writer = writer(talker, network, ALL.latched());
        for (int i = 0; i < 50; i++) {
            assertThat(talker.write(writer, sample(i, 100))).isTrue(); // nobody lacks them
        }
        Node listener = join(network, LEASE);
        var store = new Store(COUNT);
        listener.participant.createReader("rt/chatter", TYPE, ALL.latched(), "", store, network.now());
        network.run(Duration.ofSeconds(2));
        assertThat(List.copyOf(store.waiting))
                .isEqualTo(IntStream.range(50 - ROOM, 50).boxed().toList());
    }

    /// A reader that takes nothing for long costs little.
    @Test
    void refusingIsQuiet() {
        var network = new SimulatedNetwork(9, 0);
        Node talker = join(network, LEASE);
        Node listener = join(network, LEASE);
        SampleReader reader = reader(listener, network, new Store(0));
        SampleWriter writer = writer(talker, network, ALL);
        waitFor(writer, reader, network);
        fill(talker, writer, network);
        network.run(Duration.ofSeconds(2));
        long before = network.sent();
        network.run(Duration.ofSeconds(30));
        assertThat(network.sent() - before)
                .isLessThan(2 * 2 * 24 + 2 * 10 + 2 * 70); // announcements, two heartbeats a second
    }

    /// What is written at once to a reader that acknowledges nothing takes little memory: the newest arrive.
    @Test
    void whatReadersOfBestEffortHaveNotBeenSentIsBounded() {
        var network = new SimulatedNetwork(10, 0);
        Node talker = join(network, LEASE);
        Node listener = join(network, LEASE);
        var store = new Store(1_000);
        SampleReader reader =
                listener.participant.createReader("rt/chatter", TYPE, Qos.SENSOR_DATA, "", store, network.now());
        SampleWriter writer = writer(talker, network, ALL);
        waitFor(writer, reader, network);
        for (int i = 0; i < 500; i++) {
            assertThat(talker.write(writer, sample(i, 20_000))).isTrue();
        }
        network.run(Duration.ofSeconds(2));
        assertThat(store.waiting).hasSizeLessThan(70).startsWith(0).endsWith(499);
    }

    @Test
    void whatAReaderHasIsNotSentToItAnyMore() {
        var addressee = new Addressee(new GuidPrefix(1, 1), List.of());
        var proxy = new ReaderProxy(new Guid(addressee.prefix(), EntityId.reader(1)), addressee, true, 0, 0);
        for (int i = 1; i <= 3; i++) {
            var kept = new KeptSample(i, 0, Optional.empty(), Content.DATA, sample(i, 5_000));
            proxy.stream(kept).fragments().set(0, 4);
        }
        var answer = new AckNack(proxy.guid.entity(), EntityId.writer(2), NumberSet.empty(3), 1, true);
        assertThat(proxy.answered(answer, 3, 0)).isTrue();
        assertThat(proxy.streams).extracting(each -> each.sample().number()).containsExactly(3L);
    }

    /// It lacks what all others have.
    @Test
    void aLatchedWriterWaitsForALateReader() {
        var network = new SimulatedNetwork(11, 0);
        Node talker = join(network, LEASE);
        SampleWriter writer = writer(talker, network, ALL.latched());
        for (int i = 0; i < ROOM; i++) {
            assertThat(talker.write(writer, sample(i, 100))).isTrue();
        }
        Node listener = join(network, LEASE);
        var store = new Store(0);
        listener.participant.createReader("rt/chatter", TYPE, ALL.latched(), "", store, network.now());
        while (writer.matched() == 0) {
            network.run(Duration.ofNanos(SimulatedNetwork.MILLISECOND / 50));
        }
        assertThat(talker.write(writer, sample(ROOM, 100))).isFalse();
    }

    @Test
    void aLatchedWriterWaitsForALateNeighbor() {
        var network = new SimulatedNetwork(12, 0);
        Node node = join(network, LEASE);
        SampleWriter writer = writer(node, network, ALL.latched());
        for (int i = 0; i < ROOM; i++) {
            assertThat(node.write(writer, sample(i, 100))).isTrue();
        }
        node.participant.createReader("rt/chatter", TYPE, ALL.latched(), "", new Store(0), network.now());
        assertThat(node.write(writer, sample(ROOM, 100))).isFalse();
    }

    @Test
    void aWriterThatLeavesWaitsForNeighbors() {
        var network = new SimulatedNetwork(13, 0);
        Node node = join(network, LEASE);
        var store = new Store(1);
        SampleReader reader = reader(node, network, store);
        SampleWriter writer = writer(node, network, ALL);
        for (int i = 0; i < 3; i++) {
            assertThat(node.write(writer, sample(i, 100))).isTrue();
        }
        assertThat(writer.isAcknowledged()).isFalse();
        node.participant.remove(writer, network.now());
        for (int i = 0; i < 3; i++) {
            network.run(Duration.ofMillis(100));
            store.take(node, reader, network.now());
        }
        assertThat(store.taken).isEqualTo(numbers(3));
        assertThat(writer.isAcknowledged()).isTrue();
    }

    /// A client that takes nothing costs what it may have waiting, and no more.
    @Test
    void repliesThatNobodyTakesAreBounded() {
        var network = new SimulatedNetwork(14, 0);
        Node server = join(network, LEASE);
        Node client = join(network, LEASE);
        var store = new Store(2);
        SampleReader reader = reader(client, network, store);
        SampleWriter writer = writer(server, network, ALL);
        waitFor(writer, reader, network);
        for (int i = 0; i < COUNT; i++) {
            var reply = new Reply(reader.data().guid(), 0, Optional.empty(), sample(i, 100));
            server.participant.write(writer, reply, network.now());
            network.run(Duration.ofMillis(1));
        }
        for (int i = 0; i < COUNT; i++) {
            store.take(client, reader, network.now());
            network.run(Duration.ofMillis(5));
        }
        assertThat(store.taken).isEqualTo(numbers(ROOM + 2 + 16));
    }

    /// Two writers, of other participants or the same one, and a reader that takes one sample after the other.
    @ParameterizedTest
    @CsvSource({"false, false", "false, true", "true, false", "true, true"})
    void writersTakeTurns(boolean firstIsNeighbor, boolean secondIsNeighbor) {
        var network = new SimulatedNetwork(15, 0);
        Node listener = join(network, LEASE);
        Node first = firstIsNeighbor ? listener : join(network, LEASE);
        Node second = secondIsNeighbor ? listener : join(network, LEASE);
        var store = new Store(1);
        SampleReader reader = reader(listener, network, store);
        SampleWriter one = writer(first, network, ALL);
        SampleWriter two = writer(second, network, ALL);
        network.run(SOON);
        for (int i = 0; i < COUNT; i++) {
            while (first.write(one, sample(1, 100))) {
                network.run(Duration.ofMillis(1));
            }
            while (second.write(two, sample(2, 100))) {
                network.run(Duration.ofMillis(1));
            }
            store.take(listener, reader, network.now());
            network.run(Duration.ofMillis(5));
        }
        assertThat(Collections.frequency(store.taken, 1)).isBetween(90, 110);
        assertThat(Collections.frequency(store.taken, 2)).isBetween(90, 110);
    }

    /// It has room again, and does not say so.
    @Test
    void aReaderThatDoesNotSayThatItHasRoomGetsMoreSoon() {
        var network = new SimulatedNetwork(16, 0);
        Node talker = join(network, LEASE);
        Node listener = join(network, LEASE);
        var store = new Store(2);
        SampleReader reader = reader(listener, network, store);
        SampleWriter writer = writer(talker, network, ALL);
        waitFor(writer, reader, network);
        for (int i = 0; i < 4; i++) {
            talker.write(writer, sample(i, 100));
        }
        network.run(SOON);
        assertThat(store.waiting).containsExactly(0, 1);
        store.waiting.clear();
        network.run(Duration.ofSeconds(1));
        assertThat(store.waiting).containsExactly(2, 3);
    }
}
