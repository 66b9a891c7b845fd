package rsal.ros2.link;

import java.io.IOException;
import java.net.DatagramSocket;
import java.net.Inet4Address;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.NetworkInterface;
import java.net.SocketException;
import java.net.UnknownHostException;
import java.security.SecureRandom;
import java.time.Duration;
import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.TimeUnit;
import java.util.function.LongSupplier;
import rsal.ros2.link.RosEnvironment.Range;
import rsal.ros2.type.Distribution;
import rsal.rtps.UdpParticipant;
import rsal.time.AllowedToReadWallClock;

/// The network on which programs of ROS 2 find each other: which addresses of this machine take part in it.
@AllowedToReadWallClock("Networks live in real time.")
public final class RosNetwork {
    /// What participants of ROS 2 say of themselves, without which tools don't list their nodes.
    private static final String ENCLAVE = "enclave=/;";

    /// Within which our participants announce themselves again, or are taken for gone.
    private static final Duration LEASE = Duration.ofSeconds(20);

    private static final int ANY_PORT = 7400; // of those that only show the way

    private RosNetwork() {}

    public static RosEnvironment environment() {
        return RosEnvironment.of(System.getenv());
    }

    /// Takes part in the network.
    ///
    /// @param options as of [#options]
    /// @param node as tools show it
    public static RosLink join(UdpParticipant.Options options, Distribution distribution, String node)
            throws IOException {
        LongSupplier date = () -> TimeUnit.MILLISECONDS.toNanos(System.currentTimeMillis());
        return new RtpsLink(options, distribution, node, System::nanoTime, date, new SecureRandom());
    }

    /// @param domain 0 to 232
    /// @param addresses of this machine; 0.0.0.0 for all of them; none for those that the environment and the peers
    ///     need: loopback where they say nothing
    /// @param peers names or addresses of other machines, beside those of the environment
    /// @param node as tools show it
    /// @throws IllegalArgumentException when a machine is not known, or the environment forbids discovery
    public static UdpParticipant.Options options(
            int domain, List<InetAddress> addresses, List<String> peers, RosEnvironment environment, String node) {
        if (environment.range() == Range.OFF) {
            throw new IllegalArgumentException(
                    "%s is OFF, so nobody is found. Set LOCALHOST or SUBNET.".formatted(RosEnvironment.RANGE));
        }
        var machines = new ArrayList<InetAddress>();
        for (String peer : peers) {
            machines.add(machine("peers", peer));
        }
        for (String peer : environment.peers()) {
            machines.add(machine(RosEnvironment.PEERS, peer));
        }
        Set<InetAddress> here = new LinkedHashSet<>();
        for (InetAddress address : addresses) {
            here.addAll(address.isAnyLocalAddress() ? all() : List.of(address));
        }
        if (addresses.isEmpty()) {
            here.addAll(needed(environment.range(), machines));
        }
        return new UdpParticipant.Options(domain, List.copyOf(here), machines, LEASE, node, ENCLAVE);
    }

    /// @param setting that names it
    public static InetAddress machine(String setting, String name) {
        try {
            return InetAddress.getByName(name);
        } catch (UnknownHostException e) {
            throw new IllegalArgumentException("'%s' has no machine called '%s'.".formatted(setting, name), e);
        }
    }

    /// The narrowest that reach whom they should.
    private static Set<InetAddress> needed(Range range, List<InetAddress> peers) {
        Set<InetAddress> needed = new LinkedHashSet<>();
        if (range == Range.SUBNET) {
            needed.addAll(all());
        } else if (range == Range.NOT_SET) {
            peers.stream()
                    .flatMap(peer -> route(peer).stream())
                    .filter(address -> !address.isAnyLocalAddress())
                    .forEach(needed::add);
        }
        return needed.isEmpty() ? Set.of(InetAddress.getLoopbackAddress()) : needed;
    }

    /// The address of this machine by which it reaches another one; empty when no network leads there.
    /// Nothing is sent.
    public static Optional<InetAddress> route(InetAddress peer) {
        try (var socket = new DatagramSocket()) {
            socket.connect(new InetSocketAddress(peer, ANY_PORT));
            return Optional.of(socket.getLocalAddress());
        } catch (IOException e) {
            return Optional.empty();
        }
    }

    /// Those of this machine in networks that others may be in, and on loopback where it has no other.
    public static List<InetAddress> all() {
        try {
            List<InetAddress> all = NetworkInterface.networkInterfaces()
                    .filter(RosNetwork::isUp)
                    .flatMap(NetworkInterface::inetAddresses)
                    .filter(address -> address instanceof Inet4Address && !address.isLoopbackAddress())
                    .toList();
            return all.isEmpty() ? List.of(InetAddress.getLoopbackAddress()) : all;
        } catch (SocketException e) {
            return List.of(InetAddress.getLoopbackAddress());
        }
    }

    private static boolean isUp(NetworkInterface network) {
        try {
            return network.isUp();
        } catch (SocketException e) {
            return false;
        }
    }

    /// The namespace of a robot that has none of its own: its id, with `_` for what names of ROS can't have.
    public static String namespace(String robot) {
        String name = robot.replaceAll("[^A-Za-z0-9_]", "_");
        return "/" + (Character.isDigit(name.charAt(0)) ? "_" + name : name);
    }
}
