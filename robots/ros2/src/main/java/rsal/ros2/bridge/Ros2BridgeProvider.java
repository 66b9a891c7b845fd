package rsal.ros2.bridge;

import java.io.IOException;
import java.net.InetSocketAddress;
import java.util.List;
import rsal.ros2.link.RosNetwork;
import rsal.ros2.type.Distribution;
import rsal.rtps.DomainPorts;
import rsal.rtps.UdpParticipant;
import rsal.system.Bridge;
import rsal.system.BridgeContext;
import rsal.system.BridgeProvider;
import rsal.time.Scheduler;

/// Publishes robots to ROS 2, each in its namespace. The port says which domain: that where its participants
/// hear of each other.
public final class Ros2BridgeProvider implements BridgeProvider {
    @Override
    public String key() {
        return "ros2";
    }

    @Override
    public String description() {
        return "Publishes robots to programs of ROS 2, such as RViz, and takes their velocities (DDS).";
    }

    /// That of the domain in `ROS_DOMAIN_ID`, or of 0.
    @Override
    public int defaultPort() {
        return DomainPorts.multicast(RosNetwork.environment().domain().orElse(0));
    }

    @Override
    public String portRemedy() {
        return "Choose another domain D by the variable ROS_DOMAIN_ID, or by --port with 7400 + 250 · D."
                + " 'ss -lunp' shows which programs use the ports.";
    }

    /// By `/clock_reached`, or by reliable subscriptions of `/clock`.
    @Override
    public boolean canPace() {
        return true;
    }

    @Override
    public Bridge open(InetSocketAddress at, BridgeContext context, Scheduler scheduler) throws IOException {
        int domain = DomainPorts.domain(at.getPort())
                .orElseThrow(
                        () -> new IOException("No domain of ROS 2 has the port %d: that of domain D is 7400 + 250 · D."
                                .formatted(at.getPort())));
        UdpParticipant.Options options;
        try {
            options = RosNetwork.options(
                    domain, List.of(at.getAddress()), List.of(), RosNetwork.environment(), Ros2Bridge.NODE);
        } catch (IllegalArgumentException e) {
            throw new IOException(e.getMessage(), e);
        }
        return new Ros2Bridge(
                RosNetwork.join(options, Distribution.JAZZY, Ros2Bridge.NODE), context, at.getPort(), scheduler);
    }
}
