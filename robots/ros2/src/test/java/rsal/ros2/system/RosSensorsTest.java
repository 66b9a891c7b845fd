package rsal.ros2.system;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.time.Duration;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import rsal.data.Blobs;
import rsal.data.Blobs.Blob;
import rsal.data.Odometry;
import rsal.data.Point2d;
import rsal.data.Pose2d;
import rsal.data.Rgb;
import rsal.data.Twist2d;
import rsal.device.BlobFinder;
import rsal.device.camera.Camera;
import rsal.device.camera.CameraImage;
import rsal.device.imu.Imu;
import rsal.device.imu.ImuReading;
import rsal.robot.Robot;
import rsal.ros2.MemoryNetwork;
import rsal.ros2.cdr.CdrWriter;
import rsal.ros2.link.Profile;
import rsal.ros2.link.RosLink;
import rsal.ros2.link.RosPublisher.Publication;
import rsal.ros2.link.RosTopic;
import rsal.ros2.message.FrameTransform;
import rsal.ros2.message.FrameTransform.Quaternion;
import rsal.ros2.message.RosMessages;
import rsal.ros2.message.RosMessages.Transform;
import rsal.time.LockstepScheduler;

/// Sensors of robots that are not ours: mounted in any orientation, with what drivers leave out, in all encodings.
class RosSensorsTest {
    private static final Duration STEP = Duration.ofMillis(50);
    private static final long DAMAGED = Boolean.getBoolean("rsal.test.all") ? 1_000_000 : 5_000;

    private final LockstepScheduler run = new LockstepScheduler();
    private final MemoryNetwork network = new MemoryNetwork();
    private final RosLink there = network.join();
    private final RosMessages messages = new RosMessages();
    private Publication odometry;
    private Publication imus;
    private Publication detections;
    private Publication colors;
    private Publication depths;
    private Publication infos;
    private Publication fixed;
    private Ros2System system;

    @BeforeEach
    void robotIsThere() {
        odometry = advertise("odom", "nav_msgs/msg/Odometry");
        there.subscribe(new RosTopic("/r1/cmd_vel", "geometry_msgs/msg/Twist"), Profile.DEFAULT, _ -> {});
        imus = advertise("imu", "sensor_msgs/msg/Imu");
        detections = advertise("camera/detections", "vision_msgs/msg/Detection2DArray");
        fixed = there.advertise(new RosTopic("/r1/tf_static", "tf2_msgs/msg/TFMessage"), Profile.LATCHED);
        colors = advertise("oak/rgb/image_raw", "sensor_msgs/msg/Image");
        infos = advertise("oak/rgb/camera_info", "sensor_msgs/msg/CameraInfo");
    }

    private Publication advertise(String name, String type) {
        return there.advertise(new RosTopic("/r1/" + name, type), Profile.DEFAULT);
    }

    @AfterEach
    void close() {
        system.close();
    }

    private Robot robot() {
        var parts = new LinkedHashMap<String, String>();
        parts.put("imu", "imu-bmi088");
        parts.put("camera", "blob-camera");
        parts.put("eyes", "depth-camera");
        system = new OneRobot(network, run).system(parts);
        var found = system.discover().toCompletableFuture();
        for (int i = 0; i < 60; i++) {
            advance();
        }
        return found.join().getFirst();
    }

    private void advance() {
        odometry.publish(messages.odometry(
                run.instant(), new Odometry(Pose2d.ORIGIN, Twist2d.STOP, false), "odom", "base_link"));
        run.advance(STEP);
    }

    private void mount(String frame, double x, Quaternion rotation) {
        var mounted = new FrameTransform(x, 0, 0.2, rotation);
        fixed.publish(messages.transforms(List.of(new Transform(run.instant(), "base_link", frame, mounted))));
    }

    private CdrWriter header(String frame) {
        return RosMessages.write(new CdrWriter(), run.instant()).text(frame);
    }

    private byte[] imu(Quaternion orientation, double known, double[] velocity, double[] acceleration) {
        CdrWriter message = header("imu_link");
        message.float64(orientation.x()).float64(orientation.y());
        message.float64(orientation.z()).float64(orientation.w());
        message.float64(known).float64s(new double[8]);
        message.float64s(velocity).float64s(new double[9]);
        return message.float64s(acceleration).float64s(new double[9]).toBytes();
    }

    private static ImuReading reading(Robot robot) {
        return robot.require(Imu.class).latest().orElseThrow().value();
    }

    /// Upside down: turned about its x axis by 180°, so that its y and z axes point the other way.
    @Test
    void anImuThatIsMountedUpsideDownIsTurnedBack() {
        mount("imu_link", 0.1, new Quaternion(1, 0, 0, 0));
        Robot robot = robot();
        double half = 0.4; // of a heading of 0.8
        var heading = new Quaternion(0, 0, Math.sin(half), Math.cos(half));
        imus.publish(imu(
                heading.times(new Quaternion(1, 0, 0, 0)), 0, new double[] {0, 0, -0.3}, new double[] {0.5, -0.2, -9.81
                }));
        advance();
        ImuReading reading = reading(robot);
        assertThat(reading.orientation()).isCloseTo(0.8, within(1e-9));
        assertThat(reading.angularVelocity()).isCloseTo(0.3, within(1e-9));
        assertThat(reading.accelerationX()).isCloseTo(0.5, within(1e-9));
        assertThat(reading.accelerationY()).isCloseTo(0.2, within(1e-9));
    }

