package rsal.ros2.link;

import java.util.Map;

/// Takes messages of topics: a network, or a recording.
public interface RosPublisher {
    /// A topic that we publish.
    Publication advertise(RosTopic topic, Profile profile);

    /// A topic that we publish.
    interface Publication extends AutoCloseable {
        /// @param message in CDR, with its encapsulation header; not changed any more
        void publish(byte[] message);

        /// Reliable subscribers by their ids, each with how many messages it has not acknowledged; empty where the
        /// link does not know.
        default Map<String, Long> unacknowledged() {
            return Map.of();
        }

        @Override
        void close();
    }
}
