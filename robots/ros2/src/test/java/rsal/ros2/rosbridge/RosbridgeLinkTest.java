package rsal.ros2.rosbridge;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.net.URI;
import java.nio.ByteBuffer;
import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.SplittableRandom;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionStage;
import java.util.stream.IntStream;
import org.assertj.core.api.InstanceOfAssertFactories;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import rsal.data.LaserScan;
import rsal.data.Odometry;
import rsal.data.Pose2d;
import rsal.data.Twist2d;
import rsal.ros2.MemoryNetwork;
import rsal.ros2.action.ActionClient;
import rsal.ros2.cdr.CdrWriter;
import rsal.ros2.cdr.RosMessage;
import rsal.ros2.link.Profile;
import rsal.ros2.link.RosEndpoint;
import rsal.ros2.link.RosLink;
import rsal.ros2.link.RosLink.ServiceClient;
import rsal.ros2.link.RosTopic;
import rsal.ros2.message.RosMessages;
import rsal.ros2.rosbridge.RosbridgeOptions.Encoding;
import rsal.ros2.type.Distribution;
import rsal.ros2.type.TypeLibrary;
import rsal.time.LockstepScheduler;

/// A link to a server in memory.
class RosbridgeLinkTest {
    private static final RosTopic ODOM = new RosTopic("/r1/odom", "nav_msgs/msg/Odometry");
    private static final RosTopic SCAN = new RosTopic("/r1/scan", "sensor_msgs/msg/LaserScan");
    private static final RosTopic COMMANDS = new RosTopic("/r1/cmd_vel", "geometry_msgs/msg/Twist");
    private static final RosTopic STOP = new RosTopic("/r1/e_stop", "std_msgs/msg/Bool");
    private static final String SET_BOOL = "std_srvs/srv/SetBool";
    private static final RosbridgeOptions OPTIONS = options(Encoding.CBOR);

    private final LockstepScheduler run = new LockstepScheduler();
    private final MemoryNetwork network = new MemoryNetwork();
    private final RosLink robot = network.join();
    private final RosMessages messages = new RosMessages();
    private FakeRosbridge server = new FakeRosbridge(network, false);
    private final List<RosbridgeLink> opened = new ArrayList<>();

    private static RosbridgeOptions options(Encoding encoding) {
        return new RosbridgeOptions(URI.create("ws://robot.local:9090"), encoding, Duration.ZERO, Optional.empty());
    }

    private RosbridgeLink open(RosbridgeTransport transport, RosbridgeOptions options) {
        var link = new RosbridgeLink(transport, options, run);
        opened.add(link);
        return link;
    }

    private RosbridgeLink open() {
        RosbridgeLink link = open(server.transport(), OPTIONS);
        run(2);
        return link;
    }

    private void run(double seconds) {
        for (int i = 0; i < Math.round(seconds * 20); i++) {
            run.advance(Duration.ofMillis(50));
        }
    }

    @AfterEach
    void close() {
        opened.forEach(RosbridgeLink::close);
    }

    private static List<byte[]> hear(RosLink link, RosTopic topic) {
        var heard = new ArrayList<byte[]>();
        link.subscribe(topic, Profile.SENSOR_DATA, bytes -> heard.add(copy(bytes)));
        return heard;
    }

    private static byte[] copy(ByteBuffer bytes) {
        var copy = new byte[bytes.remaining()];
        bytes.get(copy);
        return copy;
    }

    private byte[] odometry() {
        return messages.odometry(
                Instant.ofEpochSecond(5, 6),
                new Odometry(new Pose2d(1, 2, 0.5), new Twist2d(0.25, 0, -1), false),
                "odom",
                "base_link");
    }

    private byte[] scan() {
        float[] ranges = {1.5f, Float.POSITIVE_INFINITY, Float.NaN};
        return messages.scan(Instant.EPOCH, new LaserScan(Pose2d.ORIGIN, -1, 1, 0.1, 5, ranges), "laser", 0.05);
    }

