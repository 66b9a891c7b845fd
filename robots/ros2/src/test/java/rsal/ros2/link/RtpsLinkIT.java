package rsal.ros2.link;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.tuple;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import java.util.SplittableRandom;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionStage;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.FutureTask;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicReference;
import java.util.function.BooleanSupplier;
import java.util.function.Consumer;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import rsal.ros2.cdr.CdrReader;
import rsal.ros2.cdr.CdrWriter;
import rsal.ros2.cdr.InvalidCdr;
import rsal.ros2.cdr.MessageCodec;
import rsal.ros2.cdr.RosMessage;
import rsal.ros2.link.RosLink.ServiceClient;
import rsal.ros2.type.Distribution;
import rsal.ros2.type.TypeLibrary;
import rsal.rtps.GraphListener;
import rsal.rtps.SampleWriter;
import rsal.rtps.UdpParticipant;
import rsal.rtps.discovery.EndpointData;
import rsal.rtps.discovery.Qos;
import rsal.rtps.wire.Guid;
import rsal.rtps.wire.ParameterId;
import rsal.rtps.wire.ParameterList;
import rsal.testkit.OfficialPython;

/// Topics and services over sockets on the loopback network.
class RtpsLinkIT {
    private static final RosTopic CHATTER = new RosTopic("/talk/chatter", "std_msgs/msg/String");
    private static final int PATIENCE_SECONDS = 60;

    private final int domain = 1 + (int) ((ProcessHandle.current().pid() + 37) % 100); // no other test's

    private RtpsLink link(Distribution distribution) throws IOException {
        return new RtpsLink(
                UdpParticipant.Options.local(domain, "test"),
                distribution,
                "tester",
                System::nanoTime,
                () -> TimeUnit.MILLISECONDS.toNanos(System.currentTimeMillis()),
                new SplittableRandom());
    }

    private UdpParticipant participant() throws IOException {
        return new UdpParticipant(
                UdpParticipant.Options.local(domain, "other"),
                System::nanoTime,
                new SplittableRandom(),
                GraphListener.NONE);
    }

    private static void await(BooleanSupplier condition) throws InterruptedException {
        for (int i = 0; i < PATIENCE_SECONDS * 100 && !condition.getAsBoolean(); i++) {
            Thread.sleep(10);
        }
        assertThat(condition.getAsBoolean()).isTrue();
    }

    @Test
    void namesAndTypesAreThoseOfDds() throws Exception {
        try (var here = link(Distribution.JAZZY);
                var there = participant()) {
            here.advertise(CHATTER, Profile.LATCHED);
            here.client("/lights", "std_srvs/srv/SetBool");
            await(() -> there.endpoints().size() >= 4);
            assertThat(there.endpoints())
                    .extracting(EndpointData::topic, EndpointData::type)
                    .contains(
                            tuple("rt/talk/chatter", "std_msgs::msg::dds_::String_"),
                            tuple("rq/lightsRequest", "std_srvs::srv::dds_::SetBool_Request_"),
                            tuple("rr/lightsReply", "std_srvs::srv::dds_::SetBool_Response_"));
            assertThat(there.endpoints())
                    .filteredOn(each -> each.topic().equals("rt/talk/chatter"))
                    .extracting(EndpointData::userData)
                    .containsExactly(
                            "typehash=RIHS01_df668c740482bbd48fb39d76a70dfd4bd59db1288021743503259e948f6b1a18;");
        }
    }

