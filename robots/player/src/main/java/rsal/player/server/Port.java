package rsal.player.server;

import static java.nio.charset.StandardCharsets.US_ASCII;

import java.io.IOException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import java.util.function.DoubleSupplier;
import rsal.player.message.Interface;
import rsal.player.message.Session;
import rsal.player.wire.Address;
import rsal.player.wire.Kind;
import rsal.player.wire.Packet;

/// A port of a Player server, with its devices and clients. May be used on any thread.
public final class Port implements AutoCloseable {
    private static final int MOST_CLIENTS = 64;
    private static final String VERSION = "Player v.3.1.1-rsal";

    private final ServerSocket listening;
    private final DoubleSupplier time;
    private final int host;
    private final Map<Address, Served> devices = new LinkedHashMap<>(); // by address without host and port
    private final Set<Peer> peers = ConcurrentHashMap.newKeySet();

    /// Listens at once, but takes no clients before it is [started][#start].
    ///
    /// @param at where; port 0 for any that is free
    /// @param time of the server, which its messages carry [s]
    /// @throws IOException when nobody may listen there
    public Port(InetSocketAddress at, List<? extends Served> devices, DoubleSupplier time) throws IOException {
        this.time = time;
        devices.forEach(device -> {
            if (this.devices.put(Address.of(device.interf().code(), device.index()), device) != null) {
                throw new IllegalArgumentException("There are two devices (%s:%d) on port (%d)."
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
                    // that client has gone, or the port is closed
                }
            }
        });
    }

    private void accept(Socket socket) throws IOException {
        if (peers.size() >= MOST_CLIENTS) {
            socket.close();
            return;
        }
        socket.setTcpNoDelay(true);
        var peer = new Peer(socket, this);
        peers.add(peer);
        peer.start();
    }

    public int number() {
        return listening.getLocalPort();
    }

    /// How many clients it has.
    public int clients() {
        return peers.size();
    }

    /// Tells whoever wants it of new data of a device.
    ///
    /// @param at when it was measured, of the server's clock [s]
    public void publish(Served device, int subtype, double at, Record body) {
        if (!peers.isEmpty()) {
            Packet packet = Packet.of(address(device), Kind.DATA, subtype, at, body);
            peers.forEach(peer -> peer.data(device, packet));
        }
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
        return Arrays.copyOf(VERSION.getBytes(US_ASCII), Session.IDENT);
    }

    double time() {
        return time.getAsDouble();
    }

    Address address(Interface interf, int index) {
        return new Address(host, number(), interf.code(), index);
    }

    Address address(Served device) {
        return address(device.interf(), device.index());
    }

    List<Address> addresses() {
        return devices.values().stream().map(this::address).toList();
    }

    /// Whatever host and port a client has written: they are those of its connection.
    Optional<Served> device(Address asked) {
        return Optional.ofNullable(devices.get(Address.of(asked.interf(), asked.index())));
    }

    void remove(Peer peer) {
        peers.remove(peer);
    }
}
