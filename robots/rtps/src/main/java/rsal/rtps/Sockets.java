package rsal.rtps;

import java.io.IOException;
import java.net.BindException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.InterfaceAddress;
import java.net.NetworkInterface;
import java.net.StandardProtocolFamily;
import java.net.StandardSocketOptions;
import java.nio.ByteBuffer;
import java.nio.channels.DatagramChannel;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.jspecify.annotations.Nullable;
import rsal.rtps.UdpParticipant.Options;

/// The sockets of a participant: one in each of its networks for all that is for it alone, and one that hears the
/// multicast group in all of them.
final class Sockets implements Transmitter, AutoCloseable {
    private static final String GROUP = "239.255.0.1";
    private static final int BUFFER = 4 << 20; // B; the system may give less
    private static final int PEERS = 33; // participants of one machine that are looked for

    private final List<Way> ways;
    private final Optional<DatagramChannel> group;
    private final List<DatagramChannel> channels;
    private final InetSocketAddress everybody;
    private final List<InetSocketAddress> peers;
    private volatile @Nullable IOException failure; // the newest

    /// Into one network.
    ///
    /// @param network address of the machine there, with the length of the network's prefix
    private record Way(DatagramChannel channel, InterfaceAddress network) {
        InetSocketAddress here() {
            try {
                return (InetSocketAddress) channel.getLocalAddress();
            } catch (IOException e) {
                throw new IllegalStateException("A socket that is bound has no address.", e);
            }
        }

        /// How well it leads there: the bits that addresses of its network have in common, or 0.
        int fit(InetAddress address) {
            int bits = network.getNetworkPrefixLength();
            int differing = number(address) ^ number(network.getAddress());
            return bits > 0 && differing >>> (Integer.SIZE - bits) == 0 ? bits : 0;
        }

        private static int number(InetAddress address) {
            return ByteBuffer.wrap(address.getAddress()).getInt();
        }
    }

    private Sockets(
            List<Way> ways,
            Optional<DatagramChannel> group,
            InetSocketAddress everybody,
            List<InetSocketAddress> peers) {
        this.ways = List.copyOf(ways);
        this.group = group;
        channels =
                Stream.concat(ways.stream().map(Way::channel), group.stream()).toList();
        this.everybody = everybody;
        this.peers = List.copyOf(peers);
    }

    /// @throws IOException when no port is free, or an address is not of this machine
    static Sockets open(Options options) throws IOException {
        var ways = new ArrayList<Way>();
        try {
            var networks = new ArrayList<NetworkInterface>();
            for (InetAddress address : options.addresses()) {
                NetworkInterface network = NetworkInterface.getByInetAddress(address);
                if (network == null) {
                    throw new BindException("This machine has no address %s. Write one of its own."
                            .formatted(address.getHostAddress()));
                }
                networks.add(network);
                ways.add(way(options, address, network));
            }
            List<InetSocketAddress> peers = Stream.concat(
                            options.peers().stream(), Stream.of(InetAddress.getLoopbackAddress()))
                    .flatMap(peer -> IntStream.range(0, PEERS)
                            .mapToObj(i -> new InetSocketAddress(peer, DomainPorts.unicast(options.domain(), i))))
                    .toList();
            var everybody = new InetSocketAddress(GROUP, DomainPorts.multicast(options.domain()));
            return new Sockets(ways, join(everybody, networks), everybody, peers);
        } catch (IOException | RuntimeException e) {
            for (Way way : ways) {
                way.channel.close();
            }
            throw e;
        }
    }

    private static Way way(Options options, InetAddress address, NetworkInterface network) throws IOException {
        DatagramChannel channel = DatagramChannel.open(StandardProtocolFamily.INET);
        try {
            channel.setOption(StandardSocketOptions.SO_RCVBUF, BUFFER);
            channel.setOption(StandardSocketOptions.SO_SNDBUF, BUFFER);
            channel.setOption(StandardSocketOptions.IP_MULTICAST_IF, network);
            channel.setOption(StandardSocketOptions.IP_MULTICAST_LOOP, true);
            bind(channel, address, options.domain());
            InterfaceAddress its = network.getInterfaceAddresses().stream()
                    .filter(each -> each.getAddress().equals(address))
                    .findFirst()
                    .orElseThrow();
            return new Way(channel, its);
        } catch (IOException | RuntimeException e) {
            channel.close();
            throw e;
        }
    }

