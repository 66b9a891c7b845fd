package rsal.rtps;

import java.nio.ByteBuffer;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalLong;
import java.util.function.Consumer;
import java.util.stream.Collectors;
import java.util.stream.LongStream;
import rsal.rtps.ReaderProxy.Stream;
import rsal.rtps.discovery.EndpointData;
import rsal.rtps.discovery.Qos;
import rsal.rtps.wire.EntityId;
import rsal.rtps.wire.Guid;
import rsal.rtps.wire.GuidPrefix;
import rsal.rtps.wire.MessageReader.Origin;
import rsal.rtps.wire.NumberSet;
import rsal.rtps.wire.ParameterList;
import rsal.rtps.wire.Submessage.AckNack;
import rsal.rtps.wire.Submessage.Content;
import rsal.rtps.wire.Submessage.Gap;
import rsal.rtps.wire.Submessage.Heartbeat;
import rsal.rtps.wire.Submessage.NackFragments;

/// A writer of ours: keeps samples, sends them to its readers, and again to those who lack them.
///
/// A reliable one that keeps all ([Qos#KEEP_ALL]) loses nothing that a reliable reader lacks: it refuses what
/// is written while it has no room ([RtpsLimits#kept]), and says when it has.
///
/// Samples that fit into no datagram go in fragments, some at a time, so that they do not fill the buffers of
/// those who receive them.
public final class SampleWriter {
    private static final long MILLISECOND = 1_000_000; // ns
    private static final int BURST = 128 << 10; // B of fragments to one reader in a millisecond
    private static final int MOST_REPAIRED = 256 << 10; // B of samples sent again at once
    private static final long BETWEEN_REPAIRS = 2 * MILLISECOND;

    private final EndpointData data;
    private final WriterExchange exchange;
    private final WriterHistory history;
    private final Map<Guid, ReaderProxy> readers = new LinkedHashMap<>();
    private final List<Neighbor> neighbors = new ArrayList<>();
    private final HeldReplies held = new HeldReplies();
    private Runnable roomListener = () -> {};
    private boolean hasRefused; // since there was room
    private long last;
    private int heartbeats;

    /// A reader of the same participant.
    private final class Neighbor implements SampleReader.Source {
        final SampleReader reader;
        long taken; // up to this number

        Neighbor(SampleReader reader, long taken) {
            this.reader = reader;
            this.taken = taken;
        }

        @Override
        public boolean deliverNext() {
            Optional<KeptSample> next = history.after(taken);
            if (next.isEmpty() || !reader.hasRoom()) {
                return false;
            }
            taken = next.get().number(); // before its listener writes another one
            reader.deliver(arrival(next.get()));
            return true;
        }

        void deliver() {
            while (deliverNext()) {
                // and the next one
            }
        }
    }

    SampleWriter(EndpointData data, WriterExchange exchange) {
        this.data = data;
        this.exchange = exchange;
        history = new WriterHistory(data.qos(), exchange.limits());
    }

    /// As it is announced.
    public EndpointData data() {
        return data;
    }

    /// How many readers it has.
    public int matched() {
        return readers.size() + neighbors.size();
    }

    /// Whether all reliable readers have all samples, those of the same participant too.
    public boolean isAcknowledged() {
        return readers.values().stream().allMatch(each -> !each.isReliable || each.acknowledged >= last)
                && neighbors.stream().allMatch(each -> each.taken >= last);
    }

    /// Its reliable readers, each with how many samples it lacks.
    Map<Guid, Long> unacknowledged() {
        return readers.values().stream()
                .filter(each -> each.isReliable && each.isReady)
                .collect(Collectors.toMap(each -> each.guid, each -> last - each.acknowledged));
    }

    /// Told once after a sample was refused, when another one may have room. Called while the participant is
    /// locked: be quick, and call nothing of it.
    void onRoom(Runnable listener) {
        roomListener = listener;
    }

    /// Who reads it, of other participants, and takes what is written from now on.
    List<Guid> readers() {
        return readers.values().stream()
                .filter(each -> each.isReady)
                .map(each -> each.guid)
                .toList();
    }

