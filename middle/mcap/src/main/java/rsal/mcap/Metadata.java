package rsal.mcap;

import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.Map;

/// Something about a whole file, in words.
public record Metadata(String name, Map<String, String> entries) {
    public Metadata {
        entries = Collections.unmodifiableMap(new LinkedHashMap<>(entries));
    }
}