    @ParameterizedTest
    @ValueSource(booleans = {false, true})
    void findsWhatOthersPublishAndHear(boolean isRos1) {
        server = new FakeRosbridge(network, isRos1);
        robot.advertise(ODOM, Profile.DEFAULT);
        robot.subscribe(COMMANDS, Profile.DEFAULT, _ -> {});
        RosbridgeLink link = open();
        assertThat(link.endpoints())
                .containsExactlyInAnyOrder(
                        new RosEndpoint(ODOM, true, Profile.DEFAULT, Optional.empty()),
                        new RosEndpoint(COMMANDS, false, Profile.DEFAULT, Optional.empty()));
        assertThat(link.distribution()).contains(Distribution.JAZZY);
        assertThat(link.trouble()).isEmpty();
        List<RosEndpoint> before = link.endpoints();
        run(3);
        assertThat(link.endpoints()).isSameAs(before);
    }

    @Test
    void whatItPublishesAndHearsItselfIsNoRobots() {
        RosbridgeLink link = open();
        link.advertise(COMMANDS, Profile.DEFAULT);
        RosLink.Subscribed subscribed = link.subscribe(ODOM, Profile.SENSOR_DATA, _ -> {});
        run(3);
        assertThat(link.endpoints()).isEmpty();
        assertThat(subscribed.publishers()).isZero();
        robot.advertise(ODOM, Profile.DEFAULT);
        run(3);
        assertThat(subscribed.publishers()).isEqualTo(1);
    }

    @ParameterizedTest
    @ValueSource(booleans = {false, true})
    void messagesComeAsTheyWerePublished(boolean isRos1) {
        server = new FakeRosbridge(network, isRos1);
        var odom = robot.advertise(ODOM, Profile.DEFAULT);
        var scans = robot.advertise(SCAN, Profile.SENSOR_DATA);
        RosbridgeLink link = open();
        List<byte[]> heardOdom = hear(link, ODOM);
        List<byte[]> heardScans = hear(link, SCAN);
        odom.publish(odometry());
        scans.publish(scan());
        assertThat(heardOdom).containsExactly(odometry());
        assertThat(heardScans).containsExactly(scan()); // infinite and NaN ranges, too
    }

    @Test
    void jsonHasNothingInfinite() {
        var scans = robot.advertise(SCAN, Profile.SENSOR_DATA);
        RosbridgeLink link = open(server.transport(), options(Encoding.JSON));
        run(2);
        List<byte[]> heard = hear(link, SCAN);
        scans.publish(scan());
        TypeLibrary types = TypeLibrary.of(Distribution.JAZZY);
        RosMessage message = new MessageValues(types, RosVersion.ROS_2).ofCdr(SCAN.type(), heard.getFirst());
        assertThat(message.get("ranges", float[].class)).containsExactly(1.5f, Float.NaN, Float.NaN);
    }

    @ParameterizedTest
    @ValueSource(booleans = {false, true})
    void commandsReachTheRobot(boolean isRos1) {
        server = new FakeRosbridge(network, isRos1);
        List<byte[]> heard = hear(robot, COMMANDS);
        RosbridgeLink link = open();
        byte[] command = new CdrWriter()
                .float64(0.5)
                .float64(0)
                .float64(0)
                .float64(0)
                .float64(0)
                .float64(-0.25)
                .toBytes();
        link.advertise(COMMANDS, Profile.DEFAULT).publish(command);
        assertThat(heard).containsExactly(command);
    }

