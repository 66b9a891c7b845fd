package rsal.rtps;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.List;
import java.util.function.Predicate;
import rsal.rtps.wire.GuidPrefix;

/// Replies that wait until their clients' readers are known and ready, or their writer has room.
final class HeldReplies {
    private static final int MOST = 16; // for one participant
    private static final int MOST_BYTES = 4 << 20; // of all of them
    private static final long TIME = 5_000_000_000L; // ns

    private final Deque<Held> held = new ArrayDeque<>();

    private record Held(Reply reply, long until) {}

    boolean hasRoom(Reply reply) {
        GuidPrefix participant = reply.to().prefix();
        int bytes = held.stream().mapToInt(each -> each.reply.payload().length).sum();
        return bytes + reply.payload().length <= MOST_BYTES
                && held.stream()
                                .filter(each -> each.reply.to().prefix().equals(participant))
                                .count()
                        < MOST;
    }

    void add(Reply reply, long now) {
        held.add(new Held(reply, now + TIME));
    }

    /// Writes those whose clients are ready, or that have waited long enough.
    ///
    /// @param write whether there was room for it
    void release(Predicate<Reply> isReady, Predicate<Reply> write, long now) {
        if (held.isEmpty()) { // which is usual, and this is called in each tick
            return;
        }
        List<Held> released = held.stream()
                .filter(each -> each.until <= now || isReady.test(each.reply))
                .toList();
        for (Held each : released) {
            if (write.test(each.reply) || each.until <= now) {
                held.remove(each);
            }
        }
    }

    void forget(GuidPrefix participant) {
        held.removeIf(each -> each.reply.to().prefix().equals(participant));
    }

    /// When the first one has waited long enough [ns].
    long due() {
        return held.isEmpty() ? Long.MAX_VALUE : held.getFirst().until;
    }
}
