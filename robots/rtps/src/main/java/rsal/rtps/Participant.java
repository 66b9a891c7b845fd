package rsal.rtps;

import java.net.InetSocketAddress;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.ArrayList;
import java.util.Collection;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.OptionalLong;
import java.util.Set;
import java.util.function.Consumer;
import rsal.rtps.WriterProxy.Arrival;
import rsal.rtps.discovery.BuiltinEndpoint;
import rsal.rtps.discovery.EndpointData;
import rsal.rtps.discovery.ParticipantData;
import rsal.rtps.discovery.Qos;
import rsal.rtps.wire.EntityId;
import rsal.rtps.wire.Guid;
import rsal.rtps.wire.GuidPrefix;
import rsal.rtps.wire.InvalidRtps;
import rsal.rtps.wire.MessageReader;
import rsal.rtps.wire.MessageReader.Origin;
import rsal.rtps.wire.MessageWriter;
import rsal.rtps.wire.ParameterId;
import rsal.rtps.wire.ParameterList;
import rsal.rtps.wire.Submessage;
import rsal.rtps.wire.Submessage.Content;

/// One that takes part in a DDS domain: finds others, tells them of its writers and readers, and exchanges samples.
///
/// This is the protocol only: datagrams and times are handed in, and nothing happens between the calls. So whole
/// networks, with loss and delay, run in a test. Of one thread at a time. All times `now` are of one clock that never
/// goes back [ns].
public final class Participant {
    private final ParticipantData self;
    private final byte[] announced; // what it says of itself
    private final Announcements announcements;
    private final RtpsLimits limits;
    private final GraphListener graph;
    private final DatagramOutbox outbox;
    private final AssemblyBudget budget;
    private final WriterExchange exchange;
    private final Map<BuiltinEndpoint, SampleWriter> tellers = new LinkedHashMap<>();
    private final Map<BuiltinEndpoint, SampleReader> hearers = new LinkedHashMap<>();
    private final OwnEndpoints own; // with the tellers and hearers
    private final Map<GuidPrefix, RemoteParticipant> others = new LinkedHashMap<>();
    private final Set<GuidPrefix> refused = new HashSet<>();
    private int entities;
    private int endpoints; // of others
    private long due;
    private long now;
    private boolean isToGroup; // the datagram that is being received
    private long malformed;
    private long surplus;

    /// @param self as it announces itself; its built-in endpoints are [BuiltinEndpoint#ALL]
    /// @param fragmentSize most of a sample that one datagram has [B], up to 65,000: less than packets of
    ///     the network have, or more where all is on one machine
    /// @param graph hears who is there
    /// @param now [ns]
    public Participant(
            ParticipantData self,
            int fragmentSize,
            RtpsLimits limits,
            Transmitter network,
            GraphListener graph,
            long now) {
        if (fragmentSize < 256 || fragmentSize > MessageWriter.MOST - MessageWriter.OVERHEAD) {
            throw new IllegalArgumentException("Fragments of %d bytes do not fit datagrams.".formatted(fragmentSize));
        }
        this.self = self;
        announced = DiscoveryMessages.parameters(self::write);
        announcements = new Announcements(self, now);
        this.limits = limits;
        this.graph = graph;
        this.now = now;
        own = new OwnEndpoints(graph);
        outbox = new DatagramOutbox(self.prefix(), network, fragmentSize);
        budget = new AssemblyBudget(limits);
        exchange = new WriterExchange(outbox, fragmentSize, limits);
        due = now;
        for (BuiltinEndpoint builtin : BuiltinEndpoint.RELIABLE) {
            Qos qos = Qos.LATCHED.keep(Qos.KEEP_ALL);
            var teller = new SampleWriter(endpoint(builtin.writer(), "", "", qos, ""), exchange);
            var hearer = new SampleReader(
                    endpoint(builtin.reader(), "", "", qos, ""), budget, sample -> hear(builtin, sample));
            tellers.put(builtin, teller);
            hearers.put(builtin, hearer);
            own.add(teller, List.of(), now);
            own.add(hearer, List.of(), now);
        }
        publishThatWeLive();
    }

    private EndpointData endpoint(EntityId entity, String topic, String type, Qos qos, String userData) {
        return new EndpointData(new Guid(self.prefix(), entity), topic, type, qos, List.of(), userData);
    }