    /// As drivers without a filter publish it: by a covariance of -1 (REP 145), or with nothing filled in.
    @ParameterizedTest
    @CsvSource({"-1, 1", "0, 0"})
    void anImuWithoutOrientationGetsOneByItsAngularVelocity(double covariance, double w) {
        Robot robot = robot();
        for (int i = 0; i < 21; i++) {
            imus.publish(
                    imu(new Quaternion(0, 0, 0, w), covariance, new double[] {0, 0, 0.5}, new double[] {0, 0, 9.81}));
            advance();
        }
        assertThat(reading(robot).orientation()).isCloseTo(0.5, within(1e-6)); // after 1 s
    }

    private byte[] detection(String frame, String color, double[] box, double[] place) {
        CdrWriter message = header(frame).int32(1);
        RosMessages.write(message, run.instant())
                .text(frame)
                .int32(1)
                .text(color)
                .float64(0.9);
        message.float64s(place).float64(0).float64(0).float64(0).float64(1).float64s(new double[36]);
        return message.float64(box[0])
                .float64(box[1])
                .float64(0)
                .float64(box[2])
                .float64(box[3])
                .text("")
                .toBytes();
    }

    private Blobs blobs(Robot robot) {
        return robot.require(BlobFinder.class).latest().orElseThrow().value();
    }

    /// The image has 80 × 60 px over 90°, which is what the model says.
    @Test
    void aDetectionWithoutAPlaceHasTheBearingOfItsBox() {
        Robot robot = robot();
        detections.publish(detection("nowhere", "#2ca02c", new double[] {20, 30, 10, 20}, new double[3]));
        advance();
        Blob blob = blobs(robot).blobs().getFirst();
        assertThat(blob.color()).isEqualTo(new Rgb(0x2c, 0xa0, 0x2c));
        assertThat(blobs(robot).bearing(blob)).isCloseTo(Math.toRadians(22.5), within(1e-9));
        assertThat(blob.range()).isNaN();
        assertThat(blob.area()).isEqualTo(180);
    }

    /// An optical frame has z ahead and x to the right.
    @Test
    void aDetectionWithAPlaceHasItsRangeAlsoInAnOpticalFrame() {
        mount("lens", 0.1, FrameTransform.OPTICAL.rotation());
        Robot robot = robot();
        detections.publish(detection("lens", "#ff0000", new double[] {40, 30, 30, 20}, new double[] {0.2, 0, 2}));
        advance();
        Blobs blobs = blobs(robot);
        assertThat(blobs.baseFromCamera().isNear(new Pose2d(0.1, 0, 0), 1e-9, 1e-9))
                .isTrue();
        Blob blob = blobs.blobs().getFirst();
        assertThat(blob.range()).isCloseTo(Math.hypot(0.2, 2), within(1e-9));
        assertThat(blobs.bearing(blob)).isCloseTo(-Math.atan2(0.2, 2), within(1e-9));
        assertThat(blobs.baseFromBlob(blob).orElseThrow().distanceTo(new Point2d(2.1, -0.2)))
                .isLessThan(1e-9);
    }

    @ParameterizedTest
    @CsvSource({"cup, 20, 10", "#2ca02c, 200, 10", "#2ca02c, NaN, 10", "#2ca02c, 20, -5"})
    void whatIsNoColorOrNotInTheImageIsLeftOut(String color, double x, double size) {
        Robot robot = robot();
        detections.publish(detection("lens", color, new double[] {x, 30, size, 20}, new double[3]));
        advance();
        assertThat(blobs(robot).blobs()).isEmpty();
    }

    private byte[] image(int width, int height, String encoding, int step, boolean isBig, byte[] data) {
        return header("lens")
                .int32(height)
                .int32(width)
                .text(encoding)
                .bool(isBig)
                .int32(step)
                .int32(data.length)
                .int8s(data)
                .toBytes();
    }

    private static CameraImage seen(Robot robot) {
        return robot.require(Camera.class).latest().orElseThrow().value();
    }

