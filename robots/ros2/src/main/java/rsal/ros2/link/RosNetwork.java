package rsal.ros2.link;

import java.io.IOException;
import java.security.SecureRandom;
import java.time.Duration;
import java.util.concurrent.TimeUnit;
import java.util.function.LongSupplier;
import rsal.ros2.type.Distribution;
import rsal.rtps.UdpParticipant;
import rsal.time.AllowedToReadWallClock;

/// What programs of ROS 2 agree on by their environment.
@AllowedToReadWallClock("Networks live in real time.")
public final class RosNetwork {
    /// What participants of ROS 2 say of themselves, without which tools don't list their nodes.
    public static final String ENCLAVE = "enclave=/;";

    /// Within which our participants announce themselves again, or are taken for gone.
    public static final Duration LEASE = Duration.ofSeconds(20);

    private static final String DOMAIN = "ROS_DOMAIN_ID";

    private RosNetwork() {}

    /// Takes part in the network.
    ///
    /// @param node as tools show it
    public static RosLink join(UdpParticipant.Options options, Distribution distribution, String node)
            throws IOException {
        LongSupplier date = () -> TimeUnit.MILLISECONDS.toNanos(System.currentTimeMillis());
        return new RtpsLink(options, distribution, node, System::nanoTime, date, new SecureRandom());
    }

    /// Whether the environment says which domain.
    public static boolean isSet() {
        String set = System.getenv(DOMAIN);
        return set != null && !set.isBlank();
    }

    /// `ROS_DOMAIN_ID`; 0 where that is not set.
    ///
    /// @throws IllegalArgumentException when it is no number
    public static int domain() {
        if (!isSet()) {
            return 0;
        }
        String set = System.getenv(DOMAIN);
        try {
            return Integer.parseInt(set.strip());
        } catch (NumberFormatException e) {
            throw new IllegalArgumentException("%s is '%s', which is no number.".formatted(DOMAIN, set), e);
        }
    }

    /// The namespace of a robot that has none of its own: its id, with `_` for what names of ROS can't have.
    public static String namespace(String robot) {
        String name = robot.replaceAll("[^A-Za-z0-9_]", "_");
        return "/" + (Character.isDigit(name.charAt(0)) ? "_" + name : name);
    }
}
