package rsal.rtps;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.tuple;

import java.nio.ByteBuffer;
import java.time.Duration;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.SplittableRandom;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import rsal.rtps.SimulatedNetwork.Node;
import rsal.rtps.discovery.EndpointData;
import rsal.rtps.discovery.ParticipantData;
import rsal.rtps.discovery.Qos;
import rsal.rtps.wire.EntityId;
import rsal.rtps.wire.Guid;
import rsal.rtps.wire.GuidPrefix;
import rsal.testkit.LongTest;
import rsal.testkit.Rounds;

/// Participants on a simulated network: what arrives, in which order, and how soon.
class ParticipantTest {
    private static final String TYPE = "std_msgs::msg::dds_::String_";
    private static final Duration SOON = Duration.ofMillis(300);
    private static final Qos RELIABLE = Qos.DEFAULT.keep(Qos.KEEP_ALL);

    private final List<byte[]> heard = new ArrayList<>();

    private SampleListener hearing() {
        return sample -> heard.add(bytes(sample.payload()));
    }

    private static byte[] bytes(ByteBuffer payload) {
        var bytes = new byte[payload.remaining()];
        payload.duplicate().get(bytes);
        return bytes;
    }

    private static byte[] sample(int number, int size) {
        var bytes = new byte[size];
        new SplittableRandom(number).nextBytes(bytes);
        return ByteBuffer.wrap(bytes).putInt(0, number).array();
    }

    private List<Integer> heardNumbers() {
        return heard.stream().map(each -> ByteBuffer.wrap(each).getInt()).toList();
    }

    private static SampleWriter writer(Node node, SimulatedNetwork network, Qos qos) {
        return node.participant.createWriter("rt/chatter", TYPE, qos, "", network.now());
    }

    private SampleReader reader(Node node, SimulatedNetwork network, Qos qos) {
        return node.participant.createReader("rt/chatter", TYPE, qos, "", hearing(), network.now());
    }

    /// Until it has a reader: where much gets lost, that takes a while.
    private static void waitFor(SampleWriter writer, SimulatedNetwork network) {
        for (int i = 0; i < 600 && writer.matched() == 0; i++) {
            network.run(Duration.ofMillis(100));
        }
        assertThat(writer.matched()).isEqualTo(1);
    }

    /// Each datagram costs both sides a system call, so what goes to one participant at once goes in one of them: of
    /// all that is sent, five are the first announcements.
    @Test
    void findEachOtherByFewDatagrams() {
        var network = new SimulatedNetwork(1, 0);
        int nodes = Rounds.of(20, 100);
        for (int i = 0; i < nodes; i++) {
            Node node = network.join();
            reader(node, network, Qos.DEFAULT);
            writer(node, network, Qos.DEFAULT);
        }
        network.run(Duration.ofMillis(450));
        for (int i = 0; i < nodes; i++) {
            assertThat(network.node(i).participant.endpoints()).hasSize(2 * (nodes - 1));
        }
        assertThat(network.sent()).isLessThan(16L * nodes * (nodes - 1));
    }

    /// Announcements of n participants to each other are n² datagrams, so that of many each is rarer.
    @Test
    void manyAnnounceThemselvesLessOften() {
        var network = new SimulatedNetwork(1, 0);
        int nodes = 61; // each has three times as many others as few are, and a lease of 20 s: one in 20 / 6 s
        for (int i = 0; i < nodes; i++) {
            network.join();
        }
        network.run(Duration.ofSeconds(5));
        long before = network.sent();
        network.run(Duration.ofSeconds(20));
        assertThat(network.sent() - before)
                .as("6 to the group, 3 of these to each address")
                .isBetween(7L * nodes * nodes, 10L * nodes * nodes);
        Node late = network.join();
        network.run(SOON);
        assertThat(late.participant.participants()).hasSize(nodes);
        assertThat(network.node(0).participant.participants()).hasSize(nodes);
    }

