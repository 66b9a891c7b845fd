package rsal.ros2.rosbridge;

import java.net.URI;
import java.time.Duration;
import java.util.Optional;
import rsal.ros2.type.Distribution;

/// How a server is used.
///
/// @param address of [RosbridgeAddress]
/// @param encoding of messages that it sends
/// @param throttle between two messages of a sensor, at least; zero for all of them
/// @param distribution of ROS 2 whose types it has; empty for what it says
public record RosbridgeOptions(URI address, Encoding encoding, Duration throttle, Optional<Distribution> distribution) {
    /// How a server writes messages.
    public enum Encoding {
        /// CBOR, but JSON for types that servers can't send so.
        CBOR,

        /// JSON, in which infinity and NaN are the same.
        JSON
    }
}
