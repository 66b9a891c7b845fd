package rsal.rtps;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.SequencedMap;
import rsal.rtps.WriterProxy.Arrival;
import rsal.rtps.discovery.EndpointData;
import rsal.rtps.wire.Guid;

/// A reader of ours, and the writers that it reads from.
///
/// A volatile one goes on after the last sample it has had of a reliable writer that was lost and is found
/// again, so that old commands do not come twice. A latched one gets again what the writer still has: who
/// forgot all that a lost participant had said needs it.
public final class SampleReader {
    private static final int MOST_LOST = 256; // writers whose next sample is remembered

    private final EndpointData data;
    private final Receiver receiver;
    private final AssemblyBudget budget;
    private final Map<Guid, WriterProxy> writers = new HashMap<>();
    private final List<Source> sources = new ArrayList<>(); // these, and writers of the same participant
    private final SequencedMap<Guid, Long> lost = new LinkedHashMap<>(); // numbers of their next samples
    private int turn; // index of the source that was last asked
    private volatile int matched; // how many there are, for threads without the participant's lock

    /// Gets samples.
    interface Receiver {
        void accept(Arrival sample);

        /// Whether it takes another one.
        default boolean hasRoom() {
            return true;
        }
    }

    /// Has samples, or will have.
    interface Source {
        /// Hands over the next sample.
        ///
        /// @return false when there is none, or it is not taken now
        boolean deliverNext();
    }

    SampleReader(EndpointData data, AssemblyBudget budget, Receiver receiver) {
        this.data = data;
        this.budget = budget;
        this.receiver = receiver;
    }

    /// As it is announced.
    public EndpointData data() {
        return data;
    }

    /// How many writers it reads from. Any thread may ask.
    public int matched() {
        return matched;
    }

    Map<Guid, WriterProxy> writers() {
        return writers;
    }

    void match(Guid writer, Addressee addressee, boolean isReliable, long now) {
        if (writers.containsKey(writer)) {
            return;
        }
        var proxy = new WriterProxy(
                writer,
                data.guid().entity(),
                addressee,
                isReliable && data.qos().isReliable(),
                budget,
                receiver,
                now);
        Long next = lost.remove(writer);
        if (next != null) {
            proxy.goOn(next);
        }
        writers.put(writer, proxy);
        sources.add(proxy);
        matched = writers.size();
    }

    void unmatch(Guid writer) {
        WriterProxy proxy = writers.remove(writer);
        matched = writers.size();
        if (proxy != null) {
            sources.remove(proxy);
            proxy.close();
            if (proxy.isReliable() && !data.qos().isLatched()) {
                lost.putLast(writer, proxy.next());
            }
            if (lost.size() > MOST_LOST) {
                lost.pollFirstEntry();
            }
        }
    }

    void add(Source neighbor) {
        sources.add(neighbor);
    }

    void remove(Source neighbor) {
        sources.remove(neighbor);
    }

    /// Whether it takes a sample of a writer of the same participant.
    boolean hasRoom() {
        return receiver.hasRoom();
    }

    /// Takes more: of all that have samples one after the other, so that none waits for ever.
    ///
    /// @return when it next has something to ask for [ns]
    long resume(long now) {
        long due = Long.MAX_VALUE;
        for (WriterProxy writer : writers.values()) {
            writer.resume(now);
            due = Math.min(due, writer.due());
        }
        int refused = 0; // in a row; each is asked, so that it knows
        while (refused < sources.size()) {
            turn = (turn + 1) % sources.size();
            refused = sources.get(turn).deliverNext() ? 0 : refused + 1;
        }
        return due;
    }

    /// From a writer of the same participant.
    void deliver(Arrival sample) {
        receiver.accept(sample);
    }

    /// Gathers what is to be asked for now.
    void tick(DueParts parts, DatagramOutbox outbox, long now) {
        for (WriterProxy writer : writers.values()) {
            writer.forgetOld(now);
            if (writer.hasRequest(now)) {
                parts.add(writer.addressee(), () -> writer.request(outbox, now));
            }
        }
    }

    /// When there is next something to do [ns].
    long due() {
        long due = Long.MAX_VALUE;
        for (WriterProxy writer : writers.values()) {
            due = Math.min(due, writer.due());
        }
        return due;
    }
}
