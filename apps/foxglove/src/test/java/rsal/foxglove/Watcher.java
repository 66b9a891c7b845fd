package rsal.foxglove;

import java.io.ByteArrayOutputStream;
import java.net.URI;
import java.net.http.HttpClient;
import java.net.http.WebSocket;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.util.HashMap;
import java.util.Map;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionStage;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import java.util.function.Predicate;
import org.jspecify.annotations.Nullable;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.json.JsonMapper;

/// A client, as Foxglove is one.
final class Watcher implements WebSocket.Listener, AutoCloseable {
    private static final JsonMapper MAPPER = new JsonMapper();
    private static final long PATIENCE = 60; // [s]

    final BlockingQueue<JsonNode> texts = new LinkedBlockingQueue<>();
    final BlockingQueue<ByteBuffer> bytes = new LinkedBlockingQueue<>();
    final CompletableFuture<Integer> closed = new CompletableFuture<>();

    private final StringBuilder text = new StringBuilder();
    private final ByteArrayOutputStream part = new ByteArrayOutputStream();
    private final Map<String, Integer> channels = new HashMap<>();
    private final HttpClient http = HttpClient.newHttpClient();
    private final WebSocket socket;

    Watcher(URI url) {
        this(url, null, "foxglove.websocket.v1");
    }

    Watcher(URI url, @Nullable String origin, String protocol) {
        var builder = http.newWebSocketBuilder().subprotocols(protocol);
        if (origin != null) {
            builder.header("Origin", origin);
        }
        socket = builder.buildAsync(url, this).join();
    }

    String protocol() {
        return socket.getSubprotocol();
    }

    @Override
    public @Nullable CompletionStage<?> onText(WebSocket from, CharSequence data, boolean last) {
        text.append(data);
        if (last) {
            texts.add(MAPPER.readTree(text.toString()));
            text.setLength(0);
        }
        from.request(1);
        return null;
    }

    @Override
    public @Nullable CompletionStage<?> onBinary(WebSocket from, ByteBuffer data, boolean last) {
        byte[] some = new byte[data.remaining()];
        data.get(some);
        part.writeBytes(some);
        if (last) {
            bytes.add(ByteBuffer.wrap(part.toByteArray()).order(ByteOrder.LITTLE_ENDIAN));
            part.reset();
        }
        from.request(1);
        return null;
    }

    @Override
    public @Nullable CompletionStage<?> onClose(WebSocket from, int status, String reason) {
        closed.complete(status);
        return null;
    }

    @Override
    public void onError(WebSocket from, Throwable error) {
        closed.complete(-1);
    }

    void send(String message) {
        socket.sendText(message, true).join();
    }

    void send(byte[] message) {
        socket.sendBinary(ByteBuffer.wrap(message), true).join();
    }

    /// Publishes what it has advertised.
    void publish(int channel, String message) {
        byte[] words = message.getBytes(StandardCharsets.UTF_8);
        send(ByteBuffer.allocate(5 + words.length)
                .order(ByteOrder.LITTLE_ENDIAN)
                .put((byte) 1)
                .putInt(channel)
                .put(words)
                .array());
    }

    /// Waits for a message of a kind.
    JsonNode await(String op) throws InterruptedException {
        JsonNode next = texts.poll(PATIENCE, TimeUnit.SECONDS);
        while (next != null && !next.path("op").asString("").equals(op)) {
            next = texts.poll(PATIENCE, TimeUnit.SECONDS);
        }
        if (next == null) {
            throw new AssertionError("No (%s) came.".formatted(op));
        }
        return next;
    }

    /// Waits until a channel is offered.
    int channel(String topic) throws InterruptedException {
        while (!channels.containsKey(topic)) {
            await("advertise")
                    .path("channels")
                    .forEach(offer -> channels.put(
                            offer.path("topic").asString(), offer.path("id").asInt()));
        }
        return channels.get(topic);
    }

    void subscribe(int subscription, String topic) throws InterruptedException {
        send("""
                {"op": "subscribe", "subscriptions": [{"id": %d, "channelId": %d}]}""".formatted(subscription, channel(topic)));
    }

    /// Waits for a message of a subscription.
    ByteBuffer await(int subscription) throws InterruptedException {
        return await(message -> message.get(0) == 1 && message.getInt(1) == subscription);
    }

    ByteBuffer await(Predicate<ByteBuffer> wanted) throws InterruptedException {
        ByteBuffer next = bytes.poll(PATIENCE, TimeUnit.SECONDS);
        while (next != null && !wanted.test(next)) {
            next = bytes.poll(PATIENCE, TimeUnit.SECONDS);
        }
        if (next == null) {
            throw new AssertionError("Nothing came.");
        }
        return next;
    }

    @Override
    public void close() {
        socket.abort();
        http.close();
    }
}