    @Test
    void goesOnWhereItWasWhenTheServerIsThereAgain() {
        var odom = robot.advertise(ODOM, Profile.DEFAULT);
        List<byte[]> stops = hear(robot, STOP);
        RosbridgeLink link = open();
        var heard = new ArrayList<byte[]>();
        RosLink.Subscribed subscribed = link.subscribe(ODOM, Profile.SENSOR_DATA, bytes -> heard.add(copy(bytes)));
        byte[] stopped = new CdrWriter().bool(true).toBytes();
        link.advertise(STOP, Profile.LATCHED).publish(stopped);
        run(2);
        assertThat(subscribed.publishers()).isEqualTo(1);

        server.down();
        run(1);
        assertThat(subscribed.publishers()).isZero();
        assertThat(link.endpoints()).isEmpty();
        assertThat(link.trouble().orElse("")).contains("ws://robot.local:9090", "nobody listens there");
        odom.publish(odometry());
        assertThat(heard).isEmpty();
        run(30);

        server.up();
        run(10);
        odom.publish(odometry());
        assertThat(heard).hasSize(1);
        assertThat(subscribed.publishers()).isEqualTo(1);
        assertThat(link.trouble()).isEmpty();
        assertThat(stops).containsExactly(stopped, stopped); // the server had forgotten it
    }

    /// Times and what comes in parts are needed whole.
    @ParameterizedTest
    @CsvSource({
        "sensor_msgs/msg/LaserScan, SENSOR_DATA, 200 1",
        "nav_msgs/msg/Odometry, SENSOR_DATA, 200 1",
        "nav_msgs/msg/OccupancyGrid, LATCHED, 0 20",
        "rosgraph_msgs/msg/Clock, SENSOR_DATA, 0 1",
        "diagnostic_msgs/msg/DiagnosticArray, SENSOR_DATA, 0 100",
        "sensor_msgs/msg/JointState, SENSOR_DATA, 0 100",
        "lifecycle_msgs/msg/TransitionEvent, SENSOR_DATA, 0 20",
        "tf2_msgs/msg/TFMessage, DEFAULT, 0 100"
    })
    void onlyReadingsOfSensorsComeLessOften(String type, Profile profile, String delivery) {
        robot.advertise(ODOM, Profile.DEFAULT);
        var slow = new RosbridgeOptions(
                URI.create("ws://robot.local:9090"), Encoding.CBOR, Duration.ofMillis(200), Optional.empty());
        RosbridgeLink link = open(server.transport(), slow);
        run(2);
        link.subscribe(new RosTopic("/topic", type), profile, _ -> {});
        assertThat(server.delivery("/topic")).isEqualTo(delivery);
    }

    @Test
    void malformedMessagesHarmNoOthers() {
        var odom = robot.advertise(ODOM, Profile.DEFAULT);
        RosbridgeLink link = open();
        List<byte[]> heard = hear(link, ODOM);
        server.sendAll("{\"op\": \"publish\", \"topic\":");
        server.sendAll("[]");
        server.sendAll("{\"op\": 5}");
        server.sendAll("{\"op\": \"publish\"}");
        server.sendAll("{\"op\": \"publish\", \"topic\": \"/r1/odom\", \"msg\": {\"pose\": 5}}");
        server.sendAll("{\"op\": \"fragment\", \"id\": \"1\", \"data\": \"\", \"num\": 0, \"total\": 2}");
        server.sendAll("{\"op\": \"service_response\", \"values\": {}, \"result\": true}");
        server.sendAll(new byte[] {(byte) 0xff, 1, 2});
        run(0.1);
        assertThat(link.malformed()).isEqualTo(8);
        odom.publish(odometry());
        assertThat(heard).containsExactly(odometry());
    }

    @Test
    void servicesAreCalled() {
        network.serve(
                "/r1/stop",
                SET_BOOL,
                request -> CompletableFuture.completedStage(
                        new CdrWriter().bool(request[4] == 1).text("done").toBytes()));
        RosbridgeLink link = open();
        ServiceClient client = link.client("/r1/stop", SET_BOOL);
        assertThat(client.isAvailable()).isTrue();
        assertThat(link.client("/r1/go", SET_BOOL).isAvailable()).isFalse();
        CompletableFuture<byte[]> answer =
                client.call(new CdrWriter().bool(true).toBytes()).toCompletableFuture();
        run(0.1);
        assertThat(answer.join())
                .containsExactly(new CdrWriter().bool(true).text("done").toBytes());
    }

