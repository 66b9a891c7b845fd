package rsal.ros2.link;

/// Takes messages of topics: a network, or a recording.
public interface RosPublisher {
    /// A topic that we publish.
    Publication advertise(RosTopic topic, Profile profile);

    /// A topic that we publish.
    interface Publication extends AutoCloseable {
        /// @param message in CDR, with its encapsulation header; not changed any more
        void publish(byte[] message);

        @Override
        void close();
    }
}
