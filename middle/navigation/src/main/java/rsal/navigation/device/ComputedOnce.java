package rsal.navigation.device;

import java.util.LinkedHashMap;
import java.util.function.Function;

/// Things that take a while to compute and are the same for several robots: computed for the first, kept for the
/// others. Keeps the newest few. Locks, since runs on threads of their own may share a driver.
final class ComputedOnce<K, V> {
    private static final int MOST = 4;

    private final LinkedHashMap<K, V> values = new LinkedHashMap<>();

    synchronized V of(K key, Function<? super K, ? extends V> make) {
        V value = values.computeIfAbsent(key, make);
        if (values.size() > MOST) {
            values.pollFirstEntry();
        }
        return value;
    }
}
