package rsal.mcap;

import java.io.IOException;
import java.nio.ByteBuffer;

/// Sees messages, one after the other.
public interface MessageVisitor {
    /// @param sequence number of the message in its channel, as its writer counted
    /// @param logTime by which it was found, in ns
    /// @param publishTime when it was true, in ns
    /// @param data valid until this returns
    void message(Channel channel, long sequence, long logTime, long publishTime, ByteBuffer data) throws IOException;
}