    /// To the first port that is free, so that others on this machine find it without multicast.
    private static void bind(DatagramChannel channel, InetAddress address, int domain) throws IOException {
        for (int i = 0; i < DomainPorts.PARTICIPANTS; i++) {
            try {
                channel.bind(new InetSocketAddress(address, DomainPorts.unicast(domain, i)));
                return;
            } catch (BindException e) {
                // somebody else's; the next one may be free
            }
        }
        channel.bind(new InetSocketAddress(address, 0));
    }

    /// @return empty where no network has multicast
    private static Optional<DatagramChannel> join(InetSocketAddress everybody, List<NetworkInterface> networks)
            throws IOException {
        DatagramChannel group = DatagramChannel.open(StandardProtocolFamily.INET);
        int joined = 0;
        try {
            group.setOption(StandardSocketOptions.SO_REUSEADDR, true);
            if (group.supportedOptions().contains(StandardSocketOptions.SO_REUSEPORT)) {
                group.setOption(StandardSocketOptions.SO_REUSEPORT, true);
            }
            bindGroup(group, everybody.getPort());
            for (NetworkInterface network : networks) {
                joined += isJoined(group, everybody.getAddress(), network) ? 1 : 0;
            }
        } finally {
            if (joined == 0) {
                group.close();
            }
        }
        return joined > 0 ? Optional.of(group) : Optional.empty();
    }

    private static void bindGroup(DatagramChannel group, int port) throws IOException {
        try {
            group.bind(new InetSocketAddress(port));
        } catch (BindException e) {
            throw new BindException("UDP port %d is used by a program that does not share it.".formatted(port));
        }
    }

    private static boolean isJoined(DatagramChannel channel, InetAddress group, NetworkInterface network) {
        try {
            channel.join(group, network);
            return true;
        } catch (IOException e) {
            return false; // it has no multicast
        }
    }

    List<DatagramChannel> channels() {
        return channels;
    }

    /// Whether this is the socket of the multicast group.
    boolean isGroup(DatagramChannel channel) {
        return group.filter(channel::equals).isPresent();
    }

    /// Where it receives what is for it alone.
    List<InetSocketAddress> here() {
        return ways.stream().map(Way::here).toList();
    }

    boolean hasMulticast() {
        return group.isPresent();
    }

    Optional<IOException> failure() {
        return Optional.ofNullable(failure);
    }

    void failed(IOException e) {
        failure = e;
    }

    /// By the network that the address is in, or by the first one.
    @Override
    public void send(ByteBuffer datagram, InetSocketAddress to) {
        Way best = ways.getFirst();
        int fit = 0;
        for (int i = 0; i < ways.size() && ways.size() > 1; i++) {
            int other = ways.get(i).fit(to.getAddress());
            if (other > fit) {
                best = ways.get(i);
                fit = other;
            }
        }
        send(datagram, to, best);
    }

    private void send(ByteBuffer datagram, InetSocketAddress to, Way way) {
        try {
            way.channel.send(datagram.duplicate(), to);
        } catch (IOException e) {
            failed(e); // as one that is lost on the way
        }
    }

    @Override
    public void announce(ByteBuffer datagram, Set<InetSocketAddress> known) {
        ways.forEach(way -> send(datagram, everybody, way));
        for (InetSocketAddress to : peers) {
            if (group.isEmpty() || !known.contains(to)) {
                send(datagram, to);
            }
        }
    }

    @Override
    public void close() {
        for (DatagramChannel channel : channels()) {
            try {
                channel.close();
            } catch (IOException e) {
                failed(e);
            }
        }
    }
}
