package rsal.ros2.link;

import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/// What programs of ROS 2 agree on by variables of their environment.
///
/// @param domain `ROS_DOMAIN_ID`, where it is set
/// @param range `ROS_AUTOMATIC_DISCOVERY_RANGE`; where that is not set, `ROS_LOCALHOST_ONLY=1` is [Range#LOCALHOST]
/// @param peers `ROS_STATIC_PEERS`
public record RosEnvironment(Optional<Integer> domain, Range range, List<String> peers) {
    /// Environments that set nothing.
    public static final RosEnvironment NONE = new RosEnvironment(Optional.empty(), Range.NOT_SET, List.of());

    static final String DOMAIN = "ROS_DOMAIN_ID";
    static final String RANGE = "ROS_AUTOMATIC_DISCOVERY_RANGE";
    static final String LOCALHOST_ONLY = "ROS_LOCALHOST_ONLY";
    static final String PEERS = "ROS_STATIC_PEERS";

    /// How far programs look for others.
    public enum Range {
        NOT_SET,

        /// Nowhere.
        OFF,

        /// On this machine.
        LOCALHOST,

        /// In the networks of this machine.
        SUBNET
    }

    public RosEnvironment {
        peers = List.copyOf(peers);
    }

    /// @param variables of a process
    /// @throws IllegalArgumentException when the domain is not a number
    public static RosEnvironment of(Map<String, String> variables) {
        return new RosEnvironment(domain(value(variables, DOMAIN)), range(variables), peers(value(variables, PEERS)));
    }

    private static String value(Map<String, String> variables, String name) {
        return variables.getOrDefault(name, "").strip();
    }

    private static Optional<Integer> domain(String text) {
        try {
            return text.isEmpty() ? Optional.empty() : Optional.of(Integer.valueOf(text));
        } catch (NumberFormatException e) {
            throw new IllegalArgumentException(
                    "%s is '%s', which is not a number. Set one from 0 to 232.".formatted(DOMAIN, text), e);
        }
    }

    /// As rmw reads it: what it does not know is the narrow one.
    private static Range range(Map<String, String> variables) {
        String text = value(variables, RANGE);
        if (text.isEmpty()) {
            return value(variables, LOCALHOST_ONLY).equals("1") ? Range.LOCALHOST : Range.NOT_SET;
        }
        return switch (text) {
            case "OFF" -> Range.OFF;
            case "SUBNET", "SYSTEM_DEFAULT" -> Range.SUBNET;
            default -> Range.LOCALHOST;
        };
    }

    private static List<String> peers(String text) {
        return Arrays.stream(text.split(";", -1))
                .map(String::strip)
                .filter(peer -> !peer.isEmpty())
                .toList();
    }

    /// For people: which variables say something.
    public String words() {
        var words = new StringBuilder();
        domain.ifPresent(number -> words.append("%s=%d ".formatted(DOMAIN, number)));
        if (range != Range.NOT_SET) {
            words.append("discovery %s ".formatted(range));
        }
        if (!peers.isEmpty()) {
            words.append("%s=%s".formatted(PEERS, String.join(";", peers)));
        }
        return words.toString().strip();
    }
}