    /// Who is known and was heard in the multicast group gets announcements there alone; but it may not hear that.
    @ParameterizedTest
    @ValueSource(ints = {2, 65})
    void thoseThatDoNotHearTheGroupStay(int nodes) {
        var network = new SimulatedNetwork(3, 0.05);
        for (int i = 0; i < nodes; i++) {
            network.join();
        }
        network.node(0).ignoreGroup();
        network.run(Duration.ofSeconds(3));
        for (int second = 0; second < 45; second++) {
            network.run(Duration.ofSeconds(1));
            assertThat(network.node(0).participant.participants())
                    .as("after %d s", second)
                    .hasSize(nodes - 1);
        }
    }

    @Test
    void findEachOtherAndTheirEndpoints() {
        var network = new SimulatedNetwork(1, 0);
        Node talker = network.join();
        Node listener = network.join();
        SampleWriter writer = writer(talker, network, Qos.DEFAULT);
        reader(listener, network, Qos.DEFAULT);
        network.run(SOON);
        assertThat(listener.participant.participants())
                .extracting(ParticipantData::name)
                .containsExactly("node 1");
        assertThat(listener.participant.endpoints())
                .extracting(EndpointData::topic, EndpointData::type, EndpointData::qos)
                .containsExactly(tuple("rt/chatter", TYPE, Qos.DEFAULT));
        assertThat(writer.matched()).isEqualTo(1);
    }

    @ParameterizedTest
    @ValueSource(doubles = {0, 0.1, 0.3, 0.5})
    void reliableSamplesArriveAllOnceInOrder(double loss) {
        for (int seed = 0; seed < Rounds.of(5, 100); seed++) {
            heard.clear();
            var network = new SimulatedNetwork(seed, loss).doubling();
            Node talker = network.join();
            Node listener = network.join();
            SampleWriter writer = writer(talker, network, RELIABLE);
            reader(listener, network, RELIABLE);
            waitFor(writer, network);
            for (int i = 0; i < 200; i++) {
                talker.write(writer, sample(i, 100));
                network.run(Duration.ofMillis(5));
            }
            network.run(Duration.ofSeconds(loss < 0.5 ? 5 : 30));
            assertThat(heardNumbers())
                    .as("seed %d", seed)
                    .isEqualTo(IntStream.range(0, 200).boxed().toList());
            assertThat(writer.isAcknowledged()).isTrue();
        }
    }

    /// What a robot needs: with one datagram of ten lost, 99 of 100 samples come within 100 ms.
    @Test
    void reliableSamplesComeSoonThoughDatagramsGetLost() {
        var network = new SimulatedNetwork(3, 0.1);
        Node talker = network.join();
        Node listener = network.join();
        SampleWriter writer = writer(talker, network, RELIABLE);
        var delays = new ArrayList<Long>();
        listener.participant.createReader(
                "rt/chatter",
                TYPE,
                RELIABLE,
                "",
                sample -> delays.add(network.now() - sample.timestamp()),
                network.now());
        network.run(Duration.ofSeconds(3));
        for (int i = 0; i < 2_000; i++) {
            talker.write(writer, sample(i, 100));
            network.run(Duration.ofMillis(50));
        }
        network.run(Duration.ofSeconds(3));
        assertThat(delays).hasSize(2_000);
        delays.sort(null);
        assertThat(Duration.ofNanos(delays.get(1_980))).isLessThan(Duration.ofMillis(100));
    }

