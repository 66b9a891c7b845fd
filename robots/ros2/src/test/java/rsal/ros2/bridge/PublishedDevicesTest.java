package rsal.ros2.bridge;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.concurrent.CompletableFuture;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import rsal.data.GripperState.Lift;
import rsal.data.GripperState.Paddles;
import rsal.data.Point2d;
import rsal.data.Pose2d;
import rsal.data.Rgb;
import rsal.data.Shape;
import rsal.data.Solid;
import rsal.device.Gripper;
import rsal.device.SimulationControl.Thing;
import rsal.ros2.MemoryNetwork;
import rsal.ros2.cdr.CdrReader;
import rsal.ros2.cdr.CdrWriter;
import rsal.ros2.cdr.InvalidCdr;
import rsal.ros2.cdr.MessageCodec;
import rsal.ros2.cdr.RosMessage;
import rsal.ros2.link.Profile;
import rsal.ros2.link.RosLink;
import rsal.ros2.link.RosTopic;
import rsal.ros2.message.FrameTransform;
import rsal.ros2.tf.StampedTransform;
import rsal.ros2.tf.TransformBuffer;
import rsal.ros2.type.Distribution;
import rsal.ros2.type.TypeLibrary;
import rsal.sim.SimProvider;
import rsal.system.Bridge;
import rsal.system.RobotSystemProvider;
import rsal.testkit.contract.RobotBench;

