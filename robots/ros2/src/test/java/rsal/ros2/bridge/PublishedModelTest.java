package rsal.ros2.bridge;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.io.StringReader;
import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.atomic.AtomicReference;
import javax.xml.parsers.DocumentBuilderFactory;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.w3c.dom.Element;
import org.w3c.dom.NodeList;
import org.xml.sax.InputSource;
import rsal.data.ActuatorState;
import rsal.data.Odometry;
import rsal.data.Pose2d;
import rsal.data.Stamped;
import rsal.data.Twist2d;
import rsal.device.Actuator;
import rsal.model.RobotModels;
import rsal.robot.Robot;
import rsal.robot.RobotModel;
import rsal.robot.RobotSpec;
import rsal.ros2.MemoryNetwork;
import rsal.ros2.cdr.CdrReader;
import rsal.ros2.cdr.InvalidCdr;
import rsal.ros2.cdr.MessageCodec;
import rsal.ros2.cdr.RosMessage;
import rsal.ros2.link.Profile;
import rsal.ros2.link.RosLink;
import rsal.ros2.link.RosTopic;
import rsal.ros2.tf.StampedTransform;
import rsal.ros2.tf.TransformBuffer;
import rsal.ros2.type.Distribution;
import rsal.ros2.type.TypeLibrary;
import rsal.ros2.urdf.UrdfWriter;
import rsal.sim.SimProvider;
import rsal.system.Bridge;
import rsal.system.RobotSystem;
import rsal.system.RobotSystemProvider;
import rsal.testkit.contract.RobotBench;

/// Joints of a robot that has some.
class PublishedModelTest extends RobotBench {
    private static final TypeLibrary TYPES = TypeLibrary.of(Distribution.JAZZY);

    private final MemoryNetwork network = new MemoryNetwork();
    private final RosLink there = network.join();

    @Override
    protected RobotSystemProvider provider() {
        return new SimProvider();
    }

    @Override
    protected Map<String, String> parts() {
        return Map.of("turntable", "turntable");
    }

    private List<RosMessage> hear(String topic, String type) {
        var heard = new ArrayList<RosMessage>();
        MessageCodec codec = MessageCodec.of(TYPES.get(type), TYPES);
        there.subscribe(new RosTopic(topic, type), Profile.DEFAULT, bytes -> {
            try {
                heard.add(codec.read(CdrReader.of(bytes)));
            } catch (InvalidCdr e) {
                throw new AssertionError(topic, e);
            }
        });
        return heard;
    }

    /// What RViz needs to draw all of it: each link is connected, and each joint that moves has a state.
    @ParameterizedTest
    @ValueSource(strings = {"turtlebot3-burger", "turtlebot4", "pioneer3at"})
    void allLinksAreConnectedAndAllJointsHaveStates(String name) throws Exception {
        RobotModel model = RobotModels.readBuiltIn().stream()
                .filter(each -> each.name().equals(name))
                .findFirst()
                .orElseThrow();
        var spec = new RobotSpec("r1", "tested", model, Optional.of(START), "#3366cc");
        try (RobotSystem its = create(List.of(spec), 7)) {
            Robot robot = its.discover().toCompletableFuture().join().getFirst();
            try (Bridge _ = PublishedRobots.publish(List.of(robot), WORLD.grid(), network.join(), run)) {
                assertThatRvizDraws(robot);
            }
        }
    }

