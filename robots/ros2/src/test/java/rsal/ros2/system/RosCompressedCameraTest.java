package rsal.ros2.system;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.awt.image.BufferedImage;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import rsal.data.Odometry;
import rsal.data.Pose2d;
import rsal.data.Twist2d;
import rsal.device.Health;
import rsal.device.camera.Camera;
import rsal.device.camera.CameraImage;
import rsal.ros2.MemoryNetwork;
import rsal.ros2.cdr.CdrWriter;
import rsal.ros2.link.Profile;
import rsal.ros2.link.RosLink;
import rsal.ros2.link.RosPublisher.Publication;
import rsal.ros2.link.RosTopic;
import rsal.ros2.message.RosMessages;
import rsal.time.LockstepScheduler;

/// A camera that offers its images compressed only.
class RosCompressedCameraTest {
    private static final Duration STEP = Duration.ofMillis(50);

    private final LockstepScheduler run = new LockstepScheduler();
    private final MemoryNetwork network = new MemoryNetwork();
    private final RosLink there = network.join();
    private final RosMessages messages = new RosMessages();
    private final List<CameraImage> seen = new ArrayList<>();
    private Publication odometry;
    private Publication colors;
    private Publication depths;
    private Publication infos;
    private Ros2System system;
    private Camera camera;

    @BeforeEach
    void robotIsThere() {
        odometry = advertise("odom", "nav_msgs/msg/Odometry");
        there.subscribe(new RosTopic("/r1/cmd_vel", "geometry_msgs/msg/Twist"), Profile.DEFAULT, _ -> {});
        colors = advertise("oak/rgb/image_raw/compressed", "sensor_msgs/msg/CompressedImage");
        infos = advertise("oak/rgb/camera_info", "sensor_msgs/msg/CameraInfo");
        advertise("oak/depth/image_raw/compressed", "sensor_msgs/msg/CompressedImage"); // which can't be read
        advertise("oak/rgb/image_raw/compressedDepth", "sensor_msgs/msg/CompressedImage"); // as image_transport does
    }

    private void connect() {
        system = new OneRobot(network, run).system(Map.of("eyes", "depth-camera"));
        var found = system.discover().toCompletableFuture();
        for (int i = 0; i < 60; i++) {
            advance();
        }
        camera = found.join().getFirst().require(Camera.class);
        camera.subscribe(reading -> seen.add(reading.value()));
    }

    @AfterEach
    void close() {
        system.close();
    }

    private Publication advertise(String name, String type) {
        return there.advertise(new RosTopic("/r1/" + name, type), Profile.DEFAULT);
    }

    private void advance() {
        odometry.publish(messages.odometry(
                run.instant(), new Odometry(Pose2d.ORIGIN, Twist2d.STOP, false), "odom", "base_link"));
        run.advance(STEP);
    }

    private CdrWriter header() {
        return RosMessages.write(new CdrWriter(), run.instant()).text("lens");
    }

    private byte[] compressed(byte[] data) {
        return header().text("rgb8; png compressed bgr8")
                .int32(data.length)
                .int8s(data)
                .toBytes();
    }

    private static byte[] png(int color) throws IOException {
        var image = new BufferedImage(4, 2, BufferedImage.TYPE_INT_RGB);
        image.setRGB(3, 1, color);
        var out = new ByteArrayOutputStream();
        ImageIO.write(image, "png", out);
        return out.toByteArray();
    }

    @Test
    void itsColorsAreThoseOfThePictureAndItsFocalLengthThatOfTheInfoBesideThePlainTopic() throws Exception {
        connect();
        infos.publish(header().int32(2)
                .int32(8)
                .text("plumb_bob")
                .int32(0)
                .float64s(new double[] {300, 0, 2, 0, 300, 1, 0, 0, 1})
                .float64s(new double[9])
                .float64s(new double[12])
                .int32s(new int[6])
                .bool(false)
                .toBytes());
        colors.publish(compressed(png(0x102030)));
        advance();
        CameraImage image = seen.getLast();
        assertThat(image.width()).isEqualTo(4);
        assertThat(image.color(3, 1)).isEqualTo(0x102030);
        assertThat(image.depth(3, 1)).isEqualTo(Double.POSITIVE_INFINITY);
        assertThat(image.focalLength()).isEqualTo(150);
    }

