package rsal.ros2.bag;

import java.io.Closeable;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.util.List;
import java.util.function.Predicate;

/// One file of a bag, whatever stores it.
interface BagFile extends Closeable {
    /// @param type in full, `sensor_msgs/msg/LaserScan`
    /// @param definition of the type with those within (`ros2msg`); empty where the file has none
    record Topic(String name, String type, String definition) {}

    /// Takes messages.
    @FunctionalInterface
    interface Visitor {
        /// @param data as stored, perhaps compressed; valid until this returns
        void message(Topic topic, ByteBuffer data) throws IOException;
    }

    /// Each may be there several times, as when a publisher came again.
    List<Topic> topics();

    /// How many messages all topics have that are equal to this one.
    long count(Topic topic);

    /// Reads messages in the order of their arrival.
    void read(Predicate<Topic> wanted, Visitor visitor) throws IOException;

    /// What is wrong with the file and lost, a sentence each, as far as it was found yet.
    List<String> damage();
}