    /// A client asks as soon as it knows the server, which may not know yet where to reply.
    @ParameterizedTest
    @ValueSource(doubles = {0, 0.1, 0.3})
    void repliesReachClientsThatAskEarly(double loss) {
        for (int seed = 0; seed < Rounds.of(50, 1_000); seed++) {
            heard.clear();
            var network = new SimulatedNetwork(seed, loss);
            Node server = network.join();
            Node client = network.join();
            SampleWriter replies = server.participant.createWriter("rr/echo", TYPE, RELIABLE, "", network.now());
            SampleListener echo = request -> {
                var reply = new Reply(request.writer(), 0, Optional.empty(), bytes(request.payload()));
                server.participant.write(replies, reply, network.now());
            };
            server.participant.createReader("rq/echo", TYPE, RELIABLE, "", echo, network.now());
            SampleWriter requests = client.participant.createWriter("rq/echo", TYPE, RELIABLE, "", network.now());
            SampleReader answers =
                    client.participant.createReader("rr/echo", TYPE, RELIABLE, "", hearing(), network.now());
            for (int i = 0; i < 60_000 && (requests.readers().isEmpty() || answers.matched() == 0); i++) {
                network.run(Duration.ofMillis(1));
            }
            client.write(requests, sample(seed, 100));
            network.run(Duration.ofSeconds(10));
            assertThat(heardNumbers()).as("seed %d", seed).containsExactly(seed);
        }
    }

    /// Nodes of a process share a participant: one client of a service may be known when another one asks.
    @ParameterizedTest
    @ValueSource(doubles = {0, 0.3})
    void repliesReachASecondClientOfTheParticipant(double loss) {
        for (int seed = 0; seed < Rounds.of(50, 1_000); seed++) {
            heard.clear();
            var network = new SimulatedNetwork(seed, loss);
            Node server = network.join();
            Node client = network.join();
            SampleWriter replies = server.participant.createWriter("rr/echo", TYPE, RELIABLE, "", network.now());
            client.participant.createReader("rr/echo", TYPE, RELIABLE, "", _ -> {}, network.now());
            network.run(Duration.ofSeconds(10));
            SampleReader answers =
                    client.participant.createReader("rr/echo", TYPE, RELIABLE, "", hearing(), network.now());
            var reply = new Reply(answers.data().guid(), 0, Optional.empty(), sample(seed, 100));
            server.participant.write(replies, reply, network.now());
            network.run(Duration.ofSeconds(10));
            assertThat(heardNumbers()).as("seed %d", seed).containsExactly(seed);
        }
    }

    /// Nobody knows a reader of replies for it.
    @Test
    void replyIsWrittenFiveSecondsLaterWhereNobodyReadsIt() {
        var network = new SimulatedNetwork(1, 0);
        Node server = network.join();
        Node other = network.join();
        SampleWriter replies = writer(server, network, RELIABLE);
        reader(other, network, RELIABLE);
        waitFor(replies, network);
        var unknown = new Guid(new GuidPrefix(7, 7), EntityId.writer(1));
        var reply = new Reply(unknown, 0, Optional.empty(), sample(3, 100));
        server.participant.write(replies, reply, network.now());
        network.run(Duration.ofMillis(4_900));
        assertThat(heardNumbers()).isEmpty();
        network.run(Duration.ofMillis(200));
        assertThat(heardNumbers()).containsExactly(3);
    }

    @ParameterizedTest
    @ValueSource(doubles = {0, 0.1, 0.3})
    void samplesInFragmentsArriveWhole(double loss) {
        for (int seed = 0; seed < Rounds.of(3, 50); seed++) {
            heard.clear();
            var network = new SimulatedNetwork(seed, loss);
            Node talker = network.join();
            Node listener = network.join();
            SampleWriter writer = writer(talker, network, RELIABLE);
            reader(listener, network, RELIABLE);
            waitFor(writer, network);
            int size = 40_000;
            for (int i = 0; i < 5; i++) {
                talker.write(writer, sample(i, size + i));
                network.run(Duration.ofMillis(100));
            }
            network.run(Duration.ofSeconds(8));
            assertThat(heard).as("seed %d", seed).hasSize(5);
            for (int i = 0; i < 5; i++) {
                assertThat(Arrays.equals(heard.get(i), sample(i, size + i))).isTrue();
            }
        }
    }

    @Test
    void bestEffortLeavesOutWhatIsLostAndKeepsTheOrder() {
        var network = new SimulatedNetwork(5, 0.2).doubling();
        Node talker = network.join();
        Node listener = network.join();
        SampleWriter writer = writer(talker, network, Qos.DEFAULT);
        reader(listener, network, Qos.SENSOR_DATA);
        network.run(Duration.ofSeconds(3));
        for (int i = 0; i < 500; i++) {
            talker.write(writer, sample(i, 100));
            network.run(Duration.ofMillis(20));
        }
        assertThat(heardNumbers()).isSorted().doesNotHaveDuplicates();
        assertThat(heard).hasSizeBetween(350, 450);
    }