    /// One sample for all time: the leases of our writers never end (DDSI-RTPS 2.5, 8.4.13).
    private void publishThatWeLive() {
        var sample = ByteBuffer.allocate(28).order(ByteOrder.LITTLE_ENDIAN);
        sample.put(new byte[] {0, 1, 0, 0}); // CDR_LE
        var guid = new Guid(self.prefix(), new EntityId(1)); // the kind of liveliness: automatic
        guid.write(sample);
        sample.putInt(1); // one octet of data, as Cyclone DDS sends
        teller(BuiltinEndpoint.LIVELINESS).write(guid, 0, Content.DATA, Optional.empty(), sample.array(), now);
    }

    private SampleWriter teller(BuiltinEndpoint builtin) {
        return Objects.requireNonNull(tellers.get(builtin)); // it has all of them
    }

    public ParticipantData self() {
        return self;
    }

    /// All other participants that are there.
    public Collection<ParticipantData> participants() {
        return others.values().stream().map(other -> other.data).toList();
    }

    /// All writers and readers of others.
    public List<EndpointData> endpoints() {
        return others.values().stream()
                .flatMap(other -> other.endpoints.values().stream())
                .toList();
    }

    /// How many datagrams were malformed in whole or in part.
    public long malformed() {
        return malformed;
    }

    /// How many participants and endpoints were refused because there are too many.
    public long surplus() {
        return surplus;
    }

    /// @param userData that others see; empty for none
    public SampleWriter createWriter(String topic, String type, Qos qos, String userData, long time) {
        advance(time);
        EndpointData data = endpoint(EntityId.writer(++entities), topic, type, qos, userData);
        var writer = new SampleWriter(data, exchange);
        announce(BuiltinEndpoint.PUBLICATIONS, data);
        own.add(writer, others.values(), now);
        wake(now);
        outbox.flush();
        return writer;
    }

    /// @param listener gets the samples
    public SampleReader createReader(
            String topic, String type, Qos qos, String userData, SampleListener listener, long time) {
        advance(time);
        EndpointData data = endpoint(EntityId.reader(++entities), topic, type, qos, userData);
        var reader = new SampleReader(data, budget, new Hearing(listener, data));
        announce(BuiltinEndpoint.SUBSCRIPTIONS, data);
        own.add(reader, others.values(), now);
        wake(now);
        outbox.flush();
        return reader;
    }

    /// @param timestamp when the sample is from [ns] since 1970
    /// @param inlineQos writes what goes beside it, without an end; at most 128 B
    /// @param payload with its encapsulation header; not changed any more
    /// @return the number of the sample; empty when the writer keeps all and has no room: then nothing is
    ///     written
    public OptionalLong write(
            SampleWriter writer,
            long timestamp,
            Optional<Consumer<ParameterList.Writer>> inlineQos,
            byte[] payload,
            long time) {
        advance(time);
        OptionalLong number = writer.write(timestamp, inlineQos, payload, now);
        wake(writer.due());
        outbox.flush();
        return number;
    }

    /// Writes a sample that one participant waits for, when a reader of it is there and ready; at most 5 s later.
    public void write(SampleWriter writer, Reply reply, long time) {
        advance(time);
        writer.write(reply, now);
        wake(writer.due());
        outbox.flush();
    }

    /// Nothing more is written by it. It goes when all reliable readers have its samples, at most half a second later.
    public void remove(SampleWriter writer, long time) {
        advance(time);
        own.release(writer, now);
        wake(now);
    }

    /// Whether all reliable readers of others have all that was written.
    public boolean isAcknowledged() {
        return own.writers().filter(each -> !tellers.containsValue(each)).allMatch(SampleWriter::isAcknowledged);
    }

    public void remove(SampleReader reader, long time) {
        advance(time);
        if (own.remove(reader)) {
            withdraw(BuiltinEndpoint.SUBSCRIPTIONS, reader.data().guid());
            wake(now);
            outbox.flush();
        }
    }

    /// The reader's listener has room again ([SampleListener#hasRoom]).
    public void resume(SampleReader reader, long time) {
        advance(time);
        wake(own.resume(reader, now));
    }

    /// Tells all others that this participant leaves. Twice, since the first message can be lost.
    public void close(long time) {
        advance(time);
        for (int i = 0; i < 2; i++) {
            DiscoveryMessages.leave(outbox.toAll(), self.prefix());
            outbox.announce(Set.of());
            others.values().forEach(other -> DiscoveryMessages.leave(outbox.to(other.metatraffic), self.prefix()));
            outbox.flush();
        }
    }

