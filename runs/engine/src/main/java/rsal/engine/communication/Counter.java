package rsal.engine.communication;

import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Set;

/// Names, each as often as somebody said it.
final class Counter {
    private final Map<String, Integer> counts = new LinkedHashMap<>();

    void add(String name) {
        counts.merge(name, 1, Integer::sum);
    }

    /// Takes back that somebody said it.
    void remove(String name) {
        counts.computeIfPresent(name, (_, count) -> count == 1 ? null : count - 1);
    }

    boolean contains(String name) {
        return counts.containsKey(name);
    }

    /// How much more often it was said than taken back.
    int times(String name) {
        return counts.getOrDefault(name, 0);
    }

    /// Those that were said more often than taken back.
    Set<String> names() {
        return Set.copyOf(counts.keySet());
    }
}