    @Test
    void messagesArriveAndEndpointsAreSeen() throws Exception {
        try (var here = link(Distribution.JAZZY);
                var there = link(Distribution.HUMBLE)) {
            var heard = new CopyOnWriteArrayList<Integer>();
            var publication = here.advertise(CHATTER, Profile.DEFAULT);
            var subscribed = there.subscribe(CHATTER, Profile.DEFAULT, bytes -> heard.add(bytes.remaining()));
            await(() -> subscribed.publishers() == 1
                    && here.endpoints().stream()
                            .anyMatch(each -> each.topic().equals(CHATTER)
                                    && !each.isPublisher()
                                    && each.typeHash().isEmpty())); // as Humble has none
            publication.publish(new CdrWriter().text("hello").toBytes());
            await(() -> heard.size() == 1);
            assertThat(heard.getFirst()).isBetween(14, 16);
            publication.close();
            await(() -> subscribed.publishers() == 0);
        }
    }

    /// With ten topics and a dozen services each, as a bridge has.
    @Test
    void aHundredRobotsAreSeen() throws Exception {
        try (var there = link(Distribution.JAZZY);
                var here = link(Distribution.JAZZY)) {
            there.together(() -> {
                for (int robot = 0; robot < 100; robot++) {
                    RosLink node = there.node("/r" + robot, "rsal");
                    for (int i = 0; i < 12; i++) {
                        node.serve("/r%d/service_%d".formatted(robot, i), "std_srvs/srv/SetBool", _ -> noAnswer());
                    }
                    for (int i = 0; i < 10; i++) {
                        String topic = "/r%d/topic_%d".formatted(robot, i);
                        node.advertise(new RosTopic(topic, "std_msgs/msg/String"), Profile.DEFAULT);
                    }
                }
            });
            await(() -> here.endpoints().size() == 1_000);
            assertThat(here.endpoints()).isSameAs(here.endpoints()); // while nothing changes
        }
    }

    private static CompletionStage<byte[]> noAnswer() {
        return new CompletableFuture<>();
    }

    private record Node(String namespace, String name, int writers, int readers) {
        Node(RosMessage reported) {
            this(
                    reported.text("node_namespace"),
                    reported.text("node_name"),
                    reported.messages("writer_gid_seq").size(),
                    reported.messages("reader_gid_seq").size());
        }
    }

    private static List<Node> nodes(byte[] reported, MessageCodec codec) {
        try {
            return reported.length == 0
                    ? List.of()
                    : codec.read(CdrReader.of(reported)).messages("node_entities_info_seq").stream()
                            .map(Node::new)
                            .toList();
        } catch (InvalidCdr e) {
            throw new AssertionError(e);
        }
    }

    /// Which nodes there are, and which publishers they have, as `ros2 node list` and `ros2 node info` ask.
    @ParameterizedTest
    @ValueSource(strings = {"HUMBLE", "JAZZY"})
    void nodesAreReported(String distribution) throws Exception {
        TypeLibrary types = TypeLibrary.of(Distribution.valueOf(distribution));
        MessageCodec codec = MessageCodec.of(types.get("rmw_dds_common/msg/ParticipantEntitiesInfo"), types);
        var reported = new AtomicReference<byte[]>(new byte[0]);
        try (var here = link(Distribution.valueOf(distribution));
                var there = participant()) {
            here.advertise(CHATTER, Profile.DEFAULT);
            there.createReader(
                    "ros_discovery_info",
                    "rmw_dds_common::msg::dds_::ParticipantEntitiesInfo_",
                    Qos.LATCHED,
                    "",
                    sample -> {
                        var bytes = new byte[sample.payload().remaining()];
                        sample.payload().get(bytes);
                        reported.set(bytes);
                    });
            var first = new Node("/", "tester", 1, 0);
            await(() -> nodes(reported.get(), codec).equals(List.of(first)));
            RosLink robot = here.node("/r1", "rsal");
            robot.subscribe(CHATTER, Profile.DEFAULT, _ -> {});
            robot.advertise(new RosTopic("/r1/odom", "nav_msgs/msg/Odometry"), Profile.DEFAULT);
            await(() -> nodes(reported.get(), codec).equals(List.of(first, new Node("/r1", "rsal", 1, 1))));
            await(() -> there.endpoints().size() == 4);
            robot.close();
            await(() -> nodes(reported.get(), codec).equals(List.of(first))
                    && there.endpoints().size() == 2);
        }
    }

