package rsal.rtps;

import java.nio.ByteBuffer;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import java.util.stream.LongStream;
import rsal.rtps.wire.EntityId;
import rsal.rtps.wire.Guid;
import rsal.rtps.wire.NumberSet;
import rsal.rtps.wire.ParameterList;
import rsal.rtps.wire.Submessage.AckNack;
import rsal.rtps.wire.Submessage.Content;
import rsal.rtps.wire.Submessage.Data;
import rsal.rtps.wire.Submessage.DataFragments;
import rsal.rtps.wire.Submessage.Gap;
import rsal.rtps.wire.Submessage.Heartbeat;
import rsal.rtps.wire.Submessage.NackFragments;

/// A writer as one of our readers knows it: which of its samples have come (DDSI-RTPS 2.5, 8.4.10 and 8.4.12).
final class WriterProxy implements SampleReader.Source {
    private static final long MILLISECOND = 1_000_000; // ns
    private static final long BETWEEN_REQUESTS = 10 * MILLISECOND;
    private static final long FIRST_REQUEST = 100 * MILLISECOND; // doubled each time, until there is a heartbeat
    private static final long LAST_REQUEST = 2_000 * MILLISECOND;
    private static final int MOST_INCOMPLETE = 4; // samples in fragments
    private static final long INCOMPLETE_FOR = 5_000 * MILLISECOND; // without another fragment

    private final Guid guid;
    private final EntityId reader;
    private final Addressee addressee;
    private final boolean isReliable;
    private final AssemblyBudget budget;
    private final SampleReader.Receiver receiver;
    private final TreeMap<Long, Arrival> early = new TreeMap<>(); // or refused
    private final TreeMap<Long, FragmentedSample> incomplete = new TreeMap<>();
    private int earlyBytes;
    private long next = 1; // that is to be delivered
    private long floor = 1; // what is below it and has not come never comes
    private long last; // that is known to have been written
    private long resumed = 1; // where it went on when it was found again
    private boolean isRefusing; // the receiver takes nothing for now
    private boolean owesWord; // it refused, and has not told the writer since that it takes more
    private boolean isHeard; // by a heartbeat
    private int heartbeats; // count of the newest
    private int requests; // count of the newest; goes on when the writer is lost and found again
    private int fragmentRequests; // as well
    private long requested = Long.MIN_VALUE / 2; // when [ns]
    private long due; // of the next request [ns]; [Timestamp#INFINITE] for none
    private long patience = FIRST_REQUEST; // ns

    /// A sample that has come, or a number for which none comes.
    ///
    /// @param isGap whether none comes
    record Arrival(
            Guid writer,
            long number,
            long timestamp,
            ParameterList inlineQos,
            Content content,
            ByteBuffer payload,
            boolean isGap) {
        static Arrival of(Guid writer, long timestamp, Data data) {
            return new Arrival(
                    writer, data.number(), timestamp, data.inlineQos(), data.content(), data.payload(), false);
        }

        static Arrival gap(Guid writer, long number) {
            return new Arrival(writer, number, 0, ParameterList.EMPTY, Content.NONE, ByteBuffer.allocate(0), true);
        }

        Arrival copied() {
            var copy = new byte[payload.remaining()];
            payload.duplicate().get(copy);
            return new Arrival(writer, number, timestamp, inlineQos.copy(), content, ByteBuffer.wrap(copy), isGap);
        }
    }

    /// @param isReliable whether both sides are
    /// @param receiver gets the samples, in order
    /// @param now [ns]
    WriterProxy(
            Guid guid,
            EntityId reader,
            Addressee addressee,
            boolean isReliable,
            AssemblyBudget budget,
            SampleReader.Receiver receiver,
            long now) {
        this.guid = guid;
        this.reader = reader;
        this.addressee = addressee;
        this.isReliable = isReliable;
        this.budget = budget;
        this.receiver = receiver;
        due = isReliable ? now : Long.MAX_VALUE;
        requests = count(now, BETWEEN_REQUESTS);
        fragmentRequests = count(now, BETWEEN_REQUESTS / MOST_INCOMPLETE);
    }

