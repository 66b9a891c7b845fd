package rsal.rtps;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.ByteBuffer;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import rsal.rtps.SimulatedNetwork.Node;
import rsal.rtps.discovery.Qos;
import rsal.rtps.wire.ParameterId;
import rsal.rtps.wire.ParameterList;

/// What goes wrong on one side harms neither the other one nor what follows.
class TroubleTest {
    private static final String TYPE = "std_msgs::msg::dds_::String_";
    private static final Duration SOON = Duration.ofMillis(300);
    private static final Qos RELIABLE = Qos.DEFAULT.keep(Qos.KEEP_ALL);
    private static final int SAMPLE_LIMIT = 300_000; // B

    private final List<Integer> heard = new ArrayList<>(); // first numbers of samples

    private static byte[] sample(int number, int size) {
        return ByteBuffer.allocate(size).putInt(0, number).array();
    }

    private static SampleWriter writer(Node node, SimulatedNetwork network) {
        return node.participant.createWriter("rt/chatter", TYPE, RELIABLE, "", network.now());
    }

    private SampleReader reader(Node node, SimulatedNetwork network) {
        SampleListener listener = sample -> heard.add(sample.payload().getInt(0));
        return node.participant.createReader("rt/chatter", TYPE, RELIABLE, "", listener, network.now());
    }

    /// Where three datagrams of ten get lost, 975 of 1,000 arrive within its farewell of half a second.
    @Test
    void lastSamplesOfAWriterThatLeavesArriveThoughDatagramsGetLost() {
        int arrived = 0;
        for (int seed = 0; seed < 100; seed++) {
            heard.clear();
            var network = new SimulatedNetwork(seed, 0.3);
            Node talker = network.join();
            SampleReader reader = reader(network.join(), network);
            SampleWriter writer = writer(talker, network);
            for (int i = 0; i < 100 && (writer.matched() == 0 || reader.matched() == 0); i++) {
                network.run(SOON);
            }
            talker.write(writer, sample(1, 100));
            talker.participant.remove(writer, network.now());
            network.run(Duration.ofMillis(450));
            assertThat(heard).as("seed %d", seed).isSubsetOf(1).hasSizeLessThan(2);
            arrived += heard.size();
            network.run(Duration.ofSeconds(10));
            assertThat(reader.matched()).isZero();
        }
        assertThat(arrived).isBetween(92, 100);
    }

    @Test
    void aWriterLeavesThoughItsReaderHasCrashed() {
        var network = new SimulatedNetwork(1, 0);
        Node talker = network.join();
        Node watcher = network.join();
        Node crashing = network.join();
        SampleReader reader = reader(watcher, network);
        reader(crashing, network);
        SampleWriter writer = writer(talker, network);
        network.run(SOON);
        crashing.crash();
        talker.write(writer, sample(1, 100));
        talker.participant.remove(writer, network.now());
        network.run(Duration.ofMillis(600));
        assertThat(reader.matched()).isZero();
        assertThat(heard).containsExactly(1);
    }

    @Test
    void aListenerThatFailsGetsTheNextSampleAndHarmsNoOtherOne() {
        var network = new SimulatedNetwork(2, 0.2);
        Node talker = network.join();
        Node watcher = network.join();
        var tries = new ArrayList<Integer>();
        SampleListener failing = sample -> {
            tries.add(sample.payload().getInt(0));
            throw new IllegalStateException("A test's listener fails.");
        };
        SampleReader reader =
                watcher.participant.createReader("rt/chatter", TYPE, RELIABLE, "", failing, network.now());
        reader(watcher, network);
        SampleWriter writer = writer(talker, network);
        for (int i = 0; i < 20 && (reader.matched() == 0 || writer.matched() < 2); i++) {
            network.run(SOON);
        }
        for (int i = 0; i < 20; i++) {
            talker.write(writer, sample(i, 100));
        }
        network.run(Duration.ofSeconds(3));
        assertThat(tries).hasSize(20).isSorted();
        assertThat(heard).isEqualTo(tries);
    }

    @Test
    void aSampleBeyondTheLimitIsLeftOutAndNotAskedForAgain() {
        var limits = new RtpsLimits(10, 10, 100, SAMPLE_LIMIT, 10 * SAMPLE_LIMIT, 16, 1 << 20, 1_000, 64 << 20);
        var network = new SimulatedNetwork(3, 0);
        Node talker = network.join();
        reader(network.join(limits, GraphListener.NONE, Duration.ofSeconds(20)), network);
        SampleWriter writer = writer(talker, network);
        network.run(SOON);
        talker.write(writer, sample(1, 100));
        talker.write(writer, sample(2, SAMPLE_LIMIT + 1));
        talker.write(writer, sample(3, 100));
        network.run(Duration.ofSeconds(2));
        assertThat(heard).containsExactly(1, 3);
        long before = network.sent();
        network.run(Duration.ofSeconds(2));
        assertThat(network.sent() - before).isLessThan(10); // announcements only
    }

