package rsal.ros2.link;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.CompletionStage;
import java.util.concurrent.ConcurrentHashMap;
import java.util.function.BiConsumer;
import java.util.function.Consumer;
import java.util.function.LongSupplier;
import java.util.random.RandomGenerator;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import rsal.ros2.type.Distribution;
import rsal.ros2.type.TypeLibrary;
import rsal.rtps.SampleListener;
import rsal.rtps.SampleReader;
import rsal.rtps.SampleWriter;
import rsal.rtps.UdpParticipant;
import rsal.rtps.discovery.EndpointData;
import rsal.rtps.discovery.Qos;
import rsal.rtps.wire.Guid;

/// ROS 2 over DDS: names and types as `rmw` makes them, hashes of types, and nodes that tools see. All nodes
/// of a link share its participant.
public final class RtpsLink implements RosLink {
    private static final String TOPIC = "rt"; // what DDS names of topics begin with
    private static final Pattern TYPE_HASH = Pattern.compile("typehash=(RIHS01_[0-9a-f]{64});"); // in user data
    private static final String REQUEST = "rq";
    private static final String REPLY = "rr";

    private final UdpParticipant participant;
    private final Distribution distribution;
    private final TypeLibrary types;
    private final LongSupplier date;
    private final boolean isOwner; // of the participant
    private final FoundEndpoints found;
    private final NodeGraph graph;
    private final NodeGraph.Node node;
    private final Set<Runnable> ends = ConcurrentHashMap.newKeySet(); // of what is open

    /// @param distribution of ROS 2 whose types are used
    /// @param node the first one, as tools show it
    /// @param clock of real time, which never goes back [ns], such as `System::nanoTime`
    /// @param date of samples: real time [ns] since 1970
    public RtpsLink(
            UdpParticipant.Options options,
            Distribution distribution,
            String node,
            LongSupplier clock,
            LongSupplier date,
            RandomGenerator random)
            throws IOException {
        this.distribution = distribution;
        this.types = TypeLibrary.of(distribution);
        this.date = date;
        this.isOwner = true;
        found = new FoundEndpoints();
        participant = new UdpParticipant(options, clock, random, found);
        graph = new NodeGraph(participant, distribution, date);
        this.node = graph.add("/", node);
    }

    /// Another node of a participant.
    private RtpsLink(RtpsLink owner, String namespace, String name) {
        distribution = owner.distribution;
        types = owner.types;
        date = owner.date;
        isOwner = false;
        participant = owner.participant;
        found = owner.found;
        graph = owner.graph;
        node = graph.add(namespace, name);
    }

    @Override
    public List<RosEndpoint> endpoints() {
        return found.list();
    }

    /// As ROS names it; empty for what is none of its topics.
    public static Optional<RosEndpoint> endpoint(EndpointData data) {
        Optional<String> type = rosType(data.type());
        if (!data.topic().startsWith(TOPIC + "/") || type.isEmpty()) {
            return Optional.empty();
        }
        var topic = new RosTopic(data.topic().substring(TOPIC.length()), type.get());
        return Optional.of(new RosEndpoint(topic, data.isWriter(), profile(data.qos()), typeHash(data.userData())));
    }

    /// The hash of its type that an endpoint announces in its user data.
    static Optional<String> typeHash(String userData) {
        return TYPE_HASH
                .matcher(userData)
                .results()
                .map(found -> found.group(1))
                .findFirst();
    }

    /// `sensor_msgs::msg::dds_::LaserScan_` for `sensor_msgs/msg/LaserScan`.
    static String ddsType(String type) {
        int name = type.lastIndexOf('/') + 1;
        return type.substring(0, name).replace("/", "::") + "dds_::" + type.substring(name) + "_";
    }

    /// The other way round; empty for types that are none of ROS.
    static Optional<String> rosType(String type) {
        String[] parts = type.split("::", -1);
        boolean isOfRos = parts.length == 4 && parts[2].equals("dds_") && parts[3].endsWith("_");
        return isOfRos
                ? Optional.of(String.join("/", parts[0], parts[1], parts[3].substring(0, parts[3].length() - 1)))
                : Optional.empty();
    }

    private static Profile profile(Qos qos) {
        if (!qos.isReliable()) {
            return Profile.SENSOR_DATA;
        }
        return qos.isLatched() ? Profile.LATCHED : Profile.DEFAULT;
    }

    private static Qos qos(Profile profile) {
        return switch (profile) {
            case SENSOR_DATA -> Qos.SENSOR_DATA;
            case DEFAULT -> Qos.DEFAULT;
            case LATCHED -> Qos.LATCHED;
        };
    }

    /// Which Humble does not have.
    private String userData(String type) {
        return distribution == Distribution.HUMBLE
                ? ""
                : types.hash(type).map("typehash=%s;"::formatted).orElse("");
    }

