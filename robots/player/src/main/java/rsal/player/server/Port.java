package rsal.player.server;

import static java.nio.charset.StandardCharsets.US_ASCII;

import java.io.IOException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.time.Duration;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.Executor;
import java.util.concurrent.locks.LockSupport;
import java.util.function.DoubleSupplier;
import java.util.function.LongSupplier;
import rsal.player.message.Interface;
import rsal.player.message.Protocol;
import rsal.player.message.Session;
import rsal.player.wire.Address;
import rsal.time.AllowedToReadWallClock;

/// A port of a Player server, with its devices and clients. When there are as many as it serves, a new one
/// takes the place of who has said nothing for longest and uses no device, or else only looks. Who has
/// commanded a device keeps its place. May be used on any thread.
@AllowedToReadWallClock("It waits for clients, which live in real time.")
public final class Port implements AutoCloseable {
    private static final int MOST_CLIENTS = 64;
    private static final Duration IDLE = Duration.ofSeconds(1); // then others may have its place
    private static final Duration BREATH = Duration.ofMillis(100); // before a new try, when none can be taken

    private final ServerSocket listening;
    private final Protocol protocol;
    private final DoubleSupplier time;
    private final LongSupplier clock; // real time [ns]
    private final Executor afterwards;
    private final int host;
    private final Map<Address, ServedDevice> devices = new LinkedHashMap<>(); // by address without host and port
    private final Set<Peer> peers = ConcurrentHashMap.newKeySet();
    private final Map<ServedDevice, Peer> commanders = new ConcurrentHashMap<>(); // who commanded last
    private final List<DeviceData> unsent = new ArrayList<>(); // not sent yet; guarded by itself

    /// Listens at once, but takes no clients before it is [started][#start].
    ///
    /// @param at where; port 0 for any that is free
    /// @param protocol of clients that don't show another
    /// @param time of the server, which its messages carry [s]
    /// @param clock of real time, in which clients live [ns], such as `System::nanoTime`
    /// @param afterwards runs what is to be done once the task that publishes something is over
    /// @throws IOException when nobody may listen there
    public Port(
            InetSocketAddress at,
            List<? extends ServedDevice> devices,
            Protocol protocol,
            DoubleSupplier time,
            LongSupplier clock,
            Executor afterwards)
            throws IOException {
        this.protocol = protocol;
        this.time = time;
        this.clock = clock;
        this.afterwards = afterwards;
        devices.forEach(device -> {
            if (this.devices.put(Address.of(device.interf().code(), device.index()), device) != null) {
                throw new IllegalArgumentException("There are two devices '%s:%d' on port '%d'."
                        .formatted(device.interf().word(), device.index(), at.getPort()));
            }
        });
        this.listening = new ServerSocket();
        listening.bind(at);
        this.host = packed(listening.getInetAddress());
    }

    /// As Player on a processor with its low bytes first sends it.
    private static int packed(InetAddress address) {
        byte[] bytes = address.isAnyLocalAddress() || address.getAddress().length != 4
                ? new byte[] {127, 0, 0, 1}
                : address.getAddress();
        return ByteBuffer.wrap(bytes).order(ByteOrder.LITTLE_ENDIAN).getInt();
    }

    public void start() {
        Thread.ofVirtual().name("player port " + number()).start(() -> {
            while (!listening.isClosed()) {
                try {
                    accept(listening.accept());
                } catch (IOException e) {
                    // the port is closed, that client has gone, or there are no more descriptors of files
                    LockSupport.parkNanos(BREATH.toNanos());
                }
            }
        });
    }

    private void accept(Socket socket) throws IOException {
        if (peers.size() >= MOST_CLIENTS && !makeRoom()) {
            socket.close();
            return;
        }
        socket.setTcpNoDelay(true);
        var peer = new Peer(socket, this);
        peers.add(peer);
        if (listening.isClosed()) { // a virtual thread accepts once more while the socket is closed
            peer.end();
            return;
        }
        peer.start();
    }

    private boolean makeRoom() {
        long now = now();
        Optional<Peer> idle = peers.stream()
                .filter(peer -> !peer.commands() && peer.silence(now) > IDLE.toNanos())
                .max(Comparator.comparing((Peer peer) -> !peer.uses()).thenComparingLong(peer -> peer.silence(now)));
        idle.ifPresent(Peer::end);
        return idle.isPresent();
    }

    public int number() {
        return listening.getLocalPort();
    }

    /// How many clients it has.
    public int clients() {
        return peers.size();
    }

    /// Tells those that want it of new data of a device, together with all else that the same task publishes:
    /// clients get in one round what was measured in one step.
    ///
    /// @param at when it was measured, of the server's clock [s]
    /// @param body in the words of the newest version
    public void publish(ServedDevice device, int subtype, double at, Record body) {
        if (peers.isEmpty()) {
            return;
        }
        boolean first;
        synchronized (unsent) {
            first = unsent.isEmpty();
            unsent.add(new DeviceData(device, address(device), subtype, at, body));
        }
        if (first) {
            afterwards.execute(this::publish);
        }
    }

    private void publish() {
        List<DeviceData> reported;
        synchronized (unsent) {
            reported = List.copyOf(unsent);
            unsent.clear();
        }
        peers.forEach(peer -> peer.data(reported));
    }

    /// Whether a client that pulls has yet to ask for what there is; not one that has not asked for a second.
    public boolean isBehind() {
        return peers.stream().anyMatch(Peer::isBehind);
    }

    @Override
    public void close() {
        try {
            listening.close();
        } catch (IOException e) {
            // nobody listens any more either way
        }
        peers.forEach(Peer::end);
    }

    byte[] ident() {
        return Arrays.copyOf("Player v.%s-rsal".formatted(protocol.version()).getBytes(US_ASCII), Session.IDENT);
    }

    Protocol protocol() {
        return protocol;
    }

    /// Real time [ns], of which only differences mean something.
    long now() {
        return clock.getAsLong();
    }

    double time() {
        return time.getAsDouble();
    }

    Address address(Interface interf, int index) {
        return new Address(host, number(), interf.code(), index);
    }

    Address address(ServedDevice device) {
        return address(device.interf(), device.index());
    }

    List<Address> addresses() {
        return devices.values().stream().map(this::address).toList();
    }

    /// Whatever host and port a client has written: they are those of its connection.
    Optional<ServedDevice> device(Address asked) {
        return Optional.ofNullable(devices.get(Address.of(asked.interf(), asked.index())));
    }

    /// A client commands a device.
    void commands(Peer peer, ServedDevice device) {
        commanders.put(device, peer);
    }

    /// A client that has commanded a device gives it back, or is gone.
    void givesBack(Peer peer, ServedDevice device) {
        if (commanders.remove(device, peer)) {
            device.forsaken();
        }
        device.close();
    }

    void remove(Peer peer) {
        peers.remove(peer);
    }
}
