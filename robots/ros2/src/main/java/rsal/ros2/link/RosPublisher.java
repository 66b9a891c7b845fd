package rsal.ros2.link;

/// Takes messages of topics: a network, or a recording.
public interface RosPublisher {
    /// A topic that we publish.
    Publication advertise(RosTopic topic, Profile profile);

    /// A topic that we publish.
    interface Publication extends AutoCloseable {
        /// @param time of the message [ns] since 1970
        /// @param message in CDR, with its encapsulation header; not changed any more
        void publish(long time, byte[] message);

        @Override
        void close();
    }
}
