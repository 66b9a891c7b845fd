package rsal.ros2.message;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import rsal.data.LaserScan;
import rsal.data.Pose2d;
import rsal.ros2.cdr.CdrReader;
import rsal.ros2.cdr.CdrWriter;
import rsal.ros2.cdr.MessageCodec;
import rsal.ros2.message.FrameTransform.Quaternion;
import rsal.ros2.type.Distribution;
import rsal.ros2.type.TypeLibrary;

class ScanMessageTest {
    private static final TypeLibrary JAZZY = TypeLibrary.of(Distribution.JAZZY);
    private static final MessageCodec CODEC = MessageCodec.of(JAZZY.get("sensor_msgs/msg/LaserScan"), JAZZY);

    private static byte[] bytes(String frame, float angleMin, float increment, float... ranges) {
        var writer = new CdrWriter();
        writer.int32(12).int32(500_000_000).text(frame);
        writer.float32(angleMin)
                .float32(angleMin + increment * (ranges.length - 1))
                .float32(increment)
                .float32(0)
                .float32(0.1f)
                .float32(0.1f)
                .float32(10);
        writer.int32(ranges.length).float32s(ranges);
        writer.int32(0);
        return writer.toBytes();
    }

    /// Both ways to read agree, whatever is in the message.
    @Test
    void isReadFromBytesAsFieldByField() throws Exception {
        var random = new SplittableRandom(1);
        for (int i = 0; i < 500; i++) {
            var ranges = new float[random.nextInt(1, 50)];
            for (int k = 0; k < ranges.length; k++) {
                ranges[k] = (float) random.nextDouble(-1, 12);
            }
            String frame = "laser".repeat(random.nextInt(3));
            byte[] bytes = bytes(frame, (float) random.nextDouble(-3, 0), 0.01f, ranges);
            ScanMessage slow = ScanMessage.of(CODEC.read(CdrReader.of(bytes)));
            ScanMessage fast = ScanMessage.read(CdrReader.of(bytes), random.nextBoolean() ? "laser" : "base_scan");
            assertThat(fast.frame()).isEqualTo(slow.frame());
            assertThat(fast.stamp()).isEqualTo(slow.stamp()).isEqualTo(12_500_000_000L);
            assertThat(fast.angleMin()).isEqualTo(slow.angleMin());
            assertThat(fast.angleIncrement()).isEqualTo(slow.angleIncrement());
            assertThat(fast.rangeMin()).isEqualTo(slow.rangeMin());
            assertThat(fast.rangeMax()).isEqualTo(slow.rangeMax());
            assertThat(fast.ranges()).isEqualTo(slow.ranges());
        }
    }

    @Test
    void rangesAreThoseOfRep117() throws Exception {
        byte[] bytes = bytes("laser", 0, 0.1f, 0.05f, 5, 10, 11, Float.NaN, -1, Float.POSITIVE_INFINITY);
        ScanMessage message = ScanMessage.read(CdrReader.of(bytes), "laser");
        assertThat(message.broken()).isEqualTo(2);
        LaserScan scan = message.scan(FrameTransform.NONE, 100);
        float far = Float.POSITIVE_INFINITY;
        assertThat(scan.ranges()).containsExactly(Float.NEGATIVE_INFINITY, 5, far, far, Float.NaN, Float.NaN, far);
    }

    /// A beam to the left that hits at 3 m stays one, however the laser is mounted and sweeps.
    @Test
    void clockwiseAndUpsideDownLasersSeeTheSame() throws Exception {
        var upsideDown = new FrameTransform(0.2, 0, 0.1, new Quaternion(1, 0, 0, 0));
        LaserScan plain = ScanMessage.read(CdrReader.of(bytes("l", -0.2f, 0.1f, 1, 2, 4, 5, 3)), "l")
                .scan(FrameTransform.NONE, 100);
        LaserScan clockwise = ScanMessage.read(CdrReader.of(bytes("l", 0.2f, -0.1f, 3, 5, 4, 2, 1)), "l")
                .scan(FrameTransform.NONE, 100);
        LaserScan turned = ScanMessage.read(CdrReader.of(bytes("l", -0.2f, 0.1f, 3, 5, 4, 2, 1)), "l")
                .scan(upsideDown, 100);
        assertThat(clockwise.ranges()).isEqualTo(plain.ranges());
        assertThat(turned.ranges()).isEqualTo(plain.ranges());
        for (LaserScan scan : java.util.List.of(plain, clockwise, turned)) {
            assertThat(scan.angle(4)).isCloseTo(0.2, within(1e-6));
            assertThat(scan.ranges()[4]).isEqualTo(3);
        }
        assertThat(turned.baseFromLaser()).isEqualTo(new Pose2d(0.2, 0, 0));
    }
}
