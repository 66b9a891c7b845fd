package rsal.ros2.message;

import java.time.Instant;
import java.util.SplittableRandom;
import org.openjdk.jmh.annotations.Benchmark;
import org.openjdk.jmh.annotations.Fork;
import org.openjdk.jmh.annotations.Measurement;
import org.openjdk.jmh.annotations.Scope;
import org.openjdk.jmh.annotations.Setup;
import org.openjdk.jmh.annotations.State;
import org.openjdk.jmh.annotations.Warmup;
import rsal.data.LaserScan;
import rsal.data.Pose2d;
import rsal.ros2.cdr.CdrReader;
import rsal.ros2.cdr.InvalidCdr;
import rsal.ros2.cdr.MessageCodec;
import rsal.ros2.type.Distribution;
import rsal.ros2.type.TypeLibrary;

/// Scans of 1,000 beams from their bytes [1/s], by a reader of their own against field by field by the definition of
/// the type.
@State(Scope.Thread)
@Fork(1)
@Warmup(iterations = 3, time = 2)
@Measurement(iterations = 5, time = 2)
public class ScanReading {
    private static final int BEAMS = 1_000;
    private static final String FRAME = "base_scan";

    private byte[] bytes = new byte[0];
    private MessageCodec codec;

    @Setup
    public void write() {
        TypeLibrary types = TypeLibrary.of(Distribution.JAZZY);
        codec = MessageCodec.of(types.get("sensor_msgs/msg/LaserScan"), types);
        var ranges = new float[BEAMS];
        var random = new SplittableRandom(1);
        for (int i = 0; i < BEAMS; i++) {
            ranges[i] = random.nextInt(10) == 0 ? Float.POSITIVE_INFINITY : (float) random.nextDouble(0.1, 30);
        }
        var scan = new LaserScan(Pose2d.ORIGIN, -2, 4.0 / BEAMS, 0.1, 30, ranges);
        bytes = new RosMessages().scan(Instant.EPOCH, scan, FRAME, 0.1);
    }

    @Benchmark
    public LaserScan kernel() throws InvalidCdr {
        return ScanMessage.read(CdrReader.of(bytes), FRAME).scan(FrameTransform.NONE, Double.POSITIVE_INFINITY);
    }

    @Benchmark
    public LaserScan slow() throws InvalidCdr {
        return ScanMessage.of(codec.read(CdrReader.of(bytes))).scan(FrameTransform.NONE, Double.POSITIVE_INFINITY);
    }
}
