package rsal.recording;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.util.Map;

/// Where the messages of a run go: a file, or somebody who watches. All are in protobuf. For one thread.
public interface MessageSink {
    /// Opens a channel.
    ///
    /// @param schema name of the kind of its messages, as `foxglove.LaserScan`
    /// @param descriptors of that kind and all that it is made of: a `FileDescriptorSet`
    /// @param about what readers may want to know of the channel
    /// @return its number
    int open(String topic, String schema, byte[] descriptors, Map<String, String> about) throws IOException;

    /// @param channel as [#open] returned it
    /// @param time of the run at which it is told [ns]
    /// @param taken when it was true [ns]
    /// @param message valid until this returns
    void message(int channel, long time, long taken, ByteBuffer message) throws IOException;
}
