package rsal.rtps;

import java.net.InetSocketAddress;
import java.util.ArrayList;
import java.util.Collection;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.stream.Stream;
import rsal.rtps.discovery.EndpointData;
import rsal.rtps.wire.EntityId;
import rsal.rtps.wire.Guid;
import rsal.rtps.wire.GuidPrefix;

/// Writers and readers of a participant, the built-in ones too, and with whom of others each is matched.
final class OwnEndpoints {
    private static final long FAREWELL = 500_000_000; // ns

    private final GraphListener graph;
    private final Map<EntityId, SampleWriter> writers = new LinkedHashMap<>();
    private final Map<SampleWriter, Long> leaving = new LinkedHashMap<>(); // until when at most [ns]
    private final Map<EntityId, SampleReader> readers = new LinkedHashMap<>();
    private final Map<Guid, List<SampleReader>> listening = new HashMap<>(); // by the writer they read from

    OwnEndpoints(GraphListener graph) {
        this.graph = graph;
    }

    void add(SampleWriter writer, Collection<RemoteParticipant> others, long now) {
        writers.put(writer.data().guid().entity(), writer);
        readers.values().stream()
                .filter(each -> fit(writer.data(), each.data()))
                .forEach(writer::matchNeighbor);
        others.forEach(other -> other.endpoints.values().forEach(each -> match(writer, other, each, now)));
    }

    void add(SampleReader reader, Collection<RemoteParticipant> others, long now) {
        readers.put(reader.data().guid().entity(), reader);
        writers.values().stream()
                .filter(each -> fit(each.data(), reader.data()))
                .forEach(each -> each.matchNeighbor(reader));
        others.forEach(other -> other.endpoints.values().forEach(each -> match(reader, other, each, now)));
    }

    private static boolean fit(EndpointData writer, EndpointData reader) {
        return isOfOneTopic(writer, reader) && writer.mismatch(reader).isEmpty();
    }

    /// Nothing more is written by it.
    void release(SampleWriter writer, long now) {
        if (writers.containsValue(writer)) {
            leaving.putIfAbsent(writer, now + FAREWELL);
        }
    }

    boolean isLeaving(SampleWriter writer) {
        return leaving.containsKey(writer);
    }

    /// Removes those that were released when their last samples have arrived, or had their time to.
    ///
    /// @return who is gone
    List<SampleWriter> dismiss(long now) {
        if (leaving.isEmpty()) {
            return List.of();
        }
        List<SampleWriter> gone = leaving.entrySet().stream()
                .filter(each -> each.getValue() <= now || each.getKey().isAcknowledged())
                .map(Map.Entry::getKey)
                .toList();
        gone.forEach(leaving::remove);
        gone.forEach(SampleWriter::close);
        gone.forEach(each -> writers.remove(each.data().guid().entity()));
        return gone;
    }

    /// A reader of ours takes more.
    ///
    /// @return when there is next something to do [ns]
    long resume(SampleReader reader, long now) {
        long due = reader.resume(now);
        writers.values().forEach(SampleWriter::settle);
        return leaving.isEmpty() ? due : now; // one of them may have waited for this
    }

    boolean remove(SampleReader reader) {
        Guid guid = reader.data().guid();
        if (!readers.remove(guid.entity(), reader)) {
            return false;
        }
        List.copyOf(reader.writers().keySet()).forEach(writer -> unmatch(reader, writer));
        writers.values().forEach(writer -> writer.unmatch(guid));
        return true;
    }

    Stream<SampleWriter> writers() {
        return writers.values().stream();
    }

    Optional<SampleWriter> writer(EntityId entity) {
        return Optional.ofNullable(writers.get(entity));
    }

    /// @param reader for whom it is; [EntityId#UNKNOWN] for all that read from the writer
    void proxies(Guid writer, EntityId reader, Consumer<WriterProxy> action) {
        for (SampleReader each : List.copyOf(listening.getOrDefault(writer, List.of()))) {
            if (reader.equals(EntityId.UNKNOWN)
                    || reader.equals(each.data().guid().entity())) {
                WriterProxy proxy = each.writers().get(writer);
                if (proxy != null) {
                    action.accept(proxy);
                }
            }
        }
    }

