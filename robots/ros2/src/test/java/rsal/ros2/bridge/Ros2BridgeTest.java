package rsal.ros2.bridge;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.time.Duration;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import rsal.data.Twist2d;
import rsal.device.DriveBase;
import rsal.ros2.MemoryNetwork;
import rsal.ros2.cdr.CdrReader;
import rsal.ros2.cdr.InvalidCdr;
import rsal.ros2.cdr.MessageCodec;
import rsal.ros2.cdr.RosMessage;
import rsal.ros2.link.Profile;
import rsal.ros2.link.RosEndpoint;
import rsal.ros2.link.RosLink;
import rsal.ros2.link.RosTopic;
import rsal.ros2.message.RosMessages;
import rsal.ros2.tf.StampedTransform;
import rsal.ros2.tf.TransformBuffer;
import rsal.ros2.tf.TransformLookup;
import rsal.ros2.type.Distribution;
import rsal.ros2.type.TypeLibrary;
import rsal.ros2.urdf.UrdfWriter;
import rsal.sim.SimProvider;
import rsal.system.Bridge;
import rsal.system.ExportedDevice;
import rsal.system.RobotSystemProvider;
import rsal.testkit.contract.RobotBench;

/// What programs of ROS 2 hear of a simulated robot, read by the definitions of its types.
class Ros2BridgeTest extends RobotBench {
    private static final TypeLibrary TYPES = TypeLibrary.of(Distribution.JAZZY);

    private final MemoryNetwork network = new MemoryNetwork();
    private final RosLink there = network.join();
    private final Map<String, List<RosMessage>> heard = new HashMap<>();
    private Bridge bridge;

    @Override
    protected RobotSystemProvider provider() {
        return new SimProvider();
    }

    @Override
    protected Map<String, String> parts() {
        return Map.of("battery", "pioneer-battery");
    }

    /// Subscribes to all there is, with what each topic offers.
    @BeforeEach
    void publish() {
        bridge = PublishedRobots.publish(List.of(robot()), WORLD.grid(), network.join(), run);
        advance(0.3); // sonars are known when they have measured
        for (RosEndpoint endpoint : there.endpoints()) {
            if (endpoint.isPublisher()) {
                RosTopic topic = endpoint.topic();
                MessageCodec codec = MessageCodec.of(TYPES.get(topic.type()), TYPES);
                there.subscribe(topic, endpoint.profile(), bytes -> {
                    try {
                        heard.computeIfAbsent(topic.name(), _ -> new ArrayList<>())
                                .add(codec.read(CdrReader.of(bytes)));
                    } catch (InvalidCdr e) {
                        throw new AssertionError(topic.name(), e);
                    }
                });
            }
        }
        drive(Twist2d.drive(0.3, 0.2), 3);
    }

    @AfterEach
    void close() {
        bridge.close();
    }

    private List<RosMessage> all(String topic) {
        return heard.getOrDefault(topic, List.of());
    }

    @Test
    void topicsAreThoseOfARobot() {
        assertThat(heard).containsKeys("/clock", "/r1/odom", "/r1/scan", "/r1/tf", "/r1/tf_static", "/r1/map");
        assertThat(heard).containsKeys("/r1/sonar_0", "/r1/sonar_7", "/r1/battery_state");
        assertThat(bridge.offers())
                .contains(
                        new ExportedDevice(7400, "/r1/odom", "r1/base"),
                        new ExportedDevice(7400, "/r1/cmd_vel", "r1/base"),
                        new ExportedDevice(7400, "/r1/scan", "r1/laser"));
        assertThat(there.endpoints())
                .filteredOn(each -> !each.isPublisher())
                .extracting(each -> each.topic().type())
                .contains("geometry_msgs/msg/Twist", "geometry_msgs/msg/TwistStamped");
    }