    /// @param timestamp [ns] since 1970
    /// @param inlineQos writes what goes beside it, without an end; at most 128 B
    /// @param payload with its encapsulation header; not changed any more
    /// @param now [ns]
    /// @return the number of the sample; empty when it is refused
    OptionalLong write(long timestamp, Optional<Consumer<ParameterList.Writer>> inlineQos, byte[] payload, long now) {
        if (!history.makesRoom(payload.length)) {
            hasRefused = true;
            return OptionalLong.empty();
        }
        var sample = new KeptSample(last + 1, timestamp, inlineQos, Content.DATA, payload);
        long forgotten = history.add(sample);
        if (forgotten > 0) { // best effort means that of two the newer one matters
            readers.values()
                    .forEach(reader ->
                            reader.streams.removeIf(each -> each.sample().number() <= forgotten));
        }
        write(sample, now);
        return OptionalLong.of(sample.number());
    }

    /// Writes a sample when a reader of the participant is there and ready, or 5 s later: a client's request
    /// may come before its reader of replies is known here, which would miss the reply. Where it is refused
    /// even then, it is left out.
    void write(Reply reply, long now) {
        boolean isDone = (isReady(reply.to()) || !held.hasRoom(reply)) && writeNow(reply, now);
        if (!isDone && held.hasRoom(reply)) { // else it is lost, as is allowed for replies that nobody takes
            held.add(reply, now);
        }
    }

    private boolean writeNow(Reply reply, long now) {
        return write(reply.timestamp(), reply.inlineQos(), reply.payload(), now).isPresent();
    }

    /// Whether a client would get a reply: its reader, or all that its participant has, as far as they are known.
    private boolean isReady(Guid client) {
        if (client.prefix().equals(data.guid().prefix())) {
            return true; // a neighbor
        }
        if (client.entity().isReader()) {
            ReaderProxy reader = readers.get(client);
            return reader != null && reader.isReady;
        }
        List<ReaderProxy> its = readers.values().stream()
                .filter(each -> each.guid.prefix().equals(client.prefix()))
                .toList();
        return !its.isEmpty() && its.stream().allMatch(each -> each.isReady);
    }

    private void release(long now) {
        held.release(reply -> isReady(reply.to()), reply -> writeNow(reply, now), now);
    }

    /// @param key of which this replaces the sample before
    void write(
            Guid key,
            long timestamp,
            Content content,
            Optional<Consumer<ParameterList.Writer>> inlineQos,
            byte[] payload,
            long now) {
        var sample = new KeptSample(last + 1, timestamp, inlineQos, content, payload);
        history.add(key, sample);
        write(sample, now);
    }

    private void write(KeptSample sample, long now) {
        last = sample.number();
        neighbors.forEach(Neighbor::deliver);
        if (!readers.isEmpty()) {
            send(sample, now);
        }
        settle();
    }

    /// Forgets what all readers have, and says that there is room.
    void settle() {
        if (!history.keepsAll() || data.topic().isEmpty()) { // those of the built-in topics keep one for each key
            return;
        }
        long all = last;
        for (ReaderProxy reader : readers.values()) {
            all = reader.isReliable ? Math.min(all, reader.acknowledged) : all;
        }
        for (Neighbor neighbor : neighbors) {
            all = Math.min(all, neighbor.taken);
        }
        if (history.acknowledge(all) && hasRefused) {
            hasRefused = false;
            roomListener.run();
        }
    }

    private WriterProxy.Arrival arrival(KeptSample sample) {
        return new WriterProxy.Arrival(
                data.guid(),
                sample.number(),
                sample.timestamp(),
                ParameterList.EMPTY,
                sample.content(),
                ByteBuffer.wrap(sample.payload()).asReadOnlyBuffer(),
                false);
    }