    /// With which number counts begin, so that they are higher than those before, of which no more than one
    /// came in each interval. For 62 days and more it does not start over.
    private static int count(long now, long interval) {
        return (int) (now / interval & Integer.MAX_VALUE);
    }

    boolean isReliable() {
        return isReliable;
    }

    /// The number of the sample that is to be delivered next.
    long next() {
        return next;
    }

    /// It was lost and is found again: samples below that number have been delivered.
    void goOn(long number) {
        resumed = number;
        next = number;
        floor = number;
        last = number - 1;
    }

    /// It has started again, with the same name.
    private void startOver() {
        close();
        early.clear();
        earlyBytes = 0;
        goOn(1);
    }

    void receive(Arrival sample) {
        long number = sample.number;
        if (number < next || early.containsKey(number)) {
            return;
        }
        drop(number);
        last = Math.max(last, number);
        if (!isReliable) {
            next = number + 1;
            incomplete.headMap(next).keySet().stream().toList().forEach(this::drop);
            receiver.accept(sample);
        } else if (number == next && takes()) {
            next++;
            receiver.accept(sample);
            drain();
        } else if (early.size() < budget.limits().early() && fitsEarly(sample.payload.remaining())) {
            keep(sample.copied());
        }
    }

    private boolean fitsEarly(int bytes) {
        return earlyBytes + bytes <= budget.limits().earlyBytes();
    }

    private boolean takes() {
        isRefusing = !receiver.hasRoom();
        owesWord |= isRefusing;
        return !isRefusing;
    }

    /// The receiver takes samples again, as it is asked for next.
    void resume(long now) {
        if (owesWord) {
            owesWord = false;
            isRefusing = false;
            due = Math.min(due, Math.max(now, requested + BETWEEN_REQUESTS)); // to acknowledge, and to ask for more
        }
    }

    private void keep(Arrival sample) {
        if (early.putIfAbsent(sample.number, sample) == null) {
            earlyBytes += sample.payload.remaining();
        }
    }

    /// Delivers those that waited for one before them, or for the receiver.
    private void drain() {
        while (deliverNext()) {
            // and the next one
        }
    }

    @Override
    public boolean deliverNext() {
        while (!early.isEmpty() || next < floor) {
            long first = early.isEmpty() ? floor : early.firstKey();
            if (first > next) {
                if (next >= floor) {
                    return false;
                }
                next = Math.min(first, floor);
            } else if (first < next || early.firstEntry().getValue().isGap || takes()) {
                Arrival sample = early.pollFirstEntry().getValue();
                earlyBytes -= sample.payload.remaining();
                next = Math.max(next, first + 1);
                if (first == next - 1 && !sample.isGap) {
                    receiver.accept(sample);
                    return true;
                }
            } else {
                return false;
            }
        }
        return false;
    }

    void receive(DataFragments part, long timestamp, long now) {
        long number = part.number();
        if (number < next || early.containsKey(number)) {
            return;
        }
        last = Math.max(last, number);
        if (part.sampleSize() > budget.limits().sample()) {
            leaveOut(number); // it is never asked for again
            return;
        }
        FragmentedSample assembly = incomplete.get(number);
        if (assembly == null) {
            boolean fits = !isRefusing || fitsEarly(part.sampleSize());
            if (!fits || !hasRoom(number) || !budget.take(part.sampleSize())) {
                return;
            }
            assembly = new FragmentedSample(part);
            incomplete.put(number, assembly);
        }
        assembly.add(part, now);
        if (assembly.isComplete()) {
            receive(new Arrival(
                    guid,
                    number,
                    timestamp,
                    assembly.inlineQos(),
                    Content.DATA,
                    ByteBuffer.wrap(assembly.payload()),
                    false));
        }
    }

    /// Of a reliable writer the earliest ones are wanted first, of any other one the newest.
    private boolean hasRoom(long number) {
        if (incomplete.size() < MOST_INCOMPLETE) {
            return true;
        }
        long surplus = isReliable ? incomplete.lastKey() : incomplete.firstKey();
        if (isReliable ? number > surplus : number < surplus) {
            return false;
        }
        drop(surplus);
        return true;
    }

