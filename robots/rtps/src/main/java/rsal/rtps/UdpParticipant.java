package rsal.rtps;

import java.io.IOException;
import java.lang.System.Logger;
import java.lang.System.Logger.Level;
import java.net.Inet4Address;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.nio.ByteBuffer;
import java.nio.channels.DatagramChannel;
import java.nio.channels.SelectionKey;
import java.nio.channels.Selector;
import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalLong;
import java.util.Set;
import java.util.concurrent.TimeUnit;
import java.util.function.Consumer;
import java.util.function.LongSupplier;
import java.util.function.Supplier;
import java.util.function.UnaryOperator;
import java.util.random.RandomGenerator;
import rsal.rtps.discovery.BuiltinEndpoint;
import rsal.rtps.discovery.EndpointData;
import rsal.rtps.discovery.ParticipantData;
import rsal.rtps.discovery.Qos;
import rsal.rtps.wire.Guid;
import rsal.rtps.wire.GuidPrefix;
import rsal.rtps.wire.Locator;
import rsal.rtps.wire.MessageWriter;
import rsal.rtps.wire.ParameterList;

/// A [Participant] on UDP sockets, with a thread that receives.
///
/// Safe for several threads. Listeners are called on its thread, and on threads that call its methods, such as
/// [#write] and [#resume], always under its lock: hold no lock that your listener takes while you call it. A
/// listener may write by another participant, if no listener of that one writes by this one.
public final class UdpParticipant implements AutoCloseable {
    /// Which nobody else uses.
    public static final int VENDOR = 0x0152;

    /// Most of a sample that one datagram has in networks [B]: with heads and inline QoS, it fits a packet of
    /// Ethernet.
    public static final int NETWORK_FRAGMENT = 1_216;

    /// The same where all are on this machine [B].
    public static final int LOCAL_FRAGMENT = 60_000;

    private static final Logger LOG = System.getLogger(UdpParticipant.class.getName());
    private static final int AT_ONCE = 64; // datagrams of one socket
    private static final int TURNS = 8; // of all sockets before what is due: answers to it may be among the datagrams
    private static final long MILLISECOND = 1_000_000; // ns
    private static final long FAREWELL = 500 * MILLISECOND;

    /// Bound on threads that hold a participant's lock, as those do that call listeners.
    private static final ScopedValue<Boolean> LOCKED = ScopedValue.newInstance();

    private final LongSupplier clock; // ns
    private final Sockets sockets;
    private final boolean isLocal; // only programs on this machine are heard
    private final Selector selector;
    private final Thread thread;
    private final Participant participant; // its own lock
    private volatile boolean isClosed;
    private boolean reportedSurplus; // of the thread
    private long sleepsUntil = Long.MIN_VALUE; // [ns], under the lock

    /// Where and as whom to take part.
    ///
    /// @param domain 0 to 232, `ROS_DOMAIN_ID`
    /// @param addresses of this machine, one in each network where others are; a loopback one alone finds others on
    ///     this machine only
    /// @param peers other machines to look for participants on, beside the multicast group
    /// @param lease within which it announces itself again
    /// @param name for people
    /// @param userData for ROS, `enclave=/;`
    public record Options(
            int domain,
            List<InetAddress> addresses,
            List<InetAddress> peers,
            Duration lease,
            String name,
            String userData) {
        public Options {
            if (domain < 0 || domain > DomainPorts.LAST_DOMAIN) {
                throw new IllegalArgumentException("Domain %d is none; there are 0 to %d, of which 0 to 101 are safe."
                        .formatted(domain, DomainPorts.LAST_DOMAIN));
            }
            if (addresses.isEmpty()) {
                throw new IllegalArgumentException("A participant needs an address of this machine.");
            }
            addresses = List.copyOf(addresses);
            peers = List.copyOf(peers);
            addresses.forEach(Options::require);
            peers.forEach(Options::require);
        }

        private static void require(InetAddress address) {
            if (!(address instanceof Inet4Address)) {
                throw new IllegalArgumentException(
                        "'%s' is an address of IPv6, which can't be used yet. Write one of IPv4."
                                .formatted(address.getHostAddress()));
            }
        }

        /// On this machine only.
        public static Options local(int domain, String name) {
            List<InetAddress> here = List.of(InetAddress.getLoopbackAddress());
            return new Options(domain, here, List.of(), Duration.ofSeconds(20), name, "");
        }

        /// Whether only others on this machine are reached.
        public boolean isLocal() {
            return addresses.stream().allMatch(InetAddress::isLoopbackAddress);
        }
    }