    /// Somebody else has a writer or reader.
    void learn(RemoteParticipant other, EndpointData data, long now) {
        if (data.isWriter()) {
            List.copyOf(readers.values()).forEach(reader -> match(reader, other, data, now));
        } else {
            List.copyOf(writers.values()).forEach(writer -> match(writer, other, data, now));
        }
    }

    /// Somebody else has a writer or reader no longer.
    void forget(Guid guid) {
        writers.values().forEach(writer -> writer.unmatch(guid));
        readers.values().forEach(reader -> unmatch(reader, guid));
    }

    void forgetAll(GuidPrefix participant) {
        writers.values().forEach(writer -> writer.unmatchAll(participant));
        for (SampleReader reader : readers.values()) {
            reader.writers().keySet().stream()
                    .filter(writer -> writer.prefix().equals(participant))
                    .toList()
                    .forEach(writer -> unmatch(reader, writer));
        }
    }

    /// Does what is due.
    ///
    /// @return when there is next something to do [ns]
    long tick(DatagramOutbox outbox, long now) {
        var parts = new DueParts();
        for (SampleReader reader : readers.values()) {
            reader.tick(parts, outbox, now);
        }
        for (SampleWriter writer : writers.values()) {
            writer.tick(parts, now);
        }
        parts.write();
        long due = leaving.values().stream().reduce(Long.MAX_VALUE, Math::min);
        for (SampleReader reader : readers.values()) {
            due = Math.min(due, reader.due());
        }
        for (SampleWriter writer : writers.values()) {
            due = Math.min(due, writer.due());
        }
        return due;
    }

    private void match(SampleWriter own, RemoteParticipant other, EndpointData reader, long now) {
        if (!reader.isWriter() && isOfOneTopic(own.data(), reader)) {
            own.data()
                    .mismatch(reader)
                    .ifPresentOrElse(
                            why -> graph.onMismatch(own.data(), reader, why),
                            () -> own.match(reader.guid(), addressee(other, reader), reader.qos(), now));
        }
    }

    private void match(SampleReader own, RemoteParticipant other, EndpointData writer, long now) {
        if (writer.isWriter() && isOfOneTopic(own.data(), writer)) {
            writer.mismatch(own.data())
                    .ifPresentOrElse(
                            why -> graph.onMismatch(own.data(), writer, why),
                            () -> match(
                                    own,
                                    addressee(other, writer),
                                    writer.guid(),
                                    writer.qos().isReliable(),
                                    now));
        }
    }

    private static boolean isOfOneTopic(EndpointData own, EndpointData other) {
        return own.topic().equals(other.topic()) && !own.topic().isEmpty();
    }

    /// A reader of ours reads from a writer of somebody else.
    void match(SampleReader own, Addressee addressee, Guid writer, boolean isReliable, long now) {
        own.match(writer, addressee, isReliable, now);
        List<SampleReader> all = listening.computeIfAbsent(writer, _ -> new ArrayList<>(1));
        if (!all.contains(own)) {
            all.add(own);
        }
    }

    private void unmatch(SampleReader own, Guid writer) {
        own.unmatch(writer);
        List<SampleReader> all = listening.get(writer);
        if (all != null && all.remove(own) && all.isEmpty()) {
            listening.remove(writer);
        }
    }

    private static Addressee addressee(RemoteParticipant other, EndpointData endpoint) {
        if (endpoint.locators().isEmpty()) {
            return other.userTraffic;
        }
        InetSocketAddress known = other.metatraffic.addresses().isEmpty()
                ? new InetSocketAddress(0)
                : other.metatraffic.addresses().getFirst();
        return Addressee.of(other.data.prefix(), endpoint.locators(), known);
    }
}
