package rsal.bench.rtps;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.net.InetAddress;
import java.security.SecureRandom;
import java.time.Duration;
import java.util.List;
import java.util.concurrent.atomic.AtomicReference;
import java.util.concurrent.locks.LockSupport;
import java.util.function.BooleanSupplier;
import java.util.random.RandomGenerator;
import rsal.bench.measurement.MeasurementFailed;
import rsal.rtps.GraphListener;
import rsal.rtps.SampleListener;
import rsal.rtps.SampleReader;
import rsal.rtps.SampleWriter;
import rsal.rtps.UdpParticipant;
import rsal.rtps.discovery.Qos;
import rsal.time.AllowedToReadWallClock;

/// A participant on the loopback network, and its link.
@AllowedToReadWallClock("Benchmarks measure real time.")
final class LoopbackPeer implements AutoCloseable {
    static final Duration LEASE = Duration.ofSeconds(20);
    private static final int DOMAIN = 1 + (int) (ProcessHandle.current().pid() % 100); // no other run's
    private static final Duration GLANCE = Duration.ofNanos(200_000);

    private final UdpParticipant participant;
    private final LossyLink link;

    private LoopbackPeer(UdpParticipant participant, LossyLink link) {
        this.participant = participant;
        this.link = link;
    }

    /// @param loss share of the datagrams it sends that get lost
    /// @param random which ones
    /// @param lease after which others take it for gone that hear nothing of it
    static LoopbackPeer join(double loss, RandomGenerator random, Duration lease, GraphListener graph) {
        return join(loss, random, lease, UdpParticipant.LOCAL_FRAGMENT, graph);
    }

    /// One that loses datagrams as long as those of a network.
    static LoopbackPeer inNetwork(double loss, RandomGenerator random) {
        return join(loss, random, LEASE, UdpParticipant.NETWORK_FRAGMENT, GraphListener.NONE);
    }

    private static LoopbackPeer join(
            double loss, RandomGenerator random, Duration lease, int fragment, GraphListener graph) {
        List<InetAddress> here = List.of(InetAddress.getLoopbackAddress());
        var options = new UdpParticipant.Options(DOMAIN, here, List.of(), lease, "bench", "");
        var link = new AtomicReference<LossyLink>();
        try {
            var participant =
                    new UdpParticipant(options, System::nanoTime, new SecureRandom(), graph, fragment, sockets -> {
                        link.set(new LossyLink(sockets, loss, random));
                        return link.get();
                    });
            return new LoopbackPeer(participant, link.get());
        } catch (IOException e) {
            throw new UncheckedIOException("A participant can't be on the loopback network.", e);
        }
    }

    /// One that loses nothing.
    static LoopbackPeer join() {
        return join(0, new SecureRandom(), LEASE, GraphListener.NONE);
    }

    SampleWriter writer(String topic, String type, Qos qos) {
        return participant.createWriter(topic, type, qos, "");
    }

    SampleReader reader(String topic, String type, Qos qos, SampleListener listener) {
        return participant.createReader(topic, type, qos, "", listener);
    }

    void write(SampleWriter writer, byte[] payload) {
        participant.write(writer, 0, payload);
    }

    /// How many others are there.
    int others() {
        return participant.participants().size();
    }

    /// How many readers of others take what the writer writes from now on.
    int ready(SampleWriter writer) {
        return participant.readers(writer).size();
    }

    /// Whether that reader takes what the writer writes from now on.
    boolean reaches(SampleWriter writer, SampleReader theirs) {
        return participant.readers(writer).contains(theirs.data().guid());
    }

    /// When it last announced itself [ns].
    long announced() {
        return link.announced();
    }

    /// Sends nothing more, as after a crash or where others can't be reached, but still hears; or sends again.
    void cut(boolean is) {
        link.cut(is);
    }

    /// @return how long it took [s]
    /// @throws MeasurementFailed when it does not happen within a minute
    static double await(String what, BooleanSupplier happened) {
        long begun = System.nanoTime();
        while (!happened.getAsBoolean()) {
            if (System.nanoTime() - begun > Duration.ofMinutes(1).toNanos()) {
                throw new MeasurementFailed("Within a minute, %s.".formatted(what));
            }
            LockSupport.parkNanos(GLANCE.toNanos());
        }
        return (System.nanoTime() - begun) * 1e-9;
    }

    @Override
    public void close() {
        participant.close();
    }
}
