package rsal.ros2.system;

import java.net.InetAddress;
import java.util.List;
import java.util.Optional;
import java.util.function.Function;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import rsal.rtps.UdpParticipant;
import rsal.system.Diagnosis.Finding;

/// Which of the machines that are to be searched have a route, and at which address of this one it begins.
/// Whether anybody is there is not known: nothing is sent.
final class RouteFindings {
    private RouteFindings() {}

    /// @param route the address of this machine by which it reaches another one; empty for no route
    static List<Finding> of(UdpParticipant.Options options, Function<InetAddress, Optional<InetAddress>> route) {
        return options.peers().stream()
                .map(peer -> of(peer, options, route.apply(peer)))
                .toList();
    }

    private static Finding of(InetAddress peer, UdpParticipant.Options options, Optional<InetAddress> route) {
        String there = peer.getHostAddress();
        if (peer.isLoopbackAddress()) {
            return new Finding("peer", true, "%s is this machine".formatted(there), "");
        }
        Optional<InetAddress> begin = route.filter(address -> !address.isAnyLocalAddress());
        if (begin.isEmpty()) {
            return new Finding(
                    "peer",
                    false,
                    "%s can't be reached: no network of this machine leads there".formatted(there),
                    "Connect this machine to that network, or correct 'peers'.");
        }
        String here = begin.get().getHostAddress();
        List<InetAddress> ours = options.addresses();
        if (!ours.contains(begin.get())) {
            String all = Stream.concat(ours.stream(), begin.stream())
                    .map(InetAddress::getHostAddress)
                    .collect(Collectors.joining(","));
            return new Finding(
                    "peer",
                    false,
                    "the route to %s begins at %s, not at %s".formatted(there, here, Ros2Diagnosis.words(ours)),
                    "Add that address: --set address=%s".formatted(all));
        }
        return new Finding("peer", true, "the route to %s begins at %s; nothing was sent".formatted(there, here), "");
    }
}
