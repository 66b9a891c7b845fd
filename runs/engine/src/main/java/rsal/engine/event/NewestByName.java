package rsal.engine.event;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.jspecify.annotations.Nullable;

/// Keeps what is newest by name, a few of each, so that what comes often does not push out what came once. Of the names
/// it keeps those that something came of last.
public final class NewestByName<V> {
    private final int mostOfAName;
    private final Map<String, Ring<V>> byName;
    private long came;

    /// @param mostOfAName how many of one name are kept
    /// @param mostNames how many names
    public NewestByName(int mostOfAName, int mostNames) {
        this.mostOfAName = mostOfAName;
        this.byName = touchedLast(mostNames);
    }

    /// @param number by which those that came earlier come before
    private record Numbered<V>(long number, V value) {}

    private static final class Ring<V> {
        private final @Nullable Numbered<V>[] values;
        private int next;

        @SuppressWarnings({"unchecked", "rawtypes"}) // arrays know no type arguments
        Ring(int size) {
            values = new Numbered[size];
        }

        void add(Numbered<V> value) {
            values[next] = value;
            next = (next + 1) % values.length;
        }

        void addTo(List<Numbered<V>> all) {
            for (Numbered<V> value : values) {
                if (value != null) {
                    all.add(value);
                }
            }
        }
    }

    public void add(String name, V value) {
        byName.computeIfAbsent(name, _ -> new Ring<>(mostOfAName)).add(new Numbered<>(came++, value));
    }

    /// In the order in which they came.
    public List<V> all() {
        var all = new ArrayList<Numbered<V>>();
        byName.values().forEach(ring -> ring.addTo(all));
        all.sort(Comparator.comparingLong(Numbered::number));
        return all.stream().map(Numbered::value).toList();
    }

    /// A map of at most so many entries: those that were asked for or put last.
    public static <V> Map<String, V> touchedLast(int most) {
        return new LinkedHashMap<>(16, 0.75f, true) {
            @Override
            protected boolean removeEldestEntry(Map.Entry<String, V> eldest) {
                return size() > most;
            }
        };
    }
}