    /// What RViz and Nav2 need: each scan's frame is connected with `odom`, and times go up.
    @Test
    void framesAreConnectedAndTimesGoUp() {
        var frames = new TransformBuffer(Duration.ofHours(1));
        all("/r1/tf_static").forEach(each -> StampedTransform.of(each).forEach(frames::addFixed));
        all("/r1/tf").forEach(each -> StampedTransform.of(each).forEach(frames::add));
        long from = RosMessages.stamp(all("/r1/odom").getFirst().message("header"));
        for (String topic : List.of("/r1/scan", "/r1/odom", "/r1/sonar_3")) {
            long before = 0;
            for (RosMessage message : all(topic)) {
                RosMessage header = message.message("header");
                assertThat(RosMessages.stamp(header)).as(topic).isGreaterThan(before);
                before = RosMessages.stamp(header);
                if (before >= from) {
                    assertThat(frames.find("odom", header.text("frame_id"), before))
                            .as(topic)
                            .isInstanceOf(TransformLookup.Found.class);
                }
            }
        }
        assertThat(all("/r1/odom")).hasSizeGreaterThan(20);
        assertThat(all("/r1/scan")).hasSizeGreaterThan(10);
        assertThat(all("/clock")).hasSizeGreaterThan(250);
        assertThat(all("/r1/tf_static")).hasSizeLessThan(4); // what does not move is told once
    }

    @Test
    void scansSayWhatTheLaserSees() {
        RosMessage scan = all("/r1/scan").getLast();
        float[] ranges = scan.get("ranges", float[].class);
        int beams = ranges.length;
        assertThat(scan.number("angle_min") + (beams - 1) * scan.number("angle_increment"))
                .isCloseTo(scan.number("angle_max"), within(1e-3));
        assertThat(beams).isGreaterThan(100);
        for (float range : ranges) {
            assertThat(Float.isInfinite(range)
                            || (range >= scan.number("range_min") && range <= scan.number("range_max")))
                    .isTrue();
        }
    }

    @Test
    void theMapIsThatOfTheWorldForThoseWhoComeLate() {
        RosMessage map = all("/r1/map").getFirst();
        assertThat(map.get("data", byte[].class)).isEqualTo(WORLD.grid().cells());
        assertThat(map.message("info").integer("width")).isEqualTo(WORLD.grid().width());
    }

    /// Without a limit of time, a velocity holds as long as somebody is there to give another one.
    @Test
    void aRobotWhoseDriverLeavesStops() throws Exception {
        RosLink driver = network.join();
        driver.advertise(new RosTopic("/r1/cmd_vel", "geometry_msgs/msg/Twist"), Profile.DEFAULT)
                .publish(new RosMessages().twist(Twist2d.drive(0, 0.3)));
        advance(2);
        assertThat(velocity().omega()).isBetween(0.2, 0.4);
        driver.close();
        advance(2);
        assertThat(velocity().omega()).isZero();
    }

    private Twist2d velocity() {
        return robot().require(DriveBase.class).latest().orElseThrow().value().velocity();
    }

    @Test
    void theBatteryReportsItsLevel() {
        assertThat(all("/r1/battery_state").getLast().number("percentage")).isBetween(0.5, 1.0);
    }

    @Test
    void healthIsReportedOnceASecond() {
        List<RosMessage> arrays = all("/diagnostics");
        assertThat(arrays).hasSizeBetween(3, 4);
        List<RosMessage> statuses = arrays.getLast().messages("status");
        assertThat(statuses)
                .extracting(status -> status.text("name"))
                .contains("r1: base", "r1: laser", "r1: sonar", "r1: battery");
        assertThat(statuses).extracting(status -> status.integer("level")).containsOnly(0L);
        assertThat(statuses).extracting(status -> status.text("hardware_id")).containsOnly("r1");
    }

    @Test
    void theDescriptionIsThatOfTheModel() {
        assertThat(all("/r1/robot_description").getFirst().text("data"))
                .isEqualTo(UrdfWriter.urdf("r1", robot().model()));
        assertThat(heard).doesNotContainKey("/r1/joint_states");
    }

    @Test
    void eachRobotIsANode() {
        assertThat(network.nodes()).containsExactly("/r1/rsal");
    }

    @Test
    void aRobotThatLeavesIsNotThereAnyMore() throws Exception {
        bridge.leave("r1");
        assertThat(there.endpoints())
                .extracting(each -> each.topic().name())
                .containsOnly("/clock", "/parameter_events", "/diagnostics");
        assertThat(network.nodes()).isEmpty();
        assertThat(bridge.offers()).isEmpty();
        bridge.join(robot());
        assertThat(bridge.offers()).isNotEmpty();
    }
}
