package rsal.ros2.rosbridge;

import java.nio.ByteBuffer;
import java.util.concurrent.CompletionStage;

/// How messages of rosbridge come and go: WebSocket, or a test's memory. Safe for several threads.
public interface RosbridgeTransport extends AutoCloseable {
    /// Largest message that is taken [B]: a map of 8,000 × 8,000 cells in CBOR, or half as wide and high in JSON.
    int MOST_BYTES = 64 << 20;

    /// Opens a connection.
    ///
    /// @param receiver gets what the server sends, one after the other, on a thread of the transport
    /// @return exceptionally when there is no server; its message says why, for people
    CompletionStage<Connection> open(Receiver receiver);

    @Override
    void close();

    /// A connection that is open.
    interface Connection {
        /// Sends a message, behind those that wait. One of the same key that still waits is replaced: where the
        /// network is slow, the newest commands stay.
        ///
        /// @param key unique for what must not be replaced
        void send(String key, String message);

        /// Ends it when all that waits is sent, but soon; the caller waits for that. The receiver hears nothing
        /// more.
        void close();

        /// Ends it at once, whatever waits to be sent. The receiver hears nothing more.
        void abort();
    }

    /// What comes from the server.
    interface Receiver {
        void onText(String message);

        /// @param message valid during the call only
        void onBinary(ByteBuffer message);

        /// The server, the network or the transport ended the connection. Comes once at most.
        ///
        /// @param why for people
        void onClosed(String why);
    }
}