    /// @param datagram from its position to its limit; used again afterwards
    /// @param isToGroup whether it came by the multicast group
    public void receive(ByteBuffer datagram, InetSocketAddress from, boolean isToGroup, long time) {
        advance(time);
        this.isToGroup = isToGroup;
        try {
            MessageReader.read(datagram, (origin, submessage) -> receive(origin, submessage, from));
        } catch (InvalidRtps e) {
            malformed++;
        }
        outbox.flush();
    }

    /// Does what is due, such as telling again what nobody acknowledged.
    ///
    /// @return when it is next to be called [ns]; earlier after other calls ([#due()])
    public long tick(long time) {
        advance(time);
        if (now >= due) {
            due = now; // if a listener fails, what is left is done next time
            announcements.announce(outbox, announced, others.values(), now);
            long earliestExpiry = expire();
            own.dismiss(now)
                    .forEach(gone ->
                            withdraw(BuiltinEndpoint.PUBLICATIONS, gone.data().guid()));
            due = Math.min(announcements.due(), earliestExpiry);
            wake(own.tick(outbox, now));
            outbox.flush();
        }
        return due;
    }

    /// When [#tick] is next to be called [ns].
    public long due() {
        return due;
    }

    private void advance(long time) {
        now = Math.max(now, time);
    }

    private void wake(long at) {
        due = Math.min(due, at);
    }

    /// @return when the next participant goes unless it announces itself again [ns]
    private long expire() {
        long earliest = Long.MAX_VALUE;
        var gone = new ArrayList<RemoteParticipant>(0);
        for (RemoteParticipant other : others.values()) {
            if (now >= other.expiry) {
                gone.add(other);
            } else {
                earliest = Math.min(earliest, other.expiry);
            }
        }
        gone.forEach(this::lose);
        return earliest;
    }

    private void announce(BuiltinEndpoint to, EndpointData data) {
        teller(to)
                .write(data.guid(), 0, Content.DATA, Optional.empty(), DiscoveryMessages.parameters(data::write), now);
    }

    private void withdraw(BuiltinEndpoint from, Guid guid) {
        teller(from)
                .write(
                        guid,
                        0,
                        Content.KEY,
                        DiscoveryMessages.gone(guid),
                        DiscoveryMessages.key(ParameterId.ENDPOINT_GUID, guid),
                        now);
    }

    private void receive(Origin origin, Submessage submessage, InetSocketAddress from) {
        boolean forUs = origin.destination().equals(GuidPrefix.UNKNOWN)
                || origin.destination().equals(self.prefix());
        if (origin.source().equals(self.prefix()) || !forUs) {
            return;
        }
        if (submessage.writer().equals(EntityId.PARTICIPANT_WRITER)) {
            if (submessage instanceof Submessage.Data data) {
                onParticipant(origin, data, from);
            }
            return;
        }
        Guid writer = origin.guid(submessage.writer());
        switch (submessage) {
            case Submessage.Data data ->
                own.proxies(
                        writer, data.reader(), proxy -> proxy.receive(Arrival.of(writer, origin.timestamp(), data)));
            case Submessage.DataFragments part ->
                own.proxies(writer, part.reader(), proxy -> {
                    proxy.receive(part, origin.timestamp(), now);
                    wake(proxy.due());
                });
            case Submessage.Heartbeat heartbeat ->
                own.proxies(writer, heartbeat.reader(), proxy -> {
                    proxy.receive(heartbeat, now);
                    proxy.request(outbox, now);
                    wake(proxy.due());
                });
            case Submessage.Gap gap -> own.proxies(writer, gap.reader(), proxy -> proxy.receive(gap));
            case Submessage.AckNack answer ->
                own.writer(answer.writer()).ifPresent(its -> {
                    its.receive(origin, answer, now);
                    wake(own.isLeaving(its) ? now : its.due());
                });
            case Submessage.NackFragments nack ->
                own.writer(nack.writer()).ifPresent(its -> {
                    its.receive(origin, nack, now);
                    wake(its.due());
                });
        }
    }

