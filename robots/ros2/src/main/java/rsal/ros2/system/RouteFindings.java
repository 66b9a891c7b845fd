package rsal.ros2.system;

import java.net.InetAddress;
import java.util.List;
import java.util.Optional;
import java.util.function.Function;
import rsal.rtps.UdpParticipant;
import rsal.system.Diagnosis.Finding;

/// Which of the machines that are to be searched can be reached, and by which address of this one.
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
        if (route.isEmpty()) {
            return new Finding(
                    "peer",
                    false,
                    "%s can't be reached: no network of this machine leads there".formatted(there),
                    "Connect this machine to that network, or correct 'peers'.");
        }
        String here = route.get().getHostAddress();
        if (!options.addresses().contains(route.get())) {
            return new Finding(
                    "peer",
                    false,
                    "%s is reached by the address %s, not by %s"
                            .formatted(there, here, Ros2Diagnosis.words(options.addresses())),
                    "Add it: --set address=%s".formatted(here));
        }
        return new Finding("peer", true, "%s is reached by the address %s".formatted(there, here), "");
    }
}