    private SampleWriter writer(String topic, String type, Profile profile) {
        return participant.createWriter(topic, ddsType(type), qos(profile), userData(type));
    }

    private SampleReader reader(String topic, String type, Profile profile, SampleListener listener) {
        return participant.createReader(topic, ddsType(type), qos(profile), userData(type), listener);
    }

    /// Notes that the node has these.
    ///
    /// @return takes them away again, once
    private Runnable opened(List<SampleWriter> newWriters, List<SampleReader> newReaders) {
        graph.opened(node, newWriters, newReaders);
        var end = new Runnable() {
            @Override
            public void run() {
                if (ends.remove(this)) {
                    newReaders.forEach(participant::remove);
                    newWriters.forEach(participant::remove);
                    graph.closed(node, newWriters, newReaders);
                }
            }
        };
        ends.add(end);
        return end;
    }

    @Override
    public RosLink node(String namespace, String name) {
        return new RtpsLink(this, namespace, name);
    }

    @Override
    public void together(Runnable opening) {
        graph.together(opening);
    }

    @Override
    public Publication advertise(RosTopic topic, Profile profile) {
        SampleWriter writer = writer(TOPIC + topic.name(), topic.type(), profile);
        Runnable end = opened(List.of(writer), List.of());
        return new Publication() {
            @Override
            public void publish(byte[] message) {
                participant.write(writer, date.getAsLong(), message);
            }

            @Override
            public Map<String, Long> unacknowledged() {
                return participant.unacknowledged(writer).entrySet().stream()
                        .collect(Collectors.toMap(each -> each.getKey().toString(), Map.Entry::getValue));
            }

            @Override
            public void close() {
                end.run();
            }
        };
    }

    @Override
    public Subscribed subscribe(RosTopic topic, Profile profile, Consumer<ByteBuffer> listener) {
        return listen(topic, profile, sample -> listener.accept(sample.payload()));
    }

    @Override
    public Subscribed subscribeEach(RosTopic topic, Profile profile, BiConsumer<String, ByteBuffer> listener) {
        return listen(topic, profile, sample -> listener.accept(sample.writer().toString(), sample.payload()));
    }

    private Subscribed listen(RosTopic topic, Profile profile, SampleListener listener) {
        SampleReader reader = reader(TOPIC + topic.name(), topic.type(), profile, listener);
        Runnable end = opened(List.of(), List.of(reader));
        return new Subscribed() {
            @Override
            public int publishers() {
                return reader.matched();
            }

            @Override
            public Set<String> publisherIds() {
                return participant.writers(reader).stream().map(Guid::toString).collect(Collectors.toSet());
            }

            @Override
            public void close() {
                end.run();
            }
        };
    }

    @Override
    public String program(String id) {
        return participant.participants().stream()
                .filter(each -> id.startsWith(each.prefix() + ":"))
                .findFirst()
                .map(each -> "'%s' at %s"
                        .formatted(
                                PeerText.shown(each.name()),
                                each.userTraffic().stream()
                                        .flatMap(locator -> locator.unicast().stream())
                                        .map(address -> "%s:%d"
                                                .formatted(address.getAddress().getHostAddress(), address.getPort()))
                                        .findFirst()
                                        .orElse("an unknown address")))
                .orElse("A program that has left");
    }

    @Override
    public ServiceClient client(String name, String type) {
        SampleWriter requests = writer(REQUEST + name + "Request", type + "_Request", Profile.DEFAULT);
        var client = new RtpsClient(participant, requests, date);
        SampleReader replies = reader(REPLY + name + "Reply", type + "_Response", Profile.DEFAULT, client::take);
        client.repliesTo(replies);
        Runnable end = opened(List.of(requests), List.of(replies));
        return new ServiceClient() {
            @Override
            public boolean isAvailable() {
                return client.isAvailable();
            }

            @Override
            public CompletionStage<byte[]> call(byte[] request) {
                return client.call(request);
            }

            @Override
            public void close() {
                end.run();
            }
        };
    }

    @Override
    public Served serve(String name, String type, Server server) {
        SampleWriter replies = writer(REPLY + name + "Reply", type + "_Response", Profile.DEFAULT);
        var serving = new RtpsServer(participant, replies, server, date);
        SampleReader requests = reader(REQUEST + name + "Request", type + "_Request", Profile.DEFAULT, serving::take);
        return opened(List.of(replies), List.of(requests))::run;
    }

    /// Closing what was closed before does nothing.
    @Override
    public void close() {
        if (isOwner) {
            participant.close();
        } else {
            graph.together(() -> {
                List.copyOf(ends).forEach(Runnable::run);
                graph.remove(node);
            });
        }
    }
}
