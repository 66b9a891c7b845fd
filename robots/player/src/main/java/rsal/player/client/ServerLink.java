package rsal.player.client;

import java.io.IOException;
import java.net.InetSocketAddress;
import java.time.Duration;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import org.jspecify.annotations.Nullable;
import rsal.player.wire.Packet;
import rsal.time.AllowedToReadWallClock;

/// Keeps a connection to a server: whenever it is lost, or there is no server yet, it tries again, first after 100 ms,
/// then after twice as long each time, at most 1 s. On a thread of its own.
@AllowedToReadWallClock("It waits for a server, which lives in real time.")
public final class ServerLink implements AutoCloseable {
    private static final Duration PATIENCE = Duration.ofSeconds(1); // with one that does not answer
    private static final Duration FIRST = Duration.ofMillis(100);
    private static final Duration LONGEST = Duration.ofSeconds(1);

    private final String host;
    private final int port;
    private final Delivery delivery;
    private final Listener listener;
    private final CompletableFuture<Void> closed = new CompletableFuture<>();
    private volatile @Nullable Connection current;

    /// What becomes of a link; told on threads of its own.
    public interface Listener {
        /// There is a connection; may take a while, as nothing else comes of the link meanwhile but data.
        ///
        /// @throws IOException when it is of no use, why
        void connected(Connection connection) throws IOException;

        /// There is none any more, or none yet.
        void lost(String reason);

        /// New data, on the thread that reads.
        void data(Packet packet);
    }

    /// Tries nothing before it is [started][#start].
    public ServerLink(String host, int port, Delivery delivery, Listener listener) {
        this.host = host;
        this.port = port;
        this.delivery = delivery;
        this.listener = listener;
    }

    public void start() {
        Thread.ofVirtual().name("player link " + host + ":" + port).start(this::keep);
    }

    private void keep() {
        Duration pause = FIRST;
        while (!closed.isDone()) {
            String reason;
            try (var connection =
                    Connection.open(new InetSocketAddress(host, port), delivery, PATIENCE, listener::data)) {
                current = connection;
                if (closed.isDone()) {
                    return;
                }
                listener.connected(connection);
                pause = FIRST;
                reason = connection.lost().toCompletableFuture().join();
            } catch (IOException e) {
                reason = Connection.reason(e);
            }
            if (closed.isDone()) {
                return;
            }
            listener.lost(reason);
            await(pause);
            pause = pause.multipliedBy(2).compareTo(LONGEST) < 0 ? pause.multipliedBy(2) : LONGEST;
        }
    }

    private void await(Duration pause) {
        try {
            closed.get(pause.toMillis(), TimeUnit.MILLISECONDS);
        } catch (TimeoutException e) {
            // time to try again
        } catch (InterruptedException | ExecutionException e) {
            throw new AssertionError("Nobody interrupts it, and it never fails.", e);
        }
    }

    /// Lets go of the server; what was commanded before still goes out.
    @Override
    public void close() {
        closed.complete(null);
        Connection connection = current;
        if (connection != null) {
            connection.close();
        }
    }
}