    @ParameterizedTest
    @ValueSource(doubles = {0, 0.3})
    void lateReadersGetWhatIsLatched(double loss) {
        var network = new SimulatedNetwork(7, loss);
        Node talker = network.join();
        SampleWriter writer = writer(talker, network, Qos.LATCHED.keep(3));
        for (int i = 0; i < 5; i++) {
            talker.write(writer, sample(i, 3_000));
        }
        network.run(SOON);
        Node listener = network.join();
        reader(listener, network, Qos.LATCHED);
        network.run(Duration.ofSeconds(6));
        assertThat(heardNumbers()).containsExactly(2, 3, 4);
    }

    @ParameterizedTest
    @ValueSource(doubles = {0, 0.3})
    void lateReadersGetNothingOldOfVolatileWriters(double loss) {
        var network = new SimulatedNetwork(8, loss);
        Node talker = network.join();
        SampleWriter writer = writer(talker, network, RELIABLE);
        for (int i = 0; i < 5; i++) {
            talker.write(writer, sample(i, 100));
        }
        network.run(SOON);
        Node listener = network.join();
        reader(listener, network, RELIABLE);
        network.run(Duration.ofSeconds(6));
        talker.write(writer, sample(5, 100));
        network.run(Duration.ofSeconds(2));
        assertThat(heardNumbers()).containsExactly(5);
    }

    @Test
    void slowReadersLoseWhatAWriterKeepsNoLonger() {
        var network = new SimulatedNetwork(9, 0);
        Node talker = network.join();
        Node listener = network.join();
        SampleWriter writer = writer(talker, network, Qos.DEFAULT.keep(2));
        reader(listener, network, Qos.DEFAULT);
        network.run(SOON);
        for (int i = 0; i < 10; i++) {
            talker.participant.write(
                    writer, 0, Optional.empty(), sample(i, 10_000), network.now()); // faster than it is sent
        }
        network.run(Duration.ofSeconds(1));
        assertThat(heardNumbers()).isSorted().doesNotHaveDuplicates().contains(8, 9);
    }

    @Test
    void neighborsInOneParticipantHearEachOther() {
        var network = new SimulatedNetwork(10, 0);
        Node node = network.join();
        SampleWriter writer = writer(node, network, Qos.LATCHED);
        node.write(writer, sample(1, 50));
        SampleReader reader = reader(node, network, Qos.LATCHED);
        node.write(writer, sample(2, 50));
        network.run(SOON);
        assertThat(heardNumbers()).containsExactly(1, 2);
        node.participant.remove(reader, network.now());
        node.write(writer, sample(3, 50));
        assertThat(heard).hasSize(2);
    }

    @Test
    void printWhatDoesNotFit() {
        var reported = new ArrayList<String>();
        var network = new SimulatedNetwork(11, 0);
        Node talker = network.join();
        Node listener = network.join(
                RtpsLimits.DEFAULT,
                new GraphListener() {
                    @Override
                    public void onMismatch(EndpointData own, EndpointData other, String why) {
                        reported.add(why);
                    }
                },
                Duration.ofSeconds(20));
        writer(talker, network, Qos.SENSOR_DATA);
        reader(listener, network, Qos.DEFAULT);
        network.run(SOON);
        assertThat(reported).containsExactly("reliability: the reader wants reliable, the writer offers best effort");
    }

    /// Notes who is gone.
    private static final class Lost implements GraphListener {
        private final List<GuidPrefix> participants = new ArrayList<>();
        private final List<Guid> endpoints = new ArrayList<>();

        @Override
        public void onParticipantLost(GuidPrefix participant) {
            participants.add(participant);
        }