    @Test
    void servicesThatFailSayWhy() {
        network.serve("/r1/stop", SET_BOOL, _ -> CompletableFuture.failedStage(new IllegalStateException("jammed")));
        RosbridgeLink link = open();
        byte[] request = new CdrWriter().bool(true).toBytes();
        var failed = link.client("/r1/stop", SET_BOOL).call(request).toCompletableFuture();
        var lacking = link.client("/r1/go", SET_BOOL).call(request).toCompletableFuture();
        run(0.1);
        assertThatThrownBy(failed::join).hasMessageContaining("jammed");
        assertThatThrownBy(lacking::join).hasMessageContaining("Service /r1/go does not exist");
    }

    @Test
    void callsFailWhenTheConnectionIsLost() {
        network.serve("/r1/stop", SET_BOOL, _ -> new CompletableFuture<>());
        RosbridgeLink link = open();
        byte[] request = new CdrWriter().bool(true).toBytes();
        ServiceClient client = link.client("/r1/stop", SET_BOOL);
        var waiting = client.call(request).toCompletableFuture();
        server.down();
        run(0.1);
        assertThatThrownBy(waiting::join).hasMessageContaining("can't be reached");
        assertThat(client.isAvailable()).isFalse();
        assertThatThrownBy(() -> client.call(request).toCompletableFuture().join())
                .hasMessageContaining("can't be reached");
    }

    @Test
    void callsThatNobodyAnswersAreGivenUp() {
        network.serve("/r1/stop", SET_BOOL, _ -> new CompletableFuture<>());
        ServiceClient client = open().client("/r1/stop", SET_BOOL);
        List<CompletableFuture<byte[]>> first = calls(client);
        run(29);
        assertThat(first).noneMatch(CompletableFuture::isDone);
        run(2);
        assertThatThrownBy(first.getLast()::join).hasMessageContaining("No answer within 30 s.");
        assertThat(calls(client)).noneMatch(CompletableFuture::isDone); // 1,000 may wait
    }

    private static List<CompletableFuture<byte[]>> calls(ServiceClient client) {
        byte[] request = new CdrWriter().bool(true).toBytes();
        return IntStream.range(0, 900)
                .mapToObj(_ -> client.call(request).toCompletableFuture())
                .toList();
    }

    @Test
    void whatAServerSaysIsOneShortLine() {
        network.serve(
                "/r1/stop",
                SET_BOOL,
                _ -> CompletableFuture.failedStage(
                        new IllegalStateException("\u001b[31mjammed\r\nERROR: " + "x".repeat(1 << 20))));
        RosbridgeLink link = open();
        var failed = link.client("/r1/stop", SET_BOOL)
                .call(new CdrWriter().bool(true).toBytes())
                .toCompletableFuture();
        run(0.1);
        assertThatThrownBy(failed::join)
                .cause()
                .hasMessageStartingWith("[31mjammed ERROR: xxx")
                .hasMessageEndingWith("xxx…")
                .extracting(Throwable::getMessage, InstanceOfAssertFactories.STRING)
                .hasSizeBetween(190, 201);
    }

    @Test
    void othersCallItsOwnServices() {
        RosbridgeLink link = open();
        var served = link.serve(
                "/rsal/stop",
                SET_BOOL,
                request -> request[4] == 1
                        ? CompletableFuture.completedStage(
                                new CdrWriter().bool(true).text("stopped").toBytes())
                        : CompletableFuture.failedStage(new IllegalStateException("not now")));
        ServiceClient client = robot.client("/rsal/stop", SET_BOOL);
        var good = client.call(new CdrWriter().bool(true).toBytes()).toCompletableFuture();
        var bad = client.call(new CdrWriter().bool(false).toBytes()).toCompletableFuture();
        run(0.1);
        assertThat(good.join())
                .containsExactly(new CdrWriter().bool(true).text("stopped").toBytes());
        assertThatThrownBy(bad::join).hasMessageContaining("not now");
        served.close();
        assertThat(client.isAvailable()).isFalse();
        assertThatThrownBy(() -> link.serve("/rsal/go/_action/send_goal", "nav2_msgs/action/Spin_SendGoal", _ -> null))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessageContaining("/rsal/go");
    }

