package rsal.ros2.link;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.CompletionStage;
import java.util.concurrent.ConcurrentHashMap;
import java.util.function.Consumer;
import java.util.function.LongSupplier;
import java.util.random.RandomGenerator;
import rsal.ros2.cdr.CdrWriter;
import rsal.ros2.type.Distribution;
import rsal.ros2.type.TypeHash;
import rsal.ros2.type.TypeLibrary;
import rsal.rtps.GraphListener;
import rsal.rtps.SampleReader;
import rsal.rtps.SampleWriter;
import rsal.rtps.UdpParticipant;
import rsal.rtps.discovery.EndpointData;
import rsal.rtps.discovery.Qos;
import rsal.rtps.wire.EntityId;
import rsal.rtps.wire.Guid;

/// ROS 2 over DDS: names and types as `rmw` makes them, hashes of types, and one node that tools see
/// (`ros_discovery_info`).
public final class RtpsLink implements RosLink {
    private static final String TOPIC = "rt"; // what DDS names of topics begin with
    private static final String REQUEST = "rq";
    private static final String REPLY = "rr";
    private static final String GRAPH = "ros_discovery_info";
    private static final String GRAPH_TYPE = "rmw_dds_common::msg::dds_::ParticipantEntitiesInfo_";
    private static final int HUMBLE_GID = 24; // bytes, the last of which are 0; others have Guid.BYTES

    private final UdpParticipant participant;
    private final Distribution distribution;
    private final TypeLibrary types;
    private final String node;
    private final SampleWriter graph;
    private final Set<Guid> writers = ConcurrentHashMap.newKeySet();
    private final Set<Guid> readers = ConcurrentHashMap.newKeySet();

    /// @param distribution of ROS 2 whose types are used
    /// @param node as tools show it
    /// @param clock of real time [ns], such as `System::nanoTime`
    public RtpsLink(
            UdpParticipant.Options options,
            Distribution distribution,
            String node,
            LongSupplier clock,
            RandomGenerator random)
            throws IOException {
        this.distribution = distribution;
        this.types = TypeLibrary.of(distribution);
        this.node = node;
        participant = new UdpParticipant(options, clock, random, GraphListener.NONE);
        graph = participant.createWriter(GRAPH, GRAPH_TYPE, Qos.LATCHED, "");
        tellOfNode();
    }

    @Override
    public List<RosEndpoint> endpoints() {
        return participant.endpoints().stream()
                .flatMap(each -> endpoint(each).stream())
                .toList();
    }

    /// As ROS names it; empty for what is none of its topics.
    public static Optional<RosEndpoint> endpoint(EndpointData data) {
        Optional<String> type = rosType(data.type());
        if (!data.topic().startsWith(TOPIC + "/") || type.isEmpty()) {
            return Optional.empty();
        }
        var topic = new RosTopic(data.topic().substring(TOPIC.length()), type.get());
        return Optional.of(new RosEndpoint(topic, data.isWriter(), profile(data.qos())));
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
    private String userData(RosTopic topic) {
        return distribution == Distribution.HUMBLE
                ? ""
                : types.find(topic.type())
                        .map(type -> "typehash=%s;".formatted(TypeHash.of(type, types)))
                        .orElse("");
    }

    @Override
    public Publication advertise(RosTopic topic, Profile profile) {
        SampleWriter writer =
                participant.createWriter(TOPIC + topic.name(), ddsType(topic.type()), qos(profile), userData(topic));
        Guid guid = writer.data().guid();
        writers.add(guid);
        tellOfNode();
        return new Publication() {
            @Override
            public void publish(long time, byte[] message) {
                participant.write(writer, time, message);
            }

            @Override
            public void close() {
                participant.remove(writer);
                writers.remove(guid);
                tellOfNode();
            }
        };
    }

    @Override
    public Subscribed subscribe(RosTopic topic, Profile profile, Consumer<ByteBuffer> listener) {
        SampleReader reader = participant.createReader(
                TOPIC + topic.name(),
                ddsType(topic.type()),
                qos(profile),
                userData(topic),
                sample -> listener.accept(sample.payload()));
        Guid guid = reader.data().guid();
        readers.add(guid);
        tellOfNode();
        return new Subscribed() {
            @Override
            public int publishers() {
                return participant.matched(reader);
            }

            @Override
            public void close() {
                participant.remove(reader);
                readers.remove(guid);
                tellOfNode();
            }
        };
    }

    @Override
    public ServiceClient client(String name, String type) {
        SampleWriter requests = participant.createWriter(
                REQUEST + name + "Request",
                ddsType(type + "_Request"),
                Qos.DEFAULT,
                userData(new RosTopic(name, type + "_Request")));
        var client = new RtpsClient(participant, requests);
        SampleReader replies = participant.createReader(
                REPLY + name + "Reply",
                ddsType(type + "_Response"),
                Qos.DEFAULT,
                userData(new RosTopic(name, type + "_Response")),
                client::take);
        client.repliesTo(replies);
        writers.add(requests.data().guid());
        readers.add(replies.data().guid());
        tellOfNode();
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
                participant.remove(requests);
                participant.remove(replies);
                writers.remove(requests.data().guid());
                readers.remove(replies.data().guid());
                tellOfNode();
            }
        };
    }

    @Override
    public Served serve(String name, String type, Server server) {
        SampleWriter replies = participant.createWriter(
                REPLY + name + "Reply",
                ddsType(type + "_Response"),
                Qos.DEFAULT,
                userData(new RosTopic(name, type + "_Response")));
        var serving = new RtpsServer(participant, replies, server);
        SampleReader requests = participant.createReader(
                REQUEST + name + "Request",
                ddsType(type + "_Request"),
                Qos.DEFAULT,
                userData(new RosTopic(name, type + "_Request")),
                serving::take);
        writers.add(replies.data().guid());
        readers.add(requests.data().guid());
        tellOfNode();
        return () -> {
            participant.remove(requests);
            participant.remove(replies);
            writers.remove(replies.data().guid());
            readers.remove(requests.data().guid());
            tellOfNode();
        };
    }

    /// `rmw_dds_common/msg/ParticipantEntitiesInfo`: which node has which writers and readers.
    private void tellOfNode() {
        var info = new CdrWriter();
        Guid self = new Guid(graph.data().guid().prefix(), EntityId.PARTICIPANT);
        info.int8s(gid(self)).int32(1).text("/").text(node);
        gids(info, readers);
        gids(info, writers);
        participant.write(graph, 0, info.toBytes());
    }

    private void gids(CdrWriter info, Set<Guid> all) {
        List<Guid> now = List.copyOf(all);
        info.int32(now.size());
        now.forEach(each -> info.int8s(gid(each)));
    }

    private byte[] gid(Guid guid) {
        var bytes = ByteBuffer.allocate(distribution == Distribution.HUMBLE ? HUMBLE_GID : Guid.BYTES);
        guid.write(bytes);
        return bytes.array();
    }

    @Override
    public void close() {
        participant.close();
    }
}