    @Test
    void plainDepthComesWithIt() throws Exception {
        depths = advertise("oak/depth/image_raw", "sensor_msgs/msg/Image");
        connect();
        colors.publish(compressed(png(0x102030)));
        depths.publish(header().int32(2)
                .int32(4)
                .text("16UC1")
                .bool(false)
                .int32(8)
                .int32(16)
                .int16s(new short[] {0, 0, 0, 0, 0, 0, 0, 1500})
                .toBytes());
        advance();
        assertThat(seen.getLast().depth(3, 1)).isCloseTo(1.5, within(1e-9));
    }

    /// Depth is decoded if there are colors with it, of the same time.
    @Test
    void compressedDepthComesWithIt() throws Exception {
        depths = advertise("oak/depth/image_raw/compressedDepth", "sensor_msgs/msg/CompressedImage");
        connect();
        colors.publish(compressed(png(0x102030)));
        depths.publish(compressedDepth("16UC1; compressedDepth png", 0, 0, 1500));
        advance();
        advance();
        assertThat(seen.getLast().depth(3, 1)).isCloseTo(1.5, within(1e-9));
        assertThat(seen.getLast().depth(0, 0)).isEqualTo(Double.POSITIVE_INFINITY);
        seen.clear();
        depths.publish(compressedDepth("32FC1; compressedDepth", 2_000, 100, 1_100));
        colors.publish(compressed(png(0x102030)));
        advance();
        advance();
        assertThat(seen.getLast().depth(3, 1)).isCloseTo(2.0, within(1e-3));
        seen.clear();
        colors.publish(compressed(png(0x102030)));
        advance();
        depths.publish(compressedDepth("16UC1; compressedDepth png", 0, 0, 1500)); // 50 ms later
        advance();
        advance();
        assertThat(seen).isEmpty();
    }

    /// Depth is late and early in turn, as it takes time to compute.
    @Test
    void noImageIsLostBecauseItsDepthComesSoonAfterAnother() throws Exception {
        depths = advertise("oak/depth/image_raw/compressedDepth", "sensor_msgs/msg/CompressedImage");
        connect();
        for (int i = 0; i < 10; i++) {
            byte[] depth = compressedDepth("16UC1; compressedDepth png", 0, 0, 1500);
            colors.publish(compressed(png(i)));
            if (i % 2 == 0) {
                advance();
                depths.publish(depth);
            } else {
                depths.publish(depth);
                advance();
            }
            advance();
        }
        advance();
        assertThat(seen).hasSize(10);
    }

    /// Programs offer each image as compressed depth, too.
    @Test
    void compressedDepthIsNoColor() {
        colors.close();
        system = new OneRobot(network, run).system(Map.of("eyes", "depth-camera"));
        var found = system.discover().toCompletableFuture();
        for (int i = 0; i < 100; i++) {
            advance();
        }
        assertThat(found.join().getFirst().find(Camera.class)).isEmpty();
    }

    /// As `compressed_depth_image_transport` makes it.
    private byte[] compressedDepth(String format, float a, float b, int last) throws IOException {
        var image = new BufferedImage(4, 2, BufferedImage.TYPE_USHORT_GRAY);
        image.getRaster().setSample(3, 1, 0, last);
        var out = new ByteArrayOutputStream();
        out.write(ByteBuffer.allocate(12)
                .order(ByteOrder.LITTLE_ENDIAN)
                .putInt(0)
                .putFloat(a)
                .putFloat(b)
                .array());
        ImageIO.write(image, "png", out);
        return header().text(format).int32(out.size()).int8s(out.toByteArray()).toBytes();
    }

    @Test
    void damagedPicturesAreLeftOutAndTheCameraIsStaleWithoutOthers() throws Exception {
        connect();
        colors.publish(compressed(png(0x102030)));
        advance();
        for (int i = 0; i < 20; i++) {
            colors.publish(compressed(new byte[] {(byte) 0xff, (byte) 0xd8, (byte) 0xff, 1, 2, 3}));
            advance();
        }
        assertThat(seen).hasSize(1);
        assertThat(camera.health()).isInstanceOf(Health.Stale.class);
        colors.publish(compressed(png(0x102030)));
        advance();
        advance();
        colors.publish(compressed(png(0x102030)));
        advance();
        assertThat(camera.health()).isEqualTo(Health.ok());
    }

    /// As decoding takes time.
    @Test
    void tenImagesASecondAreDecodedAtMost() throws Exception {
        connect();
        for (int i = 0; i < 40; i++) {
            colors.publish(compressed(png(i)));
            advance();
        }
        assertThat(seen).hasSizeBetween(19, 21); // in 2 s
    }
}