    /// One datagram to each participant that has readers of it, or the first fragments.
    private void send(KeptSample sample, long now) {
        if (isLarge(sample)) {
            readers.values().forEach(reader -> begin(reader, sample, now));
            return;
        }
        var groups = new LinkedHashMap<Addressee, List<ReaderProxy>>();
        readers.values()
                .forEach(reader -> groups.computeIfAbsent(reader.addressee, _ -> new ArrayList<>(1))
                        .add(reader));
        groups.forEach((addressee, group) -> {
            EntityId to = group.size() == 1 ? group.getFirst().guid.entity() : EntityId.UNKNOWN;
            put(sample, addressee, to);
            if (group.stream().anyMatch(reader -> reader.isReliable)) {
                heartbeat(addressee, to, false);
                group.forEach(reader -> reader.expectAnswer(now));
            }
        });
    }

    private boolean isLarge(KeptSample sample) {
        return sample.payload().length > exchange.fragmentSize();
    }

    private void begin(ReaderProxy reader, KeptSample sample, long now) {
        reader.stream(sample).fragments().set(0, fragments(sample));
        stream(reader, now);
    }

    private int fragments(KeptSample sample) {
        return (sample.payload().length + exchange.fragmentSize() - 1) / exchange.fragmentSize();
    }

    /// Sends the next fragments to a reader, if that is due.
    private void stream(ReaderProxy reader, long now) {
        if (reader.streams.isEmpty() || reader.paced > now - MILLISECOND) {
            return;
        }
        reader.paced = now;
        int sent = 0;
        while (sent < BURST && !reader.streams.isEmpty()) {
            Stream stream = reader.streams.getFirst();
            KeptSample sample = stream.sample();
            int fragment = stream.fragments().nextSetBit(0);
            if (fragment < 0) {
                reader.streams.removeFirst();
                continue;
            }
            stream.fragments().clear(fragment);
            exchange.outbox()
                    .sample(reader.addressee, exchange.fragmentSize())
                    .timestamp(sample.timestamp())
                    .fragment(
                            reader.guid.entity(),
                            data.guid().entity(),
                            sample.number(),
                            fragment + 1,
                            exchange.fragmentSize(),
                            sample.inlineQos(),
                            sample.payload());
            if (stream.fragments().isEmpty()) {
                reader.streams.removeFirst();
                if (reader.isReliable && reader.streams.isEmpty()) {
                    heartbeat(reader, false);
                    reader.expectAnswer(now);
                }
            }
            sent += exchange.fragmentSize();
        }
    }

    /// @param wanted the reader's quality of service
    void match(Guid reader, Addressee addressee, Qos wanted, long now) {
        if (readers.containsKey(reader)) {
            return;
        }
        boolean reliable = wanted.isReliable() && data.qos().isReliable();
        boolean late = wanted.isLatched() && data.qos().isLatched();
        var proxy = new ReaderProxy(reader, addressee, reliable, late && reliable ? 0 : last, now);
        readers.put(reader, proxy);
        if (reliable) {
            if (proxy.start > 0) {
                exchange.outbox().to(addressee).gap(gap(reader.entity(), 1, NumberSet.empty(proxy.start + 1)));
            }
            heartbeat(proxy, false);
            proxy.reported(now);
        }
        settle(); // it may lack samples that all others have
    }

    void matchNeighbor(SampleReader reader) {
        boolean late = reader.data().qos().isLatched() && data.qos().isLatched();
        var neighbor = new Neighbor(reader, late ? 0 : last);
        neighbors.add(neighbor);
        reader.add(neighbor);
        neighbor.deliver();
        settle();
    }

    /// It writes no more, and what its neighbors have not taken is lost.
    void close() {
        neighbors.forEach(each -> each.reader.remove(each));
    }

    void unmatch(Guid reader) {
        readers.remove(reader);
        neighbors.removeIf(each -> each.reader.data().guid().equals(reader));
        settle();
    }

    void unmatchAll(GuidPrefix participant) {
        readers.keySet().removeIf(each -> each.prefix().equals(participant));
        held.forget(participant);
        settle();
    }