    private void onParticipant(Origin origin, Submessage.Data sample, InetSocketAddress from) {
        try {
            if (DiscoveryMessages.isGone(sample.inlineQos())) {
                RemoteParticipant other = others.get(origin.source());
                if (other != null) {
                    lose(other);
                }
                return;
            }
            RemoteParticipant known = others.get(origin.source());
            if (known != null && known.hasSaid(sample.payload())) {
                isAlive(known);
            } else if (sample.content() == Content.DATA) {
                ParticipantData data = ParticipantData.of(DiscoveryMessages.list(sample.payload()));
                boolean isOfOurDomain =
                        data.domain().equals(self.domain()) || data.domain().isEmpty();
                if (data.prefix().equals(origin.source())
                        && isOfOurDomain
                        && data.domainTag().isEmpty()) {
                    meet(data, from, sample.payload());
                }
            }
        } catch (InvalidRtps e) {
            malformed++;
        }
    }

    private void isAlive(RemoteParticipant other) {
        other.isAlive(now, isToGroup);
        wake(other.expiry);
    }

    private void meet(ParticipantData data, InetSocketAddress from, ByteBuffer payload) {
        RemoteParticipant known = others.get(data.prefix());
        if (known != null && !known.isWhereItWas(data)) {
            lose(known); // it comes again
            known = null;
        }
        if (known == null) {
            if (others.size() >= limits.participants()) {
                if (refused.size() < limits.participants() && refused.add(data.prefix())) {
                    surplus++;
                }
                return;
            }
            known = new RemoteParticipant(
                    data,
                    Addressee.of(data.prefix(), data.metatraffic(), from),
                    Addressee.of(data.prefix(), data.userTraffic(), from));
            others.put(data.prefix(), known);
            welcome(known);
            graph.onParticipant(data);
        }
        known.says(payload);
        isAlive(known);
    }

    /// So that it does not have to wait for the next announcement.
    private void welcome(RemoteParticipant other) {
        DiscoveryMessages.announce(outbox.sample(other.metatraffic, announced.length), announced);
        for (BuiltinEndpoint builtin : BuiltinEndpoint.RELIABLE) {
            if ((other.data.builtinEndpoints() & builtin.writerBit()) != 0) {
                SampleReader hearer = Objects.requireNonNull(hearers.get(builtin));
                var writer = new Guid(other.data.prefix(), builtin.writer());
                own.match(hearer, other.metatraffic, writer, true, now);
                Objects.requireNonNull(hearer.writers().get(writer)).request(outbox, now); // in the same datagram
            }
            if ((other.data.builtinEndpoints() & builtin.readerBit()) != 0) {
                teller(builtin)
                        .match(new Guid(other.data.prefix(), builtin.reader()), other.metatraffic, Qos.LATCHED, now);
            }
        }
        wake(now);
    }

    private void lose(RemoteParticipant other) {
        GuidPrefix prefix = other.data.prefix();
        others.remove(prefix);
        refused.clear();
        own.forgetAll(prefix);
        endpoints -= other.endpoints.size();
        other.endpoints.keySet().forEach(graph::onEndpointLost);
        graph.onParticipantLost(prefix);
    }

    /// What another participant tells of its writers and readers.
    private void hear(BuiltinEndpoint builtin, Arrival sample) {
        RemoteParticipant other = others.get(sample.writer().prefix());
        if (other == null || builtin.equals(BuiltinEndpoint.LIVELINESS)) {
            return;
        }
        boolean isWriter = builtin.equals(BuiltinEndpoint.PUBLICATIONS);
        try {
            if (DiscoveryMessages.isGone(sample.inlineQos())) {
                DiscoveryMessages.key(sample).ifPresent(guid -> forget(other, guid));
            } else if (sample.content() == Content.DATA) {
                EndpointData data = EndpointData.of(DiscoveryMessages.list(sample.payload()), isWriter);
                if (data.guid().prefix().equals(other.data.prefix()) && data.isWriter() == isWriter) {
                    learn(other, data);
                }
            }
        } catch (InvalidRtps e) {
            malformed++;
        }
    }

    private void learn(RemoteParticipant other, EndpointData data) {
        EndpointData before = other.endpoints.get(data.guid());
        if (data.equals(before)) {
            return;
        }
        boolean isFull = other.endpoints.size() >= limits.endpoints() || endpoints >= limits.allEndpoints();
        if (before != null) {
            forget(other, data.guid());
        } else if (isFull) {
            surplus++;
            return;
        }
        other.endpoints.put(data.guid(), data);
        endpoints++;
        graph.onEndpoint(data);
        own.learn(other, data, now);
        wake(now);
    }

    private void forget(RemoteParticipant other, Guid guid) {
        if (other.endpoints.remove(guid) != null) {
            endpoints--;
            own.forget(guid);
            graph.onEndpointLost(guid);
        }
    }
}