    /// @param clock of real time, in which networks live [ns], such as `System::nanoTime`
    /// @param random for the participant's name, which nobody else may have
    /// @param graph hears who is there
    /// @throws IOException when no port is free, or the address is not of this machine
    public UdpParticipant(Options options, LongSupplier clock, RandomGenerator random, GraphListener graph)
            throws IOException {
        this(options, clock, random, graph, options.isLocal() ? LOCAL_FRAGMENT : NETWORK_FRAGMENT, sockets -> sockets);
    }

    /// As the other one, with fragments of another size, and something between the protocol and its sockets,
    /// such as what loses some datagrams.
    ///
    /// @param fragment most of a sample that one datagram has [B], 256 to 65,000
    /// @param link makes it; called for one datagram at a time
    public UdpParticipant(
            Options options,
            LongSupplier clock,
            RandomGenerator random,
            GraphListener graph,
            int fragment,
            UnaryOperator<Transmitter> link)
            throws IOException {
        this.clock = clock;
        isLocal = options.isLocal();
        sockets = Sockets.open(options);
        selector = Selector.open();
        for (DatagramChannel channel : sockets.channels()) {
            channel.configureBlocking(false).register(selector, SelectionKey.OP_READ);
        }
        var prefix = new GuidPrefix((long) VENDOR << 48 | random.nextLong() >>> 16, random.nextInt());
        List<Locator> here = sockets.here().stream().map(Locator::udp).toList();
        var self = new ParticipantData(
                prefix,
                Optional.of(options.domain),
                "",
                BuiltinEndpoint.ALL,
                options.lease.toNanos(),
                here,
                here,
                options.name,
                options.userData);
        participant =
                new Participant(self, fragment, RtpsLimits.DEFAULT, link.apply(sockets), graph, clock.getAsLong());
        thread = Thread.ofPlatform().daemon().name("rtps").start(this::receive);
    }

    public SampleWriter createWriter(String topic, String type, Qos qos, String userData) {
        return locked(() -> {
            SampleWriter writer = participant.createWriter(topic, type, qos, userData, clock.getAsLong());
            writer.onRoom(participant::notifyAll);
            return writer;
        });
    }

    public SampleReader createReader(String topic, String type, Qos qos, String userData, SampleListener listener) {
        return locked(() -> participant.createReader(topic, type, qos, userData, listener, clock.getAsLong()));
    }

    /// Runs what may call listeners, or what is to be sent soon.
    private <T> T locked(Supplier<T> action) {
        synchronized (participant) {
            T result = ScopedValue.where(LOCKED, true).call(action::get);
            wakeUp();
            return result;
        }
    }

    private void locked(Runnable action) {
        synchronized (participant) {
            ScopedValue.where(LOCKED, true).run(action);
            wakeUp();
        }
    }

    /// As the other one, with nothing beside the sample.
    ///
    /// @return whether it was written
    public boolean write(SampleWriter writer, long timestamp, byte[] payload) {
        return write(writer, timestamp, Optional.empty(), payload).isPresent();
    }

    /// Writes a sample. A writer that keeps all and has no room waits for it, for [Qos#MAX_BLOCKING] at most;
    /// in a listener of any participant it does not wait, for what it waits for may have to be received there.
    ///
    /// @param timestamp when the sample is from [ns] since 1970
    /// @param inlineQos writes what goes beside the sample, without an end; at most 128 B
    /// @param payload with its encapsulation header; not changed any more
    /// @return the number of the sample; empty when there was no room, and nothing is written
    public OptionalLong write(
            SampleWriter writer, long timestamp, Optional<Consumer<ParameterList.Writer>> inlineQos, byte[] payload) {
        boolean mayWait = !LOCKED.isBound();
        synchronized (participant) {
            long end = clock.getAsLong() + Qos.MAX_BLOCKING;
            OptionalLong number;
            do {
                number = locked(() -> participant.write(writer, timestamp, inlineQos, payload, clock.getAsLong()));
            } while (number.isEmpty() && mayWait && awaitRoom(end));
            return number;
        }
    }

    /// @return whether to try again
    private boolean awaitRoom(long end) {
        long left = end - clock.getAsLong();
        try {
            TimeUnit.NANOSECONDS.timedWait(participant, left);
            return left > 0 && !isClosed;
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
            return false;
        }
    }

    /// The reader's listener has room again ([SampleListener#hasRoom]). Any thread may say so.
    public void resume(SampleReader reader) {
        locked(() -> participant.resume(reader, clock.getAsLong()));
    }

    /// Writes a sample that one participant waits for, when a reader of it is there and ready; at most 5 s
    /// later.
    public void write(SampleWriter writer, Reply reply) {
        locked(() -> participant.write(writer, reply, clock.getAsLong()));
    }

