package rsal.ros2.link;

import java.nio.ByteBuffer;
import java.util.List;
import java.util.function.Consumer;

/// How this program takes part in ROS 2. Messages are bytes in CDR, with their encapsulation header. Safe for several
/// threads.
public interface RosLink extends AutoCloseable {
    /// All that others publish and subscribe to.
    List<RosEndpoint> endpoints();

    Publication advertise(RosTopic topic, Profile profile);

    /// @param listener gets each message, on a thread of the link: be quick. The bytes are valid during the call only.
    Subscribed subscribe(RosTopic topic, Profile profile, Consumer<ByteBuffer> listener);

    @Override
    void close();

    /// A topic that we publish.
    interface Publication extends AutoCloseable {
        /// @param time of the message [ns] since 1970
        /// @param message not changed any more
        void publish(long time, byte[] message);

        @Override
        void close();
    }

    /// A topic that we hear.
    interface Subscribed extends AutoCloseable {
        /// How many publish it now.
        int publishers();

        @Override
        void close();
    }
}