    private void drop(long number) {
        FragmentedSample assembly = incomplete.remove(number);
        if (assembly != null) {
            budget.give(assembly.bytes());
        }
    }

    void receive(Heartbeat heartbeat, long now) {
        if (!isReliable || (isHeard && heartbeat.count() - heartbeats <= 0)) {
            return;
        }
        if (!isHeard && heartbeat.last() < resumed - 1) {
            startOver();
        }
        heartbeats = heartbeat.count();
        isHeard = true;
        boolean takesMore = owesWord && takes();
        if (takesMore) {
            owesWord = false;
            drain();
        }
        due = Long.MAX_VALUE;
        last = Math.max(last, heartbeat.last());
        skip(heartbeat.first());
        if (!heartbeat.isFinal() || next <= last || takesMore) {
            due = Math.max(now, requested + BETWEEN_REQUESTS);
        }
    }

    /// What is below that number and has not come does not come any more.
    private void skip(long first) {
        if (first > next) {
            incomplete.headMap(first).keySet().stream().toList().forEach(this::drop);
            floor = Math.max(floor, first);
            drain();
        }
    }

    void receive(Gap gap) {
        if (!isReliable) {
            return;
        }
        if (gap.start() <= next) {
            skip(gap.more().base());
        } else {
            LongStream.range(gap.start(), gap.more().base())
                    .limit(budget.limits().early())
                    .forEach(this::leaveOut);
        }
        gap.more().numbers().forEach(this::leaveOut);
        last = Math.max(last, next - 1);
    }

    private void leaveOut(long number) {
        if (!isReliable) {
            return; // nothing waits for it
        }
        if (number == next && !early.containsKey(number)) {
            drop(number);
            next++;
            drain();
        } else if (number > next && early.size() < budget.limits().early()) {
            keep(Arrival.gap(guid, number));
        }
    }

    /// When it next has something to ask for, or to give up [ns].
    long due() {
        long earliest = due;
        if (!incomplete.isEmpty()) { // which is rare, and this is called for each heartbeat
            for (FragmentedSample assembly : incomplete.values()) {
                earliest = Math.min(earliest, assembly.grown() + INCOMPLETE_FOR);
            }
        }
        return earliest;
    }

    /// Forgets samples of which no more fragments come, so that they take no room from others.
    void forgetOld(long now) {
        if (incomplete.isEmpty()) { // which is rare otherwise, and this is called in each tick
            return;
        }
        incomplete.entrySet().stream()
                .filter(each -> each.getValue().grown() + INCOMPLETE_FOR <= now)
                .map(Map.Entry::getKey)
                .toList()
                .forEach(this::drop);
    }

    boolean hasRequest(long now) {
        return due <= now;
    }

    Addressee addressee() {
        return addressee;
    }

    /// Asks for what is missing, or whether there is anything, if that is due. While the receiver takes
    /// nothing, it asks for nothing, and says only which samples it has taken.
    void request(DatagramOutbox outbox, long now) {
        if (!hasRequest(now)) {
            return;
        }
        requested = now;
        due = Long.MAX_VALUE;
        if (!isHeard) {
            due = now + patience;
            patience = Math.min(2 * patience, LAST_REQUEST);
        }
        NumberSet missing = isRefusing ? NumberSet.empty(next) : missing();
        outbox.to(addressee).ackNack(new AckNack(reader, guid.entity(), missing, ++requests, isHeard));
        if (!isRefusing) {
            incomplete.forEach((number, assembly) -> missing(assembly)
                    .ifPresent(fragments -> outbox.to(addressee)
                            .nackFragments(
                                    new NackFragments(reader, guid.entity(), number, fragments, ++fragmentRequests))));
        }
    }

    private NumberSet missing() {
        return NumberSet.of(
                next,
                LongStream.rangeClosed(next, Math.min(last, next + NumberSet.MOST - 1))
                        .filter(number -> !early.containsKey(number) && !incomplete.containsKey(number)));
    }

    private static Optional<NumberSet> missing(FragmentedSample assembly) {
        return assembly.missing().boxed().findFirst().map(first -> NumberSet.of(first, assembly.missing()));
    }

    void close() {
        incomplete.keySet().stream().toList().forEach(this::drop);
    }
}