    private void assertThatRvizDraws(Robot robot) throws Exception {
        List<RosMessage> joints = hear("/r1/joint_states", "sensor_msgs/msg/JointState");
        List<RosMessage> moving = hear("/r1/tf", "tf2_msgs/msg/TFMessage");
        advance(1);
        var description = new AtomicReference<String>();
        there.subscribe(new RosTopic("/r1/robot_description", "std_msgs/msg/String"), Profile.LATCHED, bytes -> {
            try {
                description.set(CdrReader.of(bytes).text(""));
            } catch (InvalidCdr e) {
                throw new AssertionError(e);
            }
        });
        var frames = new TransformBuffer(TransformBuffer.HISTORY);
        MessageCodec codec = MessageCodec.of(TYPES.get("tf2_msgs/msg/TFMessage"), TYPES);
        there.subscribe(new RosTopic("/r1/tf_static", "tf2_msgs/msg/TFMessage"), Profile.LATCHED, bytes -> {
            try {
                StampedTransform.of(codec.read(CdrReader.of(bytes))).forEach(frames::addFixed);
            } catch (InvalidCdr e) {
                throw new AssertionError(e);
            }
        });
        moving.forEach(each -> StampedTransform.of(each).forEach(frames::add));
        NodeList all = DocumentBuilderFactory.newInstance()
                .newDocumentBuilder()
                .parse(new InputSource(new StringReader(description.get())))
                .getElementsByTagName("*");
        var states = joints.isEmpty() ? List.of() : joints.getLast().get("name", List.class);
        int links = 0;
        for (int i = 0; i < all.getLength(); i++) {
            var element = (Element) all.item(i);
            String named = element.getAttribute("name");
            if (element.getTagName().equals("link") && !named.isEmpty()) {
                assertThat(frames.find("odom", named, 0).isConnected())
                        .as(named)
                        .isTrue();
                links++;
            }
            if (element.getTagName().equals("joint")
                    && !element.getAttribute("type").equals("fixed")) {
                assertThat(states.contains(named)).as(named).isTrue();
            }
        }
        assertThat(links).isGreaterThan(1);
        assertThat(states.contains("wheel_left_joint"))
                .isEqualTo(UrdfWriter.wheels(robot.model()).isPresent());
    }

    /// On a circle to the left, the right wheel goes further.
    @Test
    void wheelsTurnAsTheRobotDrives() {
        RobotModel burger = RobotModels.readBuiltIn().stream()
                .filter(each -> each.name().equals("turtlebot3-burger"))
                .findFirst()
                .orElseThrow();
        var wheels = UrdfWriter.wheels(burger).orElseThrow();
        Pose2d odomFromBase = new Pose2d(3, 1, 2.8);
        var turning = new WheelJoints(burger.drive(), wheels, reading(0, odomFromBase, Twist2d.STOP));
        Twist2d velocity = Twist2d.drive(0.2, 0.5);
        Pose2d step = new Pose2d(0.4 * Math.sin(0.025), 0.4 * (1 - Math.cos(0.025)), 0.025); // in 50 ms
        for (int i = 1; i <= 200; i++) {
            odomFromBase = odomFromBase.compose(step);
            turning.turn(reading(i, odomFromBase, velocity));
        }
        odomFromBase = new Pose2d(0, 0, 0); // odometry is set, which turns no wheel
        Map<String, ActuatorState> turned = turning.turn(reading(201, odomFromBase, velocity));
        ActuatorState left = turned.get("wheel_left_joint");
        ActuatorState right = turned.get("wheel_right_joint");
        assertThat(left.position()).isCloseTo(10 * (0.2 - 0.5 * 0.08) / 0.033, within(0.02));
        assertThat(right.position()).isCloseTo(10 * (0.2 + 0.5 * 0.08) / 0.033, within(0.02));
        assertThat(left.speed()).isCloseTo((0.2 - 0.5 * 0.08) / 0.033, within(1e-9));
        assertThat(right.speed()).isCloseTo((0.2 + 0.5 * 0.08) / 0.033, within(1e-9));
    }

    private static Stamped<Odometry> reading(int number, Pose2d odomFromBase, Twist2d velocity) {
        return new Stamped<>(
                Instant.ofEpochMilli(50L * number), "r1/odom", new Odometry(odomFromBase, velocity, false));
    }

    @Test
    void jointsAndTheirFramesAreReported() {
        try (Bridge bridge = PublishedRobots.publish(List.of(robot()), WORLD.grid(), network.join(), run)) {
            List<RosMessage> joints = hear("/r1/joint_states", "sensor_msgs/msg/JointState");
            List<RosMessage> transforms = hear("/r1/tf", "tf2_msgs/msg/TFMessage");
            Actuator turntable = robot().require(Actuator.class);
            turntable.goTo(0.4);
            advance(5);
            RosMessage last = joints.getLast();
            List<?> names = last.get("name", List.class);
            assertThat(names).isEqualTo(List.of("turntable"));
            double position = last.get("position", double[].class)[0];
            assertThat(position).isCloseTo(0.4, within(0.01));
            assertThat(last.get("velocity", double[].class)).hasSize(1);
            var frames = new TransformBuffer(TransformBuffer.HISTORY);
            transforms.forEach(each -> StampedTransform.of(each).forEach(frames::add));
            assertThat(frames.find("base_link", "turntable", 0)
                            .transform()
                            .orElseThrow()
                            .planar()
                            .theta())
                    .isCloseTo(position, within(1e-6));
            assertThat(bridge.offers()).isNotEmpty();
        }
    }
}
