package rsal.navigation.device;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.Function;
import java.util.function.Predicate;

/// Things that take a while to compute and are the same for several robots: computed for the first, kept for the
/// others. Keeps the newest few. Locks, since runs on threads of their own may share a driver.
final class Shared<K, V> {
    private static final int MOST = 4;

    private final LinkedHashMap<K, V> values = new LinkedHashMap<>();

    synchronized V of(K key, Function<? super K, ? extends V> make) {
        V value = values.computeIfAbsent(key, make);
        if (values.size() > MOST) {
            values.pollFirstEntry();
        }
        return value;
    }

    /// Those that are kept for such keys, newest first.
    synchronized List<V> of(Predicate<? super K> keys) {
        return values.sequencedEntrySet().reversed().stream()
                .filter(entry -> keys.test(entry.getKey()))
                .map(Map.Entry::getValue)
                .toList();
    }
}