/// What programs of ROS 2 hear of IMUs, cameras, blob detectors and grippers, read by the definitions of the types, and
/// how they move a gripper.
class PublishedDevicesTest extends RobotBench {
    private static final TypeLibrary TYPES = TypeLibrary.of(Distribution.JAZZY);
    private static final String GRIPPER = "/r1/gripper_controller/gripper_cmd/_action/";

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
        return Map.of(
                "imu", "imu-bmi088", "camera", "blob-camera", "eyes", "depth-camera", "gripper", "pioneer-gripper");
    }

    @BeforeEach
    void publish() {
        bridge = PublishedRobots.publish(List.of(robot()), WORLD.grid(), network.join(), run);
    }

    @AfterEach
    void close() {
        bridge.close();
    }

    private void listen(String name, String type) {
        listen(name, type, Profile.DEFAULT);
    }

    private void listen(String name, String type, Profile profile) {
        MessageCodec codec = MessageCodec.of(TYPES.get(type), TYPES);
        heard.put(name, new ArrayList<>());
        there.subscribe(new RosTopic("/r1/" + name, type), profile, bytes -> {
            try {
                heard.get(name).add(codec.read(CdrReader.of(bytes)));
            } catch (InvalidCdr e) {
                throw new AssertionError(name, e);
            }
        });
    }

    private RosMessage newest(String name) {
        return heard.get(name).getLast();
    }

    @Test
    void anImuHasGravityAndTheVariancesOfItsPart() {
        listen("imu", "sensor_msgs/msg/Imu");
        advance(1);
        RosMessage imu = newest("imu");
        assertThat(imu.message("header").text("frame_id")).isEqualTo("imu");
        assertThat(imu.message("linear_acceleration").number("z")).isCloseTo(9.81, within(0.01));
        assertThat(imu.message("linear_acceleration").number("x")).isCloseTo(0, within(0.2));
        double deviation = Math.toRadians(0.014) / Math.sqrt(0.02);
        assertThat(imu.get("angular_velocity_covariance", double[].class)[8])
                .isCloseTo(deviation * deviation, within(1e-12));
        assertThat(imu.get("orientation_covariance", double[].class)).containsOnly(0);
    }

    private void putRed(double x, double y) {
        put(Thing.of(
                "red",
                START.compose(new Pose2d(x, y, 0)),
                Solid.standing(new Shape.Disc(new Point2d(0, 0), 0.1), 0.6),
                new Rgb(255, 0, 0)));
    }

    /// As a program of ROS finds it: by its frame and TF.
    @Test
    void aDetectionIsWhereTheThingIs() {
        listen("camera/detections", "vision_msgs/msg/Detection2DArray");
        listen("tf_static", "tf2_msgs/msg/TFMessage", Profile.LATCHED);
        putRed(2, 0.5);
        advance(1);
        RosMessage detection =
                newest("camera/detections").messages("detections").getFirst();
        RosMessage result = detection.messages("results").getFirst();
        assertThat(result.message("hypothesis").text("class_id")).isEqualTo("#ff0000");
        assertThat(result.message("hypothesis").number("score")).isBetween(0.5, 1.0);
        FrameTransform place = FrameTransform.of(result.message("pose").message("pose"), "position", "orientation");
        var frames = new TransformBuffer(TransformBuffer.HISTORY);
        heard.get("tf_static").forEach(each -> StampedTransform.of(each).forEach(frames::addFixed));
        FrameTransform baseFromCamera = frames.find(
                        "base_link", detection.message("header").text("frame_id"), 0)
                .transform()
                .orElseThrow();
        Pose2d baseFromThing = baseFromCamera.compose(place).planar();
        assertThat(baseFromThing.position().distanceTo(new Point2d(2, 0.5))).isLessThan(0.2);
        RosMessage box = detection.message("bbox");
        assertThat(box.message("center").message("position").number("x")).isBetween(15.0, 40.0); // left of 80 columns
        assertThat(box.number("size_x")).isBetween(2.0, 20.0);
    }

    @Test
    void imagesAreMadeOnlyWhileSomebodyWantsThem() {
        advance(2);
        listen("eyes/image_raw", "sensor_msgs/msg/Image");
        advance(3);
        assertThat(heard.get("eyes/image_raw")).hasSizeBetween(20, 31); // ten a second
        listen("eyes/depth/image_raw", "sensor_msgs/msg/Image");
        listen("eyes/depth/camera_info", "sensor_msgs/msg/CameraInfo");
        putRed(2, 0);
        advance(2);
        RosMessage image = newest("eyes/image_raw");
        assertThat(image.text("encoding")).isEqualTo("rgb8");
        assertThat(image.integer("step")).isEqualTo(480);
        byte[] colors = image.get("data", byte[].class);
        assertThat(colors).hasSize(3 * 160 * 120);
        int middle = 3 * (60 * 160 + 80);
        assertThat(new byte[] {colors[middle], colors[middle + 1], colors[middle + 2]})
                .containsExactly(255, 0, 0);
        RosMessage depth = newest("eyes/depth/image_raw");
        assertThat(depth.text("encoding")).isEqualTo("16UC1");
        int millimeters = ByteBuffer.wrap(depth.get("data", byte[].class))
                .order(ByteOrder.LITTLE_ENDIAN)
                .getShort(2 * (60 * 160 + 80));
        assertThat(millimeters).isBetween(1_500, 2_000);
        double[] k = newest("eyes/depth/camera_info").get("k", double[].class);
        assertThat(k[0]).isCloseTo(80 / Math.tan(Math.toRadians(30)), within(0.1));
        assertThat(newest("eyes/depth/camera_info").message("header")).isEqualTo(depth.message("header"));
    }

    private final List<CompletableFuture<byte[]>> answers = new ArrayList<>();

    /// @param id of the goal
    private void send(String action, int id, double position) {
        var uuid = new byte[16];
        uuid[0] = (byte) id;
        byte[] goal = new CdrWriter().int8s(uuid).float64(position).float64(0).toBytes();
        there.client(action + "send_goal", "control_msgs/action/GripperCommand_SendGoal")
                .call(goal);
        run.runPending();
        answers.add(there.client(action + "get_result", "control_msgs/action/GripperCommand_GetResult")
                .call(new CdrWriter().int8s(uuid).toBytes())
                .toCompletableFuture());
        run.runPending();
    }

    private RosMessage result(int number) throws InvalidCdr {
        MessageCodec codec = MessageCodec.of(TYPES.get("control_msgs/action/GripperCommand_GetResult_Response"), TYPES);
        return codec.read(CdrReader.of(ByteBuffer.wrap(answers.get(number).join())));
    }

    /// Its paddles are 0.24 m apart when they are open.
    @ParameterizedTest
    @CsvSource({"0, CLOSED, 0", "0.1, CLOSED, 0", "0.14, OPEN, 0.24", "0.5, OPEN, 0.24"})
    void aGripperGoesToTheNearerPlace(double position, Paddles expected, double gap) throws InvalidCdr {
        listen("joint_states", "sensor_msgs/msg/JointState");
        send(GRIPPER, 1, position);
        advance(3);
        assertThat(robot().require(Gripper.class).latest().orElseThrow().value().paddles())
                .isEqualTo(expected);
        assertThat(result(0).integer("status")).isEqualTo(4);
        RosMessage its = result(0).message("result");
        assertThat(its.number("position")).isCloseTo(gap, within(1e-9));
        assertThat(its.get("reached_goal", Boolean.class)).isTrue();
        assertThat(its.get("stalled", Boolean.class)).isFalse();
        RosMessage joints = newest("joint_states");
        assertThat(joints.fields()).containsEntry("name", List.of("gripper_joint", "gripper_lift_joint"));
        assertThat(joints.get("position", double[].class)[0]).isCloseTo(gap, within(1e-9));
    }

    @Test
    void whatItHoldsStallsIt() throws InvalidCdr {
        listen("gripper/holding", "std_msgs/msg/Bool", Profile.LATCHED);
        put(Thing.of(
                        "can",
                        START.compose(new Pose2d(0.31, 0, 0)),
                        Solid.standing(new Shape.Disc(new Point2d(0, 0), 0.05), 0.15),
                        new Rgb(255, 0, 0))
                .asGrippable());
        send(GRIPPER, 1, 0);
        advance(3);
        boolean isHolding =
                robot().require(Gripper.class).latest().orElseThrow().value().holding();
        assertThat(isHolding).isTrue();
        assertThat(result(0).integer("status")).isEqualTo(4);
        assertThat(result(0).message("result").get("stalled", Boolean.class)).isTrue();
        assertThat(result(0).message("result").get("reached_goal", Boolean.class))
                .isFalse();
        assertThat(result(0).message("result").number("position")).isCloseTo(0.1, within(1e-6));
        assertThat(newest("gripper/holding").get("data", Boolean.class)).isTrue();
        assertThat(heard.get("gripper/holding")).as("told when it changes").hasSize(2);
    }

    @Test
    void aNewGoalTakesThePlaceOfTheOldOneAndTheLiftIsAnother() throws InvalidCdr {
        send(GRIPPER, 1, 0);
        send("/r1/gripper_lift_controller/gripper_cmd/_action/", 2, 0.2);
        advance(0.5);
        send(GRIPPER, 3, 0.24);
        advance(4);
        assertThat(result(0).integer("status")).as("preempted").isEqualTo(6);
        assertThat(result(1).integer("status")).isEqualTo(4);
        assertThat(result(2).integer("status")).isEqualTo(4);
        assertThat(robot().require(Gripper.class).latest().orElseThrow().value().lift())
                .isEqualTo(Lift.UP);
    }

    @ParameterizedTest
    @CsvSource({"NaN", "Infinity"})
    void aPositionThatIsNoneIsRefused(double position) throws InvalidCdr {
        send(GRIPPER, 1, position);
        advance(1);
        assertThat(result(0).integer("status")).isEqualTo(6);
        assertThat(robot().require(Gripper.class).latest().orElseThrow().value().paddles())
                .isEqualTo(Paddles.OPEN);
    }
}