    /// Sends what a reader lacks, and tells it what never comes.
    void receive(Origin origin, AckNack answer, long now) {
        ReaderProxy reader = readers.get(origin.guid(answer.reader()));
        if (reader == null || !reader.isReliable || !reader.answered(answer, last, now)) {
            return;
        }
        settle();
        release(now);
        if (answer.missing().isEmpty() || answer.missing().base() < 1) {
            if (!answer.isFinal()) {
                heartbeat(reader, reader.isReady); // until it has answered one
            }
        } else if (now - reader.repaired >= BETWEEN_REPAIRS) {
            reader.repaired = now;
            repair(reader, answer.missing(), now);
        }
    }

    private void repair(ReaderProxy reader, NumberSet missing, long now) {
        var never = new ArrayList<Long>();
        int bytes = 0;
        for (long number : missing.numbers().filter(each -> each <= last).toArray()) {
            Optional<KeptSample> sample = number > reader.start ? history.find(number) : Optional.empty();
            if (sample.isEmpty()) {
                never.add(number);
            } else if (bytes < MOST_REPAIRED) {
                bytes += sample.get().payload().length;
                if (isLarge(sample.get())) {
                    begin(reader, sample.get(), now);
                } else {
                    put(sample.get(), reader.addressee, reader.guid.entity());
                }
            }
        }
        if (!never.isEmpty()) {
            exchange.outbox().to(reader.addressee).gap(gap(reader.guid.entity(), never));
        }
        heartbeat(reader, false);
        reader.reported(now);
    }

    private Gap gap(EntityId reader, List<Long> numbers) {
        int run = 1;
        while (run < numbers.size() && numbers.get(run) == numbers.get(run - 1) + 1) {
            run++;
        }
        long start = numbers.getFirst();
        LongStream more = numbers.stream().skip(run).mapToLong(Long::longValue);
        return gap(reader, start, NumberSet.of(start + run, more));
    }

    private Gap gap(EntityId reader, long start, NumberSet more) {
        return new Gap(reader, data.guid().entity(), start, more);
    }

    /// Sends the fragments that a reader lacks.
    void receive(Origin origin, NackFragments nack, long now) {
        ReaderProxy reader = readers.get(origin.guid(nack.reader()));
        if (reader == null || !reader.isReliable || !reader.isNewNack(nack.count()) || nack.number() <= reader.start) {
            return;
        }
        history.find(nack.number()).filter(this::isLarge).ifPresent(sample -> {
            Stream stream = reader.stream(sample);
            nack.missing()
                    .numbers()
                    .filter(each -> each >= 1 && each <= fragments(sample))
                    .forEach(each -> stream.fragments().set((int) each - 1));
            stream(reader, now);
        });
    }

    /// Sends fragments that are due, and gathers the heartbeats that are: of readers that did not answer.
    void tick(DueParts parts, long now) {
        release(now);
        for (ReaderProxy reader : readers.values()) {
            stream(reader, now);
            if (reader.streams.isEmpty() && reader.heartbeatAt() <= now) {
                parts.add(reader.addressee, () -> heartbeat(reader, false));
                reader.reported(now);
            }
        }
    }

    /// When there is next something to send [ns].
    long due() {
        long due = held.due();
        for (ReaderProxy reader : readers.values()) {
            due = Math.min(due, reader.streams.isEmpty() ? reader.heartbeatAt() : reader.paced + MILLISECOND);
        }
        return due;
    }

    private void put(KeptSample sample, Addressee addressee, EntityId reader) {
        exchange.outbox()
                .sample(addressee, sample.payload().length)
                .timestamp(sample.timestamp())
                .data(
                        reader,
                        data.guid().entity(),
                        sample.number(),
                        sample.inlineQos(),
                        sample.content(),
                        sample.payload());
    }

    private void heartbeat(ReaderProxy reader, boolean isFinal) {
        heartbeat(reader.addressee, reader.guid.entity(), isFinal);
    }

    private void heartbeat(Addressee addressee, EntityId reader, boolean isFinal) {
        exchange.outbox()
                .heartbeat(
                        addressee,
                        new Heartbeat(reader, data.guid().entity(), history.first(last), last, ++heartbeats, isFinal));
    }
}
