package rsal.rtps;

import java.util.HashMap;
import java.util.Map;
import java.util.function.Consumer;
import rsal.rtps.WriterProxy.Arrival;
import rsal.rtps.discovery.EndpointData;
import rsal.rtps.wire.Guid;
import rsal.rtps.wire.MessageWriter;

/// A reader of ours, and the writers that it reads from.
public final class SampleReader {
    private final EndpointData data;
    private final Consumer<Arrival> receiver;
    private final AssemblyBudget budget;
    private final Map<Guid, WriterProxy> writers = new HashMap<>();
    private volatile int matched; // how many there are, for threads without the participant's lock

    SampleReader(EndpointData data, AssemblyBudget budget, Consumer<Arrival> receiver) {
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
