package rsal.ros2.rosbridge;

import java.io.ByteArrayOutputStream;
import java.net.ConnectException;
import java.net.URI;
import java.net.http.HttpClient;
import java.net.http.HttpConnectTimeoutException;
import java.net.http.WebSocket;
import java.net.http.WebSocketHandshakeException;
import java.nio.ByteBuffer;
import java.nio.channels.UnresolvedAddressException;
import java.time.Duration;
import java.util.concurrent.CompletionException;
import java.util.concurrent.CompletionStage;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.atomic.AtomicBoolean;
import javax.net.ssl.SSLException;
import org.jspecify.annotations.Nullable;

/// Connections to a server by WebSocket. `wss://` uses the certificates that the JVM trusts.
public final class WebSocketTransport implements RosbridgeTransport {
    private static final Duration PATIENCE = Duration.ofSeconds(5); // for a connection

    private final URI address;
    private final ExecutorService threads = Executors.newThreadPerTaskExecutor(
            Thread.ofVirtual().name("ros2-io-", 0).factory());
    private final HttpClient client =
            HttpClient.newBuilder().connectTimeout(PATIENCE).executor(threads).build();

    /// @param address of [RosbridgeAddress]
    public WebSocketTransport(URI address) {
        this.address = address;
    }

    @Override
    public CompletionStage<Connection> open(Receiver receiver) {
        var listener = new Incoming(receiver);
        return client.newWebSocketBuilder()
                .connectTimeout(PATIENCE)
                .buildAsync(address, listener)
                .handle((socket, error) -> {
                    if (error != null) {
                        throw new CompletionException(new java.io.IOException(why(error), error));
                    }
                    return new WebSocketOutbox(socket, threads, listener::end);
                });
    }

    private static String why(Throwable error) {
        Throwable cause = error;
        while (cause.getCause() != null
                && !(cause instanceof WebSocketHandshakeException
                        || cause instanceof SSLException
                        || isRefused(cause))) {
            cause = cause.getCause();
        }
        return switch (cause) {
            case UnresolvedAddressException _ -> "this machine's name is not known";
            case HttpConnectTimeoutException _ -> "it does not answer within %d s".formatted(PATIENCE.toSeconds());
            case ConnectException _ -> "nobody listens there";
            case WebSocketHandshakeException refused ->
                "it is not a WebSocket server (HTTP %d)"
                        .formatted(refused.getResponse().statusCode());
            case SSLException e -> "TLS failed, maybe this Java does not trust its certificate: " + e.getMessage();
            default ->
                cause.getMessage() == null ? cause.getClass().getSimpleName() : String.valueOf(cause.getMessage());
        };
    }

    /// A connection that takes too long is another kind of it, and unknown names are its cause.
    private static boolean isRefused(Throwable error) {
        return error instanceof ConnectException && !(error.getCause() instanceof UnresolvedAddressException);
    }

    @Override
    public void close() {
        client.shutdownNow();
        threads.shutdown();
    }

    /// Puts together what comes in parts.
    private static final class Incoming implements WebSocket.Listener {
        private final Receiver receiver;
        private final AtomicBoolean isEnded = new AtomicBoolean();
        private StringBuilder text = new StringBuilder();
        private ByteArrayOutputStream bytes = new ByteArrayOutputStream();

        Incoming(Receiver receiver) {
            this.receiver = receiver;
        }

        @Override
        public @Nullable CompletionStage<?> onText(WebSocket socket, CharSequence part, boolean isLast) {
            if (isTooLarge(socket, text.length() + part.length())) {
                return null;
            }
            text.append(part);
            if (isLast) {
                String message = text.toString();
                text = new StringBuilder(); // not kept as large as the largest message was
                if (!isEnded.get()) {
                    receiver.onText(message);
                }
            }
            socket.request(1);
            return null;
        }

        @Override
        public @Nullable CompletionStage<?> onBinary(WebSocket socket, ByteBuffer part, boolean isLast) {
            if (isTooLarge(socket, bytes.size() + part.remaining())) {
                return null;
            }
            var some = new byte[part.remaining()];
            part.get(some);
            if (isLast && bytes.size() == 0) {
                receive(ByteBuffer.wrap(some));
            } else {
                bytes.writeBytes(some);
                if (isLast) {
                    receive(ByteBuffer.wrap(bytes.toByteArray()));
                    bytes = new ByteArrayOutputStream();
                }
            }
            socket.request(1);
            return null;
        }

        private void receive(ByteBuffer message) {
            if (!isEnded.get()) {
                receiver.onBinary(message);
            }
        }

        private boolean isTooLarge(WebSocket socket, long size) {
            if (size <= MOST_BYTES) {
                return false;
            }
            socket.abort();
            end("it sent a message of more than %d MiB".formatted(MOST_BYTES >> 20));
            return true;
        }

        @Override
        public @Nullable CompletionStage<?> onClose(WebSocket socket, int code, String reason) {
            end("it closed the connection (%d%s)".formatted(code, reason.isEmpty() ? "" : ": " + reason));
            return null;
        }

        @Override
        public void onError(WebSocket socket, Throwable error) {
            end(why(error));
        }

        /// Nothing more is heard.
        ///
        /// @param why empty where nobody needs to know
        void end(String why) {
            if (isEnded.compareAndSet(false, true) && !why.isEmpty()) {
                receiver.onClosed(why);
            }
        }
    }
}