    @Test
    void aServerWithoutRosapiIsExplained() {
        server.withoutRosapi();
        RosbridgeLink link = open();
        assertThat(link.endpoints()).isEmpty();
        assertThat(link.trouble().orElse("")).contains("/rosapi/topics", "does not exist", "Does the node rosapi run");
    }

    @Test
    void aServerThatSaysNothingIsGivenUp() {
        var connections = new ArrayList<String>();
        RosbridgeLink link = open(
                new RosbridgeTransport() {
                    @Override
                    public CompletionStage<Connection> open(Receiver receiver) {
                        connections.add("opened");
                        return CompletableFuture.completedStage(new Connection() {
                            @Override
                            public void send(String key, String message) {
                                // nobody answers
                            }

                            @Override
                            public void close() {
                                connections.add("closed");
                            }

                            @Override
                            public void abort() {
                                connections.add("aborted");
                            }
                        });
                    }

                    @Override
                    public void close() {
                        // nothing is open
                    }
                },
                OPTIONS);
        run(9);
        assertThat(connections).containsExactly("opened");
        assertThat(link.trouble().orElse("")).contains("/rosapi/topics", "No answer within 5.0 s");
        run(10);
        assertThat(connections).startsWith("opened", "aborted", "opened");
    }

    @Test
    void whatWasFoundStaysWhileAnAnswerOrTwoAreRefused() {
        var odom = robot.advertise(ODOM, Profile.DEFAULT);
        serveSpin(true, new CompletableFuture<>());
        RosbridgeLink link = open();
        List<RosEndpoint> found = link.endpoints();
        assertThat(found).hasSize(2);
        server.refuse(Set.of("node_details", "action_servers"));
        run(2.5);
        assertThat(link.endpoints()).isSameAs(found);
        assertThat(link.client("/r1/spin/_action/send_goal", "nav2_msgs/action/Spin_SendGoal")
                        .isAvailable())
                .isTrue();
        server.refuse(Set.of());
        run(3);
        assertThat(link.endpoints()).isSameAs(found);
        server.refuse(Set.of("node_details", "action_servers"));
        run(6);
        assertThat(link.endpoints()).isEmpty();
        server.refuse(Set.of());
        run(2);
        assertThat(link.endpoints()).isEqualTo(found);
        odom.close(); // and what rosapi says does count
        run(2);
        assertThat(link.endpoints()).hasSize(1);
    }

    @Test
    void aTypeThatIsNotSentAtOnceIsAskedForAgain() {
        String type = "control_msgs/action/GripperCommand_FeedbackMessage";
        robot.advertise(new RosTopic("/r1/gripper_cmd/_action/feedback", type), Profile.DEFAULT);
        server.refuse(Set.of("action_type"));
        RosbridgeLink link = open();
        assertThat(link.endpoints()).isEmpty();
        server.refuse(Set.of());
        run(2);
        assertThat(link.endpoints()).extracting(each -> each.topic().type()).containsExactly(type);
    }

    private static final class Heard implements ActionClient.Listener {
        private final List<String> what = new ArrayList<>();

        @Override
        public void onFeedback(RosMessage message) {
            what.add("feedback");
        }

        @Override
        public void onRefused() {
            what.add("refused");
        }

        @Override
        public void onResult(RosMessage response) {
            what.add("result " + response.integer("status"));
        }

        @Override
        public void onFailure(String why) {
            what.add(why);
        }
    }

    private Heard send(RosbridgeLink link) {
        var action = new ActionClient(
                link,
                TypeLibrary.of(Distribution.JAZZY),
                "/r1/spin",
                "nav2_msgs/action/Spin",
                run,
                new SplittableRandom(1));
        var heard = new Heard();
        action.send(goal -> goal.float32(1.5f).int32(0).int32(0).bool(false), heard);
        return heard;
    }

