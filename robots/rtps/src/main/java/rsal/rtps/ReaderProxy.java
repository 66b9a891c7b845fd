package rsal.rtps;

import java.util.ArrayDeque;
import java.util.BitSet;
import java.util.Deque;
import java.util.Iterator;
import rsal.rtps.wire.Guid;
import rsal.rtps.wire.Submessage.AckNack;

/// A reader as one of our writers knows it: which samples it has, and which it is still to get (DDSI-RTPS 2.5, 8.4.7
/// and 8.4.9).
final class ReaderProxy {
    private static final long MILLISECOND = 1_000_000; // ns
    private static final long FIRST_HEARTBEAT = 20 * MILLISECOND; // then doubled, until the reader answers
    private static final long LAST_HEARTBEAT = 500 * MILLISECOND;

    private static final int MOST_STREAMS = 64; // samples, to one that does not acknowledge
    private static final int MOST_STREAMED = 16 << 20; // B of them

    final Guid guid;
    final Addressee addressee;
    final boolean isReliable;

    /// Samples up to this one are not for it: they were written before it came.
    final long start;

    /// Samples in fragments that are being sent.
    final Deque<Stream> streams = new ArrayDeque<>();

    long acknowledged;
    boolean isHeard;

    /// Whether it takes what is written from now on: a reliable one once it has had a heartbeat. Cyclone DDS takes
    /// nothing of a writer before.
    boolean isReady;

    long paced = Long.MIN_VALUE; // when fragments were sent [ns]
    long repaired = Long.MIN_VALUE / 2; // when samples were sent again [ns]
    private int newestAnswer; // its count
    private int newestNack;
    private boolean hasAnswered;
    private boolean hasNacked;
    private long patience = FIRST_HEARTBEAT;
    private long heartbeatAt;

    /// A sample in fragments, of which those that are set are still to be sent.
    record Stream(KeptSample sample, BitSet fragments) {}

    ReaderProxy(Guid guid, Addressee addressee, boolean isReliable, long start, long now) {
        this.guid = guid;
        this.addressee = addressee;
        this.isReliable = isReliable;
        this.start = start;
        acknowledged = start;
        isReady = !isReliable;
        heartbeatAt = isReliable ? now : Long.MAX_VALUE;
    }

    /// When it is next told what there is [ns].
    long heartbeatAt() {
        return heartbeatAt;
    }

    /// Was told what there is; is told again later if it does not answer.
    void reported(long now) {
        if (isReliable) {
            heartbeatAt = now + patience;
            patience = Math.min(2 * patience, LAST_HEARTBEAT);
        }
    }

    /// Something new was written.
    void expectAnswer(long now) {
        patience = FIRST_HEARTBEAT;
        reported(now);
    }

    /// @param answer not final also when it is one of the first, of a reader that has had no heartbeat yet
    /// @param last number that was written
    /// @return false for an answer that is not newer than the one before
    boolean answered(AckNack answer, long last, long now) {
        if (hasAnswered && answer.count() - newestAnswer <= 0) {
            return false;
        }
        long base = answer.missing().base();
        isReady |= answer.isFinal() || base > 1 || hasAnswered;
        newestAnswer = answer.count();
        hasAnswered = true;
        if (base > acknowledged + 1 || !answer.missing().isEmpty() || !isReady) { // else it takes nothing for now
            patience = FIRST_HEARTBEAT;
        }
        if (base > 0) {
            isHeard = true;
            acknowledged = Math.max(acknowledged, Math.min(base - 1, last));
            streams.removeIf(each -> each.sample.number() <= acknowledged);
        }
        heartbeatAt = acknowledged >= last && isHeard && isReady ? Long.MAX_VALUE : now + patience;
        return true;
    }

    boolean isNewNack(int count) {
        if (hasNacked && count - newestNack <= 0) {
            return false;
        }
        newestNack = count;
        hasNacked = true;
        return true;
    }

    /// The stream of a sample, which may be under way.
    Stream stream(KeptSample sample) {
        for (Stream stream : streams) {
            if (stream.sample.number() == sample.number()) {
                return stream;
            }
        }
        var stream = new Stream(sample, new BitSet());
        streams.add(stream);
        if (!isReliable) { // of reliable ones the writer keeps no more than it has room for
            limitStreams();
        }
        return stream;
    }

    /// Leaves out the oldest ones but the one that is being sent, of which fragments have arrived.
    private void limitStreams() {
        long bytes =
                streams.stream().mapToLong(each -> each.sample.payload().length).sum();
        Iterator<Stream> oldest = streams.iterator();
        oldest.next();
        while (streams.size() > 2 && (streams.size() > MOST_STREAMS || bytes > MOST_STREAMED)) {
            bytes -= oldest.next().sample.payload().length;
            oldest.remove();
        }
    }
}