    /// Readers of other participants that take what a writer writes from now on.
    public List<Guid> readers(SampleWriter writer) {
        synchronized (participant) {
            return writer.readers();
        }
    }

    /// Reliable readers of other participants, each with how many samples of a writer it has not acknowledged.
    public Map<Guid, Long> unacknowledged(SampleWriter writer) {
        synchronized (participant) {
            return writer.unacknowledged();
        }
    }

    /// From whom a reader gets samples.
    public Set<Guid> writers(SampleReader reader) {
        synchronized (participant) {
            return Set.copyOf(reader.writers().keySet());
        }
    }

    public void remove(SampleWriter writer) {
        locked(() -> participant.remove(writer, clock.getAsLong()));
    }

    public void remove(SampleReader reader) {
        locked(() -> participant.remove(reader, clock.getAsLong()));
    }

    /// How many readers a writer has.
    public int matched(SampleWriter writer) {
        synchronized (participant) {
            return writer.matched();
        }
    }

    public List<ParticipantData> participants() {
        synchronized (participant) {
            return List.copyOf(participant.participants());
        }
    }

    public List<EndpointData> endpoints() {
        synchronized (participant) {
            return participant.endpoints();
        }
    }

    /// Whether it hears what is sent to all.
    public boolean hasMulticast() {
        return sockets.hasMulticast();
    }

    /// The newest failure to send or receive, as when a network is down. Nothing ends by it.
    public Optional<IOException> failure() {
        return sockets.failure();
    }

    /// Only if the thread would sleep too long.
    private void wakeUp() {
        if (participant.due() < sleepsUntil) {
            selector.wakeup();
        }
    }

    private void receive() {
        var buffer = ByteBuffer.allocateDirect(MessageWriter.MOST);
        while (!isClosed) {
            try {
                long sleep;
                synchronized (participant) {
                    sleepsUntil = locked(() -> participant.tick(clock.getAsLong()));
                    sleep = sleepsUntil - clock.getAsLong();
                    reportSurplus();
                }
                selector.select(Math.max(1, (sleep + MILLISECOND - 1) / MILLISECOND));
                selector.selectedKeys().clear();
                synchronized (participant) {
                    sleepsUntil = Long.MIN_VALUE; // it is awake
                }
                boolean isMore = true;
                for (int i = 0; i < TURNS && isMore; i++) {
                    isMore = false;
                    for (DatagramChannel channel : sockets.channels()) {
                        isMore |= receive(channel, buffer);
                    }
                }
            } catch (IOException e) {
                sockets.failed(e);
            } catch (RuntimeException e) { // which must not end what others hear
                LOG.log(Level.ERROR, "A listener of samples failed.", e);
            }
        }
    }

    /// Once.
    private void reportSurplus() {
        if (participant.surplus() > 0 && !reportedSurplus) {
            reportedSurplus = true;
            LOG.log(
                    Level.WARNING,
                    "Some participants or topics of others are ignored, and robots may not be found: "
                            + "there are {0} participants at most, with {1} topics and services each and {2} together.",
                    RtpsLimits.DEFAULT.participants(),
                    RtpsLimits.DEFAULT.endpoints(),
                    RtpsLimits.DEFAULT.allEndpoints());
        }
    }

    /// @return whether there may be more
    private boolean receive(DatagramChannel channel, ByteBuffer buffer) throws IOException {
        for (int i = 0; i < AT_ONCE && !isClosed; i++) {
            buffer.clear();
            var from = (InetSocketAddress) channel.receive(buffer);
            if (from == null) {
                return false;
            }
            if (isLocal && !from.getAddress().isLoopbackAddress()) {
                continue; // the group's socket hears other machines, too
            }
            buffer.flip();
            locked(() -> participant.receive(buffer, from, sockets.isGroup(channel), clock.getAsLong()));
        }
        return true;
    }

    /// Tells all others that it leaves, when reliable readers have all samples: at most half a second later.
    @Override
    public void close() {
        if (isClosed) {
            return;
        }
        try {
            awaitReaders();
            isClosed = true;
            selector.wakeup();
            thread.join();
            synchronized (participant) {
                participant.close(clock.getAsLong());
            }
            selector.close();
        } catch (InterruptedException e) {
            isClosed = true;
            Thread.currentThread().interrupt();
        } catch (IOException e) {
            sockets.failed(e);
        }
        sockets.close();
    }

    private void awaitReaders() throws InterruptedException {
        long end = clock.getAsLong() + FAREWELL;
        synchronized (participant) {
            while (!participant.isAcknowledged() && clock.getAsLong() < end) {
                participant.wait(FAREWELL / MILLISECOND / 50);
            }
        }
    }
}
