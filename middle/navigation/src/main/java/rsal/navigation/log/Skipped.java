package rsal.navigation.log;

import java.util.List;
import java.util.Map;

/// What of a log was not used, and why.
///
/// @param counts how many messages by reason, in the order in which the reasons turned up
/// @param scans how many of these messages were scans
/// @param first the first of them, at most [#TOLD], with line and value
/// @param otherKinds lines of kinds that are not read, comments among them
public record Skipped(Map<String, Integer> counts, int scans, List<Place> first, int otherKinds) {
    /// How many are told one by one.
    public static final int TOLD = 20;

    /// @param line from 1
    public record Place(int line, String what) {}

    public Skipped {
        counts = java.util.Collections.unmodifiableMap(new java.util.LinkedHashMap<>(counts));
        first = List.copyOf(first);
    }

    /// How many messages were not used.
    public int total() {
        return counts.values().stream().mapToInt(Integer::intValue).sum();
    }
}
