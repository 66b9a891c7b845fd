package rsal.rtps;

import java.util.HashMap;
import java.util.Map;
import rsal.rtps.WriterProxy.Arrival;
import rsal.rtps.discovery.EndpointData;
import rsal.rtps.wire.Guid;
import rsal.rtps.wire.MessageWriter;

/// A reader of ours, and the writers that it reads from.
public final class SampleReader {
    private final EndpointData data;
    private final Receiver receiver;
    private final AssemblyBudget budget;
    private final Map<Guid, WriterProxy> writers = new HashMap<>();
    private volatile int matched; // how many there are, for threads without the participant's lock

    /// Gets samples.
    interface Receiver {
        void accept(Arrival sample);

        /// Whether it takes another one.
        default boolean hasRoom() {
            return true;
        }
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
        writers.computeIfAbsent(
                writer,
                _ -> new WriterProxy(
                        writer,
                        data.guid().entity(),
                        addressee,
                        isReliable && data.qos().isReliable(),
                        budget,
                        receiver,
                        now));
        matched = writers.size();
    }

    void unmatch(Guid writer) {
        WriterProxy proxy = writers.remove(writer);
        matched = writers.size();
        if (proxy != null) {
            proxy.close();
        }
    }

    /// Whether it takes a sample of a writer of the same participant.
    boolean hasRoom() {
        return receiver.hasRoom();
    }

    /// Takes more of other participants.
    ///
    /// @return when it next has something to ask for [ns]
    long resume(long now) {
        long due = Long.MAX_VALUE;
        for (WriterProxy writer : writers.values()) {
            writer.resume(now);
            due = Math.min(due, writer.due());
        }
        return due;
    }

    /// From a writer of the same participant.
    void deliver(Arrival sample) {
        receiver.accept(sample);
    }

    /// @return when it next has something to ask for [ns]
    long tick(MessageWriter messages, Transmitter network, long now) {
        long due = Long.MAX_VALUE;
        for (WriterProxy writer : writers.values()) {
            writer.forgetOld(now);
            writer.request(messages, network, now);
            due = Math.min(due, writer.due());
        }
        return due;
    }
}
