package rsal.ros2.rosbridge;

import java.net.http.WebSocket;
import java.util.Iterator;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.Executor;
import java.util.concurrent.TimeUnit;
import java.util.function.Consumer;
import org.jspecify.annotations.Nullable;
import rsal.ros2.rosbridge.RosbridgeTransport.Connection;
import rsal.time.AllowedToReadWallClock;

/// What waits to be sent by a WebSocket, one at a time. Safe for several threads.
@AllowedToReadWallClock("Networks live in real time.")
final class WebSocketOutbox implements Connection {
    private static final int MOST_WAITING = 10_000; // messages
    private static final long LAST_WORDS = 1_000; // [ms] for what waits when it is closed

    private final WebSocket socket;
    private final Executor threads;
    private final Consumer<String> onEnd;
    private final Map<String, String> waiting = new LinkedHashMap<>();
    private final CountDownLatch allSent = new CountDownLatch(1); // and nothing more comes
    private boolean isSending;
    private boolean isClosed;

    /// @param onEnd hears why nothing can be sent any more; an empty text when it was closed here
    WebSocketOutbox(WebSocket socket, Executor threads, Consumer<String> onEnd) {
        this.socket = socket;
        this.threads = threads;
        this.onEnd = onEnd;
    }

    @Override
    public void send(String key, String message) {
        boolean isFull;
        synchronized (this) {
            if (isClosed) {
                return;
            }
            waiting.put(key, message);
            isFull = waiting.size() > MOST_WAITING;
        }
        if (isFull) {
            socket.abort();
            onEnd.accept("it does not read what is sent: %d messages wait".formatted(MOST_WAITING));
        } else {
            next();
        }
    }

    private void next() {
        String message = take();
        if (message != null) {
            var _ = socket.sendText(message, true).whenCompleteAsync((_, error) -> sent(error), threads);
        }
    }

    private void sent(@Nullable Throwable error) {
        synchronized (this) {
            isSending = false;
        }
        if (error == null) {
            next();
        } else {
            allSent.countDown();
            onEnd.accept("nothing can be sent: %s".formatted(error.getMessage()));
        }
    }

    private synchronized @Nullable String take() {
        Iterator<String> messages = waiting.values().iterator();
        if (isSending) {
            return null;
        }
        if (!messages.hasNext()) {
            if (isClosed) {
                allSent.countDown();
            }
            return null;
        }
        isSending = true;
        String message = messages.next();
        messages.remove();
        return message;
    }

    @Override
    public void close() {
        onEnd.accept("");
        synchronized (this) {
            isClosed = true;
        }
        next();
        try {
            boolean isDone = allSent.await(LAST_WORDS, TimeUnit.MILLISECONDS);
            if (isDone && !socket.isOutputClosed()) {
                socket.sendClose(WebSocket.NORMAL_CLOSURE, "").get(LAST_WORDS, TimeUnit.MILLISECONDS);
            }
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        } catch (java.util.concurrent.ExecutionException | java.util.concurrent.TimeoutException e) {
            // it is aborted then
        }
        socket.abort();
    }

    @Override
    public void abort() {
        onEnd.accept("");
        synchronized (this) {
            isClosed = true;
            waiting.clear();
        }
        socket.abort();
    }
}
