package rsal.rtps;

import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.UnknownHostException;
import java.nio.ByteBuffer;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.PriorityQueue;
import java.util.Set;
import java.util.SplittableRandom;
import rsal.rtps.discovery.BuiltinEndpoint;
import rsal.rtps.discovery.ParticipantData;
import rsal.rtps.wire.GuidPrefix;
import rsal.rtps.wire.Locator;

/// Participants on a network of simulated time, which loses, delays, doubles and swaps datagrams as one likes.
final class SimulatedNetwork {
    static final long MILLISECOND = 1_000_000; // ns
    private static final int PORT = 7410;

    private final SplittableRandom random;
    private final double loss;
    private final List<Node> nodes = new ArrayList<>();
    private final PriorityQueue<Flight> flights = new PriorityQueue<>();
    private long now;
    private long sent;
    private int fragmentSize = 1_344;
    private boolean doubles;

    /// A datagram on its way.
    private record Flight(long arrival, long number, Node from, Node to, boolean isToGroup, byte[] bytes)
            implements Comparable<Flight> {
        @Override
        public int compareTo(Flight other) {
            return arrival != other.arrival ? Long.compare(arrival, other.arrival) : Long.compare(number, other.number);
        }
    }

    /// @param loss share of datagrams that get lost
    SimulatedNetwork(long seed, double loss) {
        random = new SplittableRandom(seed);
        this.loss = loss;
    }

    SimulatedNetwork fragments(int size) {
        fragmentSize = size;
        return this;
    }

    /// From now on, some datagrams arrive twice.
    SimulatedNetwork doubling() {
        doubles = true;
        return this;
    }

    /// A participant, and its wire.
    final class Node implements Transmitter {
        final InetSocketAddress address;
        final Participant participant;
        private boolean isUp = true;
        private boolean isMute;
        private boolean hearsGroup = true;

        private Node(int number, int host, RtpsLimits limits, GraphListener graph, Duration lease) {
            address = new InetSocketAddress(host(host), PORT);
            var here = List.of(Locator.udp(address));
            var self = new ParticipantData(
                    new GuidPrefix(0x0152_0000_0000_0000L + number, 7),
                    Optional.of(0),
                    "",
                    BuiltinEndpoint.ALL,
                    lease.toNanos(),
                    here,
                    here,
                    "node " + number,
                    "enclave=/;");
            participant = new Participant(self, fragmentSize, limits, this, graph, now);
        }

        @Override
        public void send(ByteBuffer datagram, InetSocketAddress to) {
            nodes.stream().filter(node -> node.address.equals(to)).forEach(node -> fly(this, node, false, datagram));
        }

        @Override
        public void announce(ByteBuffer datagram, Set<InetSocketAddress> known) {
            for (Node node : nodes) { // multicast comes back to the sender, too
                if (node.hearsGroup) {
                    fly(this, node, true, datagram);
                }
                if (!known.contains(node.address)) {
                    fly(this, node, false, datagram);
                }
            }
        }

        /// It falls silent, and hears nothing.
        void crash() {
            isUp = false;
        }

        /// From now on, nothing that it sends arrives anywhere, or all does.
        void mute(boolean is) {
            isMute = is;
        }

        /// From now on, it hears nothing that others send to the multicast group, as in many wireless networks.
        void ignoreGroup() {
            hearsGroup = false;
        }

        /// @return whether the writer had room
        boolean write(SampleWriter writer, byte[] payload) {
            return participant
                    .write(writer, now, Optional.empty(), payload, now)
                    .isPresent();
        }
    }

    private static InetAddress host(int number) {
        try {
            return InetAddress.getByAddress(new byte[] {10, 0, (byte) (number >> 8), (byte) number});
        } catch (UnknownHostException e) {
            throw new AssertionError(e);
        }
    }

    private void fly(Node from, Node to, boolean isToGroup, ByteBuffer datagram) {
        if (!from.isUp || from.isMute || random.nextDouble() < loss) {
            return;
        }
        var bytes = new byte[datagram.remaining()];
        datagram.duplicate().get(bytes);
        int copies = doubles && random.nextInt(10) == 0 ? 2 : 1;
        for (int i = 0; i < copies; i++) {
            long delay = MILLISECOND / 20 + random.nextLong(loss > 0 ? MILLISECOND : MILLISECOND / 20);
            flights.add(new Flight(now + delay, sent++, from, to, isToGroup, bytes));
        }
    }

    Node join() {
        return join(RtpsLimits.DEFAULT, GraphListener.NONE, Duration.ofSeconds(20));
    }

    Node join(RtpsLimits limits, GraphListener graph, Duration lease) {
        var node = new Node(nodes.size() + 1, nodes.size() + 1, limits, graph, lease);
        nodes.add(node);
        return node;
    }

    /// A participant falls silent, and is there again with its name at another address.
    Node moved(Node node) {
        node.crash();
        var again = new Node(
                nodes.indexOf(node) + 1,
                nodes.size() + 1,
                RtpsLimits.DEFAULT,
                GraphListener.NONE,
                Duration.ofSeconds(20));
        nodes.add(again);
        return again;
    }

    Node node(int number) {
        return nodes.get(number);
    }

    /// Anything at all arrives, as from outside.
    void inject(Node to, byte[] bytes, InetSocketAddress from) {
        to.participant.receive(ByteBuffer.wrap(bytes), from, false, now);
    }

    long now() {
        return now;
    }

    /// How many datagrams were sent and not lost.
    long sent() {
        return sent;
    }

    void run(Duration time) {
        long end = now + time.toNanos();
        while (now < end) {
            long next = end;
            for (Node node : nodes) {
                if (node.isUp) {
                    next = Math.min(next, Math.max(now, node.participant.tick(now)));
                }
            }
            if (!flights.isEmpty()) {
                next = Math.min(next, flights.peek().arrival);
            }
            now = Math.max(now, next);
            while (!flights.isEmpty() && flights.peek().arrival <= now) {
                Flight flight = flights.poll();
                if (flight.to.isUp) {
                    flight.to.participant.receive(
                            ByteBuffer.wrap(flight.bytes), flight.from.address, flight.isToGroup, now);
                }
            }
        }
    }
}
