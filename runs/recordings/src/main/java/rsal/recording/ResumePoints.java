package rsal.recording;

import java.util.Collections;
import java.util.IdentityHashMap;
import java.util.Map;
import java.util.NavigableMap;
import java.util.Set;
import java.util.TreeMap;
import org.jspecify.annotations.Nullable;

/// From where a recording can be read on, evenly spread over what was read so far: within so many bytes, of which
/// messages that several places share count once, and what a place takes to have each of them for itself. For one
/// thread.
final class ResumePoints {
    private static final long FIRST_SPACING = 2_000_000_000; // [ns] of the run
    private static final int MOST_PLACES = 400;
    private static final int ENTRY = 64; // of a message in a place [B]

    private final NavigableMap<Long, NewestRecords> places = new TreeMap<>(); // by log time
    private final long most;
    private long spacing = FIRST_SPACING;
    private long next = Long.MIN_VALUE;
    private long bytes;

    /// @param most bytes that they take, but for the first and the last
    ResumePoints(long most) {
        this.most = most;
    }

    /// Whether it is time for the next.
    boolean isDue(long logTime) {
        return logTime >= next;
    }

    /// Keeps a copy.
    ///
    /// @param time of the newest that is in it
    void keep(long time, NewestRecords held) {
        NewestRecords before =
                places.isEmpty() ? new NewestRecords() : places.lastEntry().getValue();
        NewestRecords copy = held.copy();
        copy.messages()
                .forEach((key, raw) -> bytes += raw.equals(before.messages().get(key)) ? 0 : raw.data().length);
        bytes += entries(copy);
        places.put(time, copy);
        while (places.size() > 2 && (places.size() > MOST_PLACES || bytes > most)) {
            thin();
        }
        next = time + 1 + spacing;
    }

    /// Lets every second place go.
    private void thin() {
        spacing *= 2;
        int number = 0;
        for (var all = places.keySet().iterator(); all.hasNext(); number++) {
            all.next();
            if (number % 2 == 1) {
                all.remove();
            }
        }
        Set<byte[]> different = Collections.newSetFromMap(new IdentityHashMap<>());
        places.values().forEach(place -> place.messages().values().forEach(raw -> different.add(raw.data())));
        bytes = different.stream().mapToLong(data -> data.length).sum()
                + places.values().stream().mapToLong(ResumePoints::entries).sum();
    }

    private static long entries(NewestRecords place) {
        return (long) ENTRY * place.messages().size();
    }

    /// The last that has nothing of after a time; null when none has.
    Map.@Nullable Entry<Long, NewestRecords> before(long logTime) {
        return places.floorEntry(logTime);
    }

    int count() {
        return places.size();
    }
}
