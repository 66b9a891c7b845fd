package rsal.player;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.util.HexFormat;
import java.util.List;
import java.util.stream.StreamSupport;
import java.util.zip.GZIPInputStream;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.ObjectMapper;

/// What was recorded of Player 3.1.1: messages that it encoded itself, and sessions with a server.
public final class Recorded {
    private static final ObjectMapper JSON = new ObjectMapper();

    private Recorded() {}

    /// A body, and what it says by Player's names.
    public record Vector(int interf, int type, int subtype, String name, JsonNode value, byte[] bytes) {
        @Override
        public String toString() {
            return "%d %d %d %s".formatted(interf, type, subtype, name);
        }
    }

    /// One whole message of a session.
    ///
    /// @param sent by the client
    public record Message(boolean sent, byte[] bytes) {}

    public static List<Vector> vectors() {
        return StreamSupport.stream(read("vectors").spliterator(), false)
                .map(vector -> new Vector(
                        vector.get("interf").asInt(),
                        vector.get("type").asInt(),
                        vector.get("subtype").asInt(),
                        vector.get("name").asString(),
                        vector.get("value"),
                        HexFormat.of().parseHex(vector.get("hex").asString())))
                .toList();
    }

    public static List<Message> session(String name) {
        return StreamSupport.stream(read("session-" + name).spliterator(), false)
                .map(message -> new Message(
                        message.get(0).asString().equals("C>S"),
                        HexFormat.of().parseHex(message.get(1).asString())))
                .toList();
    }

    private static JsonNode read(String name) {
        try (var in = Recorded.class.getResourceAsStream(name + ".json.gz")) {
            return JSON.readTree(new GZIPInputStream(in));
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }
}
