package rsal.rtps;

import static org.assertj.core.api.Assertions.assertThat;

import java.net.InetSocketAddress;
import java.nio.ByteBuffer;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.stream.LongStream;
import org.junit.jupiter.api.Test;
import rsal.rtps.WriterProxy.Arrival;
import rsal.rtps.wire.EntityId;
import rsal.rtps.wire.Guid;
import rsal.rtps.wire.GuidPrefix;
import rsal.rtps.wire.InvalidRtps;
import rsal.rtps.wire.MessageReader;
import rsal.rtps.wire.NumberSet;
import rsal.rtps.wire.ParameterList;
import rsal.rtps.wire.Submessage;
import rsal.rtps.wire.Submessage.AckNack;
import rsal.rtps.wire.Submessage.Content;
import rsal.rtps.wire.Submessage.DataFragments;
import rsal.rtps.wire.Submessage.Gap;
import rsal.rtps.wire.Submessage.Heartbeat;
import rsal.rtps.wire.Submessage.NackFragments;

/// What a reader takes from a writer and asks it for, submessage by submessage.
class WriterProxyTest {
    private static final long SOON = 20_000_000; // ns
    private static final long DAY = 86_400_000_000_000L; // ns
    private static final Guid WRITER = new Guid(new GuidPrefix(1, 1), EntityId.writer(1));
    private static final EntityId READER = EntityId.reader(2);
    private static final Addressee TALKER = new Addressee(WRITER.prefix(), List.of(new InetSocketAddress(7410)));

    private final List<Long> taken = new ArrayList<>(); // numbers
    private boolean hasRoom = true;

    private final SampleReader.Receiver receiver = new SampleReader.Receiver() {
        @Override
        public void accept(Arrival sample) {
            taken.add(sample.number());
        }

        @Override
        public boolean hasRoom() {
            return hasRoom;
        }
    };

    private WriterProxy proxy(long now) {
        return new WriterProxy(WRITER, READER, TALKER, true, new AssemblyBudget(RtpsLimits.DEFAULT), receiver, now);
    }

    private static Arrival sample(long number) {
        return new Arrival(WRITER, number, 0, ParameterList.EMPTY, Content.DATA, ByteBuffer.allocate(8), false);
    }

    private static Gap gap(long start, long end) {
        return new Gap(READER, WRITER.entity(), start, NumberSet.empty(end));
    }

    private static Heartbeat heartbeat(long first, long last, int count) {
        return new Heartbeat(READER, WRITER.entity(), first, last, count, false);
    }

    /// The first of two fragments.
    private static DataFragments half(long number) {
        return new DataFragments(
                READER, WRITER.entity(), number, ParameterList.EMPTY, 1, 1, 1_000, 2_000, ByteBuffer.allocate(1_000));
    }

    private static List<Submessage> requests(WriterProxy proxy, long now) {
        var requests = new ArrayList<Submessage>();
        Transmitter network = new Transmitter() {
            @Override
            public void send(ByteBuffer datagram, InetSocketAddress to) {
                try {
                    MessageReader.read(datagram.duplicate(), (_, submessage) -> requests.add(submessage));
                } catch (InvalidRtps e) {
                    throw new AssertionError(e);
                }
            }

            @Override
            public void announce(ByteBuffer datagram, Set<InetSocketAddress> known) {
                throw new AssertionError("Nothing is announced.");
            }
        };
        var outbox = new DatagramOutbox(new GuidPrefix(2, 2), network, 1_344);
        proxy.request(outbox, now);
        outbox.flush();
        return requests;
    }

    private static AckNack acknowledgment(WriterProxy proxy, long now) {
        return (AckNack) requests(proxy, now).getFirst();
    }

    @Test
    void aGapSkipsNothingThatHasCome() {
        WriterProxy proxy = proxy(0);
        proxy.receive(sample(1));
        proxy.receive(sample(3));
        proxy.receive(sample(5));
        proxy.receive(gap(2, 7));
        proxy.receive(sample(7));
        assertThat(taken).containsExactly(1L, 3L, 5L, 7L);
    }

    @Test
    void aGapSkipsNothingThatWasRefused() {
        WriterProxy proxy = proxy(0);
        hasRoom = false;
        proxy.receive(sample(1));
        proxy.receive(gap(1, 4));
        hasRoom = true;
        proxy.receive(heartbeat(4, 4, 1), 0);
        proxy.receive(sample(4));
        assertThat(taken).containsExactly(1L, 4L);
    }

    @Test
    void eachRequestForFragmentsHasItsCount() {
        WriterProxy proxy = proxy(0);
        proxy.receive(half(1), 0, 0);
        proxy.receive(half(2), 0, 0);
        proxy.receive(half(3), 0, 0);
        proxy.receive(heartbeat(1, 3, 1), 0);
        List<Integer> counts = requests(proxy, 0).stream()
                .filter(NackFragments.class::isInstance)
                .map(each -> ((NackFragments) each).count())
                .toList();
        assertThat(counts).hasSize(3).isSorted().doesNotHaveDuplicates();
    }

    /// Of a reader that forgets the writer every day, on a machine that runs for two hundred days.
    @Test
    void countsGrowFromOneProxyToTheNext() {
        List<Integer> counts = LongStream.range(0, 200)
                .mapToObj(day -> acknowledgment(proxy(day * DAY), day * DAY).count())
                .toList();
        assertThat(counts).isSorted().doesNotHaveDuplicates().allMatch(each -> each > 0);
    }

    @Test
    void aWriterThatIsFoundAgainGoesOn() {
        WriterProxy proxy = proxy(0);
        proxy.goOn(11);
        assertThat(acknowledgment(proxy, 0).missing().base()).isEqualTo(11);
        proxy.receive(sample(1));
        proxy.receive(heartbeat(1, 12, 1), 0);
        proxy.receive(sample(11));
        proxy.receive(sample(12));
        assertThat(taken).containsExactly(11L, 12L);
    }

    @Test
    void aWriterThatIsStartedAgainWithItsNameIsHeard() {
        WriterProxy proxy = proxy(0);
        proxy.goOn(11);
        proxy.receive(heartbeat(1, 2, 1), 0);
        proxy.receive(sample(1));
        proxy.receive(sample(2));
        assertThat(taken).containsExactly(1L, 2L);
    }

    /// Else Cyclone DDS waits for an acknowledgment while it receives nothing.
    @Test
    void whatWasRefusedIsAcknowledgedWhenItIsTaken() {
        for (boolean says : new boolean[] {false, true}) {
            WriterProxy proxy = proxy(0);
            proxy.receive(heartbeat(1, 1, 1), 0);
            hasRoom = false;
            proxy.receive(sample(1));
            assertThat(acknowledgment(proxy, 0).missing().base()).isEqualTo(1);
            hasRoom = true;
            proxy.receive(new Heartbeat(READER, WRITER.entity(), 1, 1, 2, true), 1);
            if (says) {
                proxy.resume(2);
            }
            assertThat(acknowledgment(proxy, SOON).missing().base()).isEqualTo(2);
        }
    }
}