        @Override
        public void onEndpointLost(Guid endpoint) {
            endpoints.add(endpoint);
        }
    }

    @Test
    void whoCrashesIsLostWithinItsLease() {
        var network = new SimulatedNetwork(12, 0);
        var lost = new Lost();
        Node watcher = network.join(RtpsLimits.DEFAULT, lost, Duration.ofSeconds(20));
        Node talker = network.join(RtpsLimits.DEFAULT, GraphListener.NONE, Duration.ofSeconds(10));
        writer(talker, network, Qos.DEFAULT);
        SampleReader reader = reader(watcher, network, Qos.DEFAULT);
        network.run(Duration.ofSeconds(30));
        assertThat(lost.participants).isEmpty();
        talker.crash();
        network.run(Duration.ofMillis(6_900));
        assertThat(lost.participants).isEmpty();
        network.run(Duration.ofMillis(3_600));
        assertThat(lost.participants).hasSize(1);
        assertThat(lost.endpoints).hasSize(1);
        assertThat(reader.matched()).isZero();
    }

    @Test
    void whoLeavesIsLostAtOnce() {
        var network = new SimulatedNetwork(13, 0);
        var lost = new Lost();
        Node watcher = network.join(RtpsLimits.DEFAULT, lost, Duration.ofSeconds(20));
        Node talker = network.join();
        SampleWriter writer = writer(talker, network, Qos.DEFAULT);
        SampleReader reader = reader(watcher, network, Qos.DEFAULT);
        network.run(SOON);
        assertThat(reader.matched()).isEqualTo(1);
        talker.participant.remove(writer, network.now());
        network.run(SOON);
        assertThat(reader.matched()).isZero();
        assertThat(lost.endpoints).hasSize(1);
        talker.participant.close(network.now());
        talker.crash();
        network.run(SOON);
        assertThat(lost.participants).hasSize(1);
    }

    @Test
    @LongTest
    void aHundredFindEachOtherWithinThreeSeconds() {
        var network = new SimulatedNetwork(14, 0);
        var nodes = IntStream.range(0, 100).mapToObj(_ -> network.join()).toList();
        nodes.forEach(node -> writer(node, network, Qos.SENSOR_DATA));
        SampleReader reader = reader(nodes.getFirst(), network, Qos.SENSOR_DATA);
        network.run(Duration.ofSeconds(3));
        assertThat(nodes)
                .allSatisfy(node -> assertThat(node.participant.participants()).hasSize(99));
        assertThat(reader.matched()).isEqualTo(99);
    }

    @Test
    void participantsBeyondTheLimitAreRefusedAndCounted() {
        var limits = new RtpsLimits(3, 2, 5, 1 << 20, 1 << 20, 16, 1 << 16, 1_000, 1 << 20);
        var network = new SimulatedNetwork(15, 0);
        Node watcher = network.join(limits, GraphListener.NONE, Duration.ofSeconds(20));
        for (int i = 0; i < 6; i++) {
            Node node = network.join();
            for (int k = 0; k < 4; k++) {
                writer(node, network, Qos.DEFAULT);
            }
        }
        network.run(Duration.ofSeconds(10));
        assertThat(watcher.participant.participants()).hasSize(3);
        assertThat(watcher.participant.endpoints()).hasSize(5);
        assertThat(watcher.participant.surplus()).isPositive();
    }

    /// A network on which all is well is quiet.
    @Test
    void silenceCostsNearlyNothing() {
        var network = new SimulatedNetwork(16, 0);
        Node talker = network.join();
        Node listener = network.join();
        SampleWriter writer = writer(talker, network, Qos.DEFAULT);
        reader(listener, network, Qos.DEFAULT);
        network.run(Duration.ofSeconds(2));
        talker.write(writer, sample(1, 100));
        network.run(Duration.ofSeconds(2));
        long before = network.sent();
        network.run(Duration.ofSeconds(30));
        assertThat(network.sent() - before)
                .isLessThanOrEqualTo(2 * 2 * 24 + 2 * 5); // announcements, heard by both, and to each other alone
    }
}