    @ParameterizedTest
    @CsvSource({"rgb8, 3, 112233", "bgr8, 3, 332211", "rgba8, 4, 112233", "bgra8, 4, 332211", "mono8, 1, 111111"})
    void aCameraWithoutDepthSeesColorsInEachEncoding(String encoding, int pixel, String expected) {
        Robot robot = robot();
        int step = 2 * pixel + 3; // rows may be padded
        var data = new byte[2 * step];
        for (int i = 0; i < pixel; i++) {
            data[step + pixel + i] = new byte[] {0x11, 0x22, 0x33, 0x44}[i]; // of the lower right pixel
        }
        infos.publish(header("lens")
                .int32(2)
                .int32(4)
                .text("plumb_bob")
                .int32(0)
                .float64s(new double[] {300, 0, 2, 0, 300, 1, 0, 0, 1})
                .float64s(new double[9])
                .float64s(new double[12])
                .int32s(new int[6])
                .bool(false)
                .toBytes());
        colors.publish(image(2, 2, encoding, step, false, data));
        advance();
        CameraImage image = seen(robot);
        assertThat(image.color(1, 1)).isEqualTo(Integer.parseInt(expected, 16));
        assertThat(image.color(0, 0)).isZero();
        assertThat(image.depth(1, 1)).isEqualTo(Double.POSITIVE_INFINITY);
        assertThat(image.focalLength()).isEqualTo(150); // of an image half as wide as that of the info
    }

    @ParameterizedTest
    @CsvSource({"16UC1, false", "16UC1, true", "32FC1, false", "32FC1, true"})
    void depthComesWithTheColorOfItsTimeInEachEncoding(String encoding, boolean isBig) {
        depths = advertise("oak/depth/image_raw", "sensor_msgs/msg/Image");
        Robot robot = robot();
        ByteBuffer data = ByteBuffer.allocate(16).order(isBig ? ByteOrder.BIG_ENDIAN : ByteOrder.LITTLE_ENDIAN);
        boolean isMeters = encoding.equals("32FC1");
        for (double meters : new double[] {0, 1.5, 2.25, isMeters ? Double.NaN : 0}) {
            if (isMeters) {
                data.putFloat((float) meters);
            } else {
                data.putShort((short) (1_000 * meters));
            }
        }
        int pixel = isMeters ? 4 : 2;
        byte[] far = image(2, 2, encoding, 2 * pixel, isBig, data.array());
        depths.publish(far);
        advance();
        assertThat(robot.require(Camera.class).latest()).as("without color").isEmpty();
        byte[] late = image(2, 2, encoding, 2 * pixel, isBig, data.array());
        for (int i = 0; i < 3; i++) {
            colors.publish(image(2, 2, "rgb8", 6, false, new byte[12]));
            advance();
            assertThat(robot.require(Camera.class).latest())
                    .as("of other times")
                    .isEmpty();
        }
        depths.publish(late); // of the first of them
        advance();
        CameraImage image = seen(robot);
        assertThat(image.depth(1, 0)).isCloseTo(1.5, within(1e-9));
        assertThat(image.depth(0, 1)).isCloseTo(2.25, within(1e-9));
        assertThat(image.depth(0, 0)).isEqualTo(Double.POSITIVE_INFINITY);
        assertThat(image.depth(1, 1)).isEqualTo(Double.POSITIVE_INFINITY);
    }

    @ParameterizedTest
    @CsvSource({
        "2, 2, rgb8, 6, 11",
        "2, 2, rgb8, 5, 12",
        "0, 2, rgb8, 6, 12",
        "2, 2, bayer_rggb8, 2, 4",
        "2147483647, 2147483647, mono8, 2147483647, 4",
        "-1, 2, mono8, 2, 4",
        "9000, 1, mono8, 9000, 9000"
    })
    void anImageThatIsNoneIsLeftOut(int width, int height, String encoding, int step, int size) {
        Robot robot = robot();
        colors.publish(image(width, height, encoding, step, false, new byte[size]));
        advance();
        assertThat(robot.require(Camera.class).latest()).isEmpty();
    }

    @Test
    void damagedMessagesHarmNobody() {
        depths = advertise("oak/depth/image_raw", "sensor_msgs/msg/Image");
        Robot robot = robot();
        var random = new SplittableRandom(5);
        var senders = new LinkedHashMap<Publication, byte[]>();
        senders.put(imus, imu(new Quaternion(0, 0, 0, 1), 0, new double[3], new double[3]));
        senders.put(detections, detection("lens", "#ff0000", new double[] {40, 30, 10, 20}, new double[] {1, 0, 0}));
        senders.put(colors, image(4, 4, "rgb8", 12, false, new byte[48]));
        senders.put(depths, image(4, 4, "16UC1", 8, false, new byte[32]));
        for (long i = 0; i < DAMAGED; i++) {
            senders.forEach((sender, message) -> {
                byte[] damaged = message.clone();
                for (int change = random.nextInt(6); change >= 0; change--) {
                    damaged[4 + random.nextInt(damaged.length - 4)] = (byte) random.nextInt();
                }
                sender.publish(damaged);
            });
            run.runPending();
        }
        advance();
        senders.forEach(Publication::publish);
        colors.publish(image(4, 4, "rgb8", 12, false, new byte[48]));
        depths.publish(image(4, 4, "16UC1", 8, false, new byte[32]));
        advance();
        assertThat(robot.require(Imu.class).latest()).isPresent();
        assertThat(blobs(robot).blobs()).hasSize(1);
        assertThat(seen(robot).width()).isEqualTo(4);
    }
}
