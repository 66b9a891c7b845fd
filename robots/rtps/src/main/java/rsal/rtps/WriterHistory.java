package rsal.rtps;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.HashMap;
import java.util.Map;
import java.util.NavigableMap;
import java.util.Optional;
import java.util.TreeMap;
import org.jspecify.annotations.Nullable;
import rsal.rtps.discovery.Qos;
import rsal.rtps.wire.Guid;
import rsal.rtps.wire.Submessage.Content;

/// The samples that a writer keeps: for readers that lack them, and for late ones.
///
/// A reliable writer that keeps all has no room for another one while it is full of samples that some reader
/// lacks. When all have a sample, a volatile one forgets it, and a latched one when it needs the room.
final class WriterHistory {
    private static final int MOST_WITHDRAWN = 64; // keys of which the last sample is kept

    private final Qos qos;
    private final RtpsLimits limits;
    private final NavigableMap<Long, KeptSample> kept = new TreeMap<>();
    private final Map<Guid, Long> numbers = new HashMap<>(); // by key
    private final Deque<Guid> withdrawn = new ArrayDeque<>(); // keys
    private long bytes; // of payloads
    private long acknowledged; // by all reliable readers

    WriterHistory(Qos qos, RtpsLimits limits) {
        this.qos = qos;
        this.limits = limits;
    }

    /// Whether nothing is lost that a reader lacks.
    boolean keepsAll() {
        return qos.isReliable() && qos.depth() == Qos.KEEP_ALL;
    }

    /// Whether another sample may be added, for which it forgets what all readers have. There is room for a
    /// single one however long it is.
    ///
    /// @param payload [B]
    boolean makesRoom(int payload) {
        if (!keepsAll()) {
            return true;
        }
        while (isFull(payload) && kept.firstKey() <= acknowledged) {
            remove(kept.firstKey());
        }
        return !isFull(payload);
    }

    private boolean isFull(int payload) {
        return !kept.isEmpty() && (kept.size() >= limits.kept() || bytes + payload > limits.keptBytes());
    }

    /// Adds a sample without a key, and forgets the oldest ones if it keeps the last ones only.
    ///
    /// @return how many were forgotten that a reader may lack: up to this number
    long add(KeptSample sample) {
        put(sample);
        long forgotten = 0;
        while (!keepsAll() && kept.size() > Math.min(qos.depth(), limits.kept())) {
            forgotten = kept.firstKey();
            remove(forgotten);
        }
        return forgotten;
    }

    /// Adds a sample that replaces the one before of its key.
    void add(Guid key, KeptSample sample) {
        removeLast(numbers.put(key, sample.number()));
        if (sample.content() == Content.KEY) {
            withdrawn.add(key);
            if (withdrawn.size() > MOST_WITHDRAWN) {
                removeLast(numbers.remove(withdrawn.remove()));
            }
        }
        put(sample);
    }

    private void put(KeptSample sample) {
        kept.put(sample.number(), sample);
        bytes += sample.payload().length;
    }

    /// @param number of a key's last sample, if it has one
    private void removeLast(@Nullable Long number) {
        if (number != null) {
            remove(number);
        }
    }

    private void remove(long number) {
        KeptSample sample = kept.remove(number);
        if (sample != null) {
            bytes -= sample.payload().length;
        }
    }

    /// All reliable readers have the samples up to this one; lower than before where a late reader lacks some.
    ///
    /// @return whether there may be room now where there was none
    boolean acknowledge(long number) {
        boolean isMore = number > acknowledged;
        acknowledged = number;
        while (!qos.isLatched() && !kept.isEmpty() && kept.firstKey() <= number) {
            remove(kept.firstKey());
        }
        return isMore;
    }

    Optional<KeptSample> find(long number) {
        return Optional.ofNullable(kept.get(number));
    }

    /// The first one after a number.
    Optional<KeptSample> after(long number) {
        return Optional.ofNullable(kept.higherEntry(number)).map(Map.Entry::getValue);
    }

    /// The number of the first one.
    ///
    /// @param last that was written
    long first(long last) {
        return kept.isEmpty() ? last + 1 : kept.firstKey();
    }
}