    /// A writer that dies in the middle of a sample must not take the room of those that live.
    @Test
    void samplesThatStayIncompleteAreForgotten() {
        var limits = new RtpsLimits(10, 10, 100, SAMPLE_LIMIT, SAMPLE_LIMIT + 10, 16, 1 << 20, 1_000, 64 << 20);
        var network = new SimulatedNetwork(4, 0);
        Node dying = network.join();
        Node watcher = network.join(limits, GraphListener.NONE, Duration.ofSeconds(20));
        reader(watcher, network);
        SampleWriter first = writer(dying, network);
        network.run(SOON);
        dying.write(first, sample(1, SAMPLE_LIMIT));
        dying.crash();
        network.run(Duration.ofSeconds(6));
        Node talker = network.join();
        SampleWriter second = writer(talker, network);
        network.run(SOON);
        talker.write(second, sample(2, SAMPLE_LIMIT));
        network.run(Duration.ofSeconds(2));
        assertThat(heard).containsExactly(2);
    }

    @Test
    void whatIsBesideASampleInFragmentsArrives() {
        var network = new SimulatedNetwork(5, 0.1);
        Node talker = network.join();
        Node watcher = network.join();
        var beside = new ArrayList<Long>();
        SampleListener listener = sample -> sample.inlineQos()
                .find(ParameterId.RELATED_SAMPLE_IDENTITY, Long.BYTES)
                .ifPresent(found -> beside.add(found.getLong()));
        SampleReader reader =
                watcher.participant.createReader("rt/chatter", TYPE, RELIABLE, "", listener, network.now());
        SampleWriter writer = writer(talker, network);
        for (int i = 0; i < 20 && (reader.matched() == 0 || writer.matched() == 0); i++) {
            network.run(SOON);
        }
        for (int i = 0; i < 5; i++) {
            long number = i;
            talker.participant.write(
                    writer,
                    0,
                    Optional.of(list -> new Identity(number).put(list)),
                    sample(i, 10_000 * i + 10),
                    network.now());
            network.run(SOON);
        }
        network.run(Duration.ofSeconds(3));
        assertThat(beside).containsExactly(0L, 1L, 2L, 3L, 4L);
    }

    private record Identity(long number) {
        void put(ParameterList.Writer list) {
            list.put(ParameterId.RELATED_SAMPLE_IDENTITY, to -> to.putLong(number));
        }
    }

    @Test
    void whoMovesToAnotherAddressIsHeardAndReachedThere() {
        var network = new SimulatedNetwork(6, 0);
        Node talker = network.join();
        Node watcher = network.join();
        reader(watcher, network);
        SampleWriter before = writer(talker, network);
        network.run(SOON);
        talker.write(before, sample(1, 100));
        network.run(SOON);
        Node moved = network.moved(talker);
        SampleWriter after = writer(moved, network);
        network.run(SOON);
        moved.write(after, sample(2, 50_000));
        network.run(SOON);
        assertThat(heard).containsExactly(1, 2);
        assertThat(watcher.participant.participants()).hasSize(1);
    }

    /// A cable that fails in one direction: one side loses the other, which has noticed nothing when it is
    /// back.
    @Test
    void whoWasNotHeardForLongIsFoundAgainSoon() {
        var network = new SimulatedNetwork(7, 0);
        Node watcher = network.join();
        Node talker = network.join(RtpsLimits.DEFAULT, GraphListener.NONE, Duration.ofSeconds(10));
        SampleReader reader = reader(watcher, network);
        SampleWriter writer = talker.participant.createWriter("rt/chatter", TYPE, Qos.DEFAULT, "", network.now());
        network.run(SOON);
        for (int i = 0; i < 100; i++) { // acknowledged one by one
            talker.write(writer, sample(i, 100));
            network.run(Duration.ofMillis(20));
        }
        talker.mute(true);
        network.run(Duration.ofSeconds(12));
        assertThat(reader.matched()).isZero();
        talker.mute(false);
        network.run(Duration.ofSeconds(2));
        assertThat(reader.matched()).isEqualTo(1);
        talker.write(writer, sample(100, 100));
        network.run(SOON);
        assertThat(heard).isEqualTo(IntStream.rangeClosed(0, 100).boxed().toList());
    }

    /// The same where the writer keeps all: what was written meanwhile comes, and nothing twice.
    @Test
    void samplesOfAnOutageFollowThoseBeforeIt() {
        var network = new SimulatedNetwork(8, 0.1);
        Node watcher = network.join();
        Node talker = network.join(RtpsLimits.DEFAULT, GraphListener.NONE, Duration.ofSeconds(10));
        SampleReader reader = reader(watcher, network);
        SampleWriter writer = writer(talker, network);
        network.run(Duration.ofSeconds(2));
        for (int i = 0; i < 300; i++) {
            if (i == 100) {
                talker.mute(true);
            }
            talker.write(writer, sample(i, 100));
            network.run(Duration.ofMillis(100));
        }
        assertThat(reader.matched()).isZero();
        talker.mute(false);
        network.run(Duration.ofSeconds(5));
        assertThat(heard).isEqualTo(IntStream.range(0, 300).boxed().toList());
    }
}
