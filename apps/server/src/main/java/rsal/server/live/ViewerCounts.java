package rsal.server.live;

import java.util.EnumMap;
import java.util.EnumSet;
import java.util.Map;
import java.util.Objects;
import java.util.concurrent.atomic.LongAdder;

/// What viewers were sent and were not, all together, since the server began. Any thread counts and asks.
public final class ViewerCounts {
    /// Of messages, as the page knows them.
    public enum Kind {
        RUN,
        NEWCOMERS,
        THINGS,
        DETAILS,
        FRAME,
        EVENTS,
        REACH
    }

    /// Why the server let a viewer go.
    public enum Reason {
        /// It took nothing for too long.
        SILENT,
        /// It could not be sent to.
        FAILED,
        /// There were too many.
        FULL,
        /// It sent what is no receipt.
        NONSENSE
    }

    private final LongAdder came = new LongAdder();
    private final LongAdder skipped = new LongAdder();
    private final Map<Kind, LongAdder> messages = adders(Kind.class);
    private final Map<Kind, LongAdder> bytes = adders(Kind.class);
    private final Map<Reason, LongAdder> letGo = adders(Reason.class);

    private static <K extends Enum<K>> Map<K, LongAdder> adders(Class<K> keys) {
        var adders = new EnumMap<K, LongAdder>(keys);
        EnumSet.allOf(keys).forEach(key -> adders.put(key, new LongAdder()));
        return adders;
    }

    /// A viewer has come.
    void addViewer() {
        came.increment();
    }

    void letGo(Reason why) {
        of(letGo, why).increment();
    }

    /// A message was sent to one viewer.
    void sent(Kind kind, int size) {
        of(messages, kind).increment();
        of(bytes, kind).add(size);
    }

    /// So many frames were not sent to one viewer, as it had not yet taken those before.
    void skipped(long frames) {
        skipped.add(frames);
    }

    public long came() {
        return came.sum();
    }

    public long gone(Reason why) {
        return of(letGo, why).sum();
    }

    public long messages(Kind kind) {
        return of(messages, kind).sum();
    }

    /// Of messages, without what the network adds.
    public long bytes(Kind kind) {
        return of(bytes, kind).sum();
    }

    public long skippedFrames() {
        return skipped.sum();
    }

    private static <K extends Enum<K>> LongAdder of(Map<K, LongAdder> adders, K key) {
        return Objects.requireNonNull(adders.get(key)); // each has one
    }
}
