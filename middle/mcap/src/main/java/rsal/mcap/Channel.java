package rsal.mcap;

import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.Map;

/// A sequence of messages about one thing.
///
/// @param schema its id; 0 when there is none
/// @param encoding of its messages: `protobuf`
public record Channel(int id, int schema, String topic, String encoding, Map<String, String> metadata) {
    public Channel {
        metadata = Collections.unmodifiableMap(new LinkedHashMap<>(metadata));
    }
}