    private void serveSpin(boolean accepts, CompletionStage<byte[]> result) {
        robot.advertise(
                new RosTopic("/r1/spin/_action/feedback", "nav2_msgs/action/Spin_FeedbackMessage"), Profile.DEFAULT);
        network.serve(
                "/r1/spin/_action/send_goal",
                "nav2_msgs/action/Spin_SendGoal",
                _ -> CompletableFuture.completedStage(
                        new CdrWriter().bool(accepts).int32(0).int32(0).toBytes()));
        network.serve("/r1/spin/_action/get_result", "nav2_msgs/action/Spin_GetResult", _ -> result);
    }

    @Test
    void goalsAreRefused() {
        serveSpin(false, new CompletableFuture<>());
        Heard heard = send(open());
        run(0.1);
        assertThat(heard.what).containsExactly("refused");
    }

    /// Humble's rosapi does not say which types actions have, and Humble has no docking.
    @Test
    void actionsThatTheServersDistributionDoesNotHaveFail() {
        server.distribution("humble");
        server.refuse(Set.of("action_type"));
        serveSpin(true, new CompletableFuture<>());
        String dock = "nav2_msgs/action/DockRobot";
        robot.advertise(new RosTopic("/r1/dock_robot/_action/feedback", dock + "_FeedbackMessage"), Profile.DEFAULT);
        robot.advertise(ODOM, Profile.DEFAULT);
        RosbridgeLink link = open();
        assertThat(link.distribution()).contains(Distribution.HUMBLE);
        assertThat(link.endpoints())
                .extracting(each -> each.topic().name())
                .containsExactly("/r1/odom", "/r1/spin/_action/feedback");
        var request = new byte[200];
        var goal = link.client("/r1/dock_robot/_action/send_goal", dock + "_SendGoal")
                .call(request);
        var result = link.client("/r1/dock_robot/_action/get_result", dock + "_GetResult")
                .call(request);
        var answer = link.client("/r1/load", "nav2_msgs/srv/ReloadDockDatabase").call(request);
        for (CompletionStage<byte[]> each : List.of(goal, result, answer)) {
            assertThatThrownBy(() -> each.toCompletableFuture().join())
                    .hasMessageContaining("There is no definition of 'nav2_msgs/");
        }
    }

    @Test
    void goalsEndWithTheirStatus() {
        byte[] aborted = new CdrWriter().int8((byte) 6).int32(1).int32(2).toBytes();
        serveSpin(true, CompletableFuture.completedStage(aborted));
        Heard heard = send(open());
        run(0.1);
        assertThat(heard.what).containsExactly("result 6");
    }

    @Test
    void goalsFailWhenTheConnectionIsLost() {
        serveSpin(true, new CompletableFuture<>());
        Heard heard = send(open());
        run(3);
        assertThat(heard.what).isEmpty();
        server.down();
        run(0.1);
        assertThat(heard.what).containsExactly("The connection to rosbridge was lost.");
    }

    /// The server goes on with them.
    @Test
    void goalsThatWereLostAreCanceledWhenTheServerIsThereAgain() {
        var canceled = new ArrayList<Byte>();
        network.serve("/r1/spin/_action/cancel_goal", "action_msgs/srv/CancelGoal", request -> {
            canceled.add(request[4 + 15]); // the last byte of its id
            return new CompletableFuture<>();
        });
        serveSpin(true, new CompletableFuture<>());
        var _ = send(open());
        run(3);
        server.down();
        run(5);
        assertThat(canceled).isEmpty();
        server.up();
        run(10);
        assertThat(canceled).containsExactly((byte) 1);
        server.down();
        run(1);
        server.up();
        run(10);
        assertThat(canceled).hasSize(1);
    }

    @Test
    void goalsFailWhereNobodyServesThem() {
        Heard heard = send(open());
        run(0.1);
        assertThat(heard.what).containsExactly("No action server available");
    }

    @Test
    void serversOfRos1HaveNoGoals() {
        server = new FakeRosbridge(network, true);
        robot.advertise(ODOM, Profile.DEFAULT);
        Heard heard = send(open());
        run(0.1);
        assertThat(heard.what).containsExactly("Unknown operation: send_action_goal");
    }
}