    private static byte[] request(boolean data) {
        return new CdrWriter().bool(data).toBytes();
    }

    private static void answersAreTheirOwn(ServiceClient client) throws Exception {
        TypeLibrary types = TypeLibrary.of(Distribution.JAZZY);
        MessageCodec codec = MessageCodec.of(types.get("std_srvs/srv/SetBool_Response"), types);
        for (boolean data : List.of(true, false, true)) {
            byte[] reply = client.call(request(data)).toCompletableFuture().get(PATIENCE_SECONDS, TimeUnit.SECONDS);
            RosMessage response = codec.read(CdrReader.of(reply));
            assertThat(response.get("success", Boolean.class)).isEqualTo(data);
            assertThat(response.text("message")).startsWith("number ");
        }
    }

    /// With the 16 bytes of `rmw_cyclonedds`.
    @Test
    void cycloneServes() throws Exception {
        var server = new FutureTask<>(() -> OfficialPython.run(script(), Integer.toString(domain), "3"));
        Thread.ofPlatform().start(server);
        try (var here = link(Distribution.JAZZY)) {
            ServiceClient client = here.client("/lights", "std_srvs/srv/SetBool");
            await(() -> client.isAvailable() || server.isDone());
            answersAreTheirOwn(client);
            assertThat(server.get()).isEqualTo("True\nFalse\nTrue\n");
        }
    }

    private static String script() throws IOException {
        try (var in = Objects.requireNonNull(RtpsLinkIT.class.getResourceAsStream("/cyclone_service.py"))) {
            return new String(in.readAllBytes(), StandardCharsets.UTF_8);
        }
    }

    /// With sample identities, under either number, as Fast DDS has them.
    @ParameterizedTest
    @ValueSource(ints = {ParameterId.RELATED_SAMPLE_IDENTITY, ParameterId.RELATED_SAMPLE_IDENTITY_OF_FAST_DDS})
    void othersServe(int parameter) throws Exception {
        try (var here = link(Distribution.JAZZY);
                var there = participant()) {
            SampleWriter replies =
                    there.createWriter("rr/lightsReply", "std_srvs::srv::dds_::SetBool_Response_", Qos.DEFAULT, "");
            var asked = new ArrayList<Boolean>();
            there.createReader("rq/lightsRequest", "std_srvs::srv::dds_::SetBool_Request_", Qos.DEFAULT, "", sample -> {
                ByteBuffer identity = sample.inlineQos()
                        .find(ParameterId.RELATED_SAMPLE_IDENTITY, 24)
                        .orElseThrow();
                Guid client = Guid.read(identity);
                boolean data = sample.payload().get(4) != 0;
                asked.add(data);
                Consumer<ParameterList.Writer> beside = list -> list.put(parameter, to -> {
                    client.write(to);
                    to.putInt(0).putInt((int) sample.number());
                });
                byte[] reply = new CdrWriter()
                        .bool(data)
                        .text("number " + sample.number())
                        .toBytes();
                there.write(replies, 0, Optional.of(beside), reply);
            });
            ServiceClient client = here.client("/lights", "std_srvs/srv/SetBool");
            await(client::isAvailable);
            await(() -> replies.matched() == 1);
            answersAreTheirOwn(client);
            assertThat(asked).containsExactly(true, false, true);
        }
    }

    @Test
    void nobodyThereIsSaid() throws Exception {
        try (var here = link(Distribution.JAZZY)) {
            ServiceClient client = here.client("/lights", "std_srvs/srv/SetBool");
            assertThat(client.isAvailable()).isFalse();
            assertThatThrownBy(() ->
                            client.call(request(true)).toCompletableFuture().get())
                    .hasMessageContaining("Nobody serves 'rq/lightsRequest'.");
        }
    }
}
