package rsal.server.frame;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.time.Instant;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import rsal.data.Covariance2d;
import rsal.data.GripperState;
import rsal.data.LaserScan;
import rsal.data.Odometry;
import rsal.data.ParticleCloud;
import rsal.data.Path2d;
import rsal.data.Point2d;
import rsal.data.Pose2d;
import rsal.data.PoseEstimate;
import rsal.data.PoseEstimate.Hypothesis;
import rsal.data.RangeArray;
import rsal.data.Shape;
import rsal.data.Solid;
import rsal.data.Stamped;
import rsal.data.Twist2d;
import rsal.device.SimulationControl.Standing;
import rsal.engine.report.Answer;
import rsal.engine.report.RobotView;
import rsal.engine.report.Snapshot;

class FrameEncoderTest {
    private static final Path FIXTURES = Path.of("../web/src/live/fixtures");

    private final FrameEncoder encoder = new FrameEncoder();

    /// The page's tests decode the same bytes. `-Drsal.update=true` writes them anew.
    @Test
    void writesWhatThePageReads() throws IOException {
        byte[] frame = encoder.encode(
                3,
                17,
                snapshot(List.of(full(), bare())),
                List.of("full", "bare", "gone"),
                List.of(moved(4, 0.125), moved(70_000, 1e9)));
        Path golden = FIXTURES.resolve("frame.bin");
        if (Boolean.getBoolean("rsal.update")) {
            Files.createDirectories(FIXTURES);
            Files.write(golden, frame);
        }
        assertThat(frame).isEqualTo(Files.readAllBytes(golden));
    }

    @Test
    void needs16BytesAThingThatWasMoved() {
        List<Standing> moved = java.util.Collections.nCopies(1000, moved(1, 0));
        assertThat(encoder.encode(1, 1, snapshot(List.of()), List.of(), moved))
                .hasSize(FrameEncoder.HEADER_BYTES + 16 * 1000);
    }

    @Test
    void needs16BytesARobotAnd2ABeam() {
        int none = encode(List.of()).length;
        assertThat(encode(List.of(bare())).length - none).isEqualTo(16);
        assertThat(encode(List.of(scanning(400))).length - encode(List.of(scanning(0))).length)
                .isEqualTo(800);
    }

    @Test
    void keepsEveryBlockOnAMultipleOf4() {
        for (int beams = 0; beams < 5; beams++) {
            assertThat(encode(List.of(scanning(beams), full())).length % 4).isZero();
        }
    }

    @Test
    void growsForLargeTeams() {
        List<RobotView> robots = java.util.Collections.nCopies(2000, scanning(682));
        List<String> ids = java.util.Collections.nCopies(2000, "scanning");
        byte[] frame = encoder.encode(1, 1, snapshot(robots), ids, List.of());
        assertThat(frame).hasSize(FrameEncoder.HEADER_BYTES + 2000 * (16 + 32 + 2 * 682));
    }

    @Test
    void sendsNoMoreParticlesThanCanBeSeen() {
        var cloud = new ParticleCloud(new float[3 * 100_000], new float[100_000]);
        var robot = robot("r", Optional.of(Pose2d.ORIGIN), Optional.empty(), Optional.of(cloud), Optional.empty());
        assertThat(encode(List.of(robot)).length).isLessThan(100 + 8 * FrameEncoder.MAX_PARTICLES);
    }

    @Test
    void reportsNoEstimateThatLiesNobodyKnowsWhere() {
        var truth = Optional.of(Pose2d.ORIGIN);
        var estimate = PoseEstimate.of(new Pose2d(1, 2, 0), Covariance2d.ofDeviations(0.1, 0.1, 0.1));
        RobotView reported = robot("r", truth, Optional.of(estimate), Optional.empty(), Optional.empty());
        RobotView own = robot(
                "r",
                truth,
                Optional.of(new Stamped<>(Instant.EPOCH, "r/map", estimate)),
                Optional.empty(),
                Optional.empty(),
                "");
        assertThat(encode(List.of(own))).hasSameSizeAs(encode(List.of(bare())));
        assertThat(encode(List.of(reported))).hasSizeGreaterThan(encode(List.of(own)).length);
    }

    @Test
    void reportsWhereOdometryBeganUnlessTheLocalizerIsSilent() {
        var odometry = new Odometry(new Pose2d(1, 0, 0), Twist2d.STOP, false);
        var estimate = Optional.of(PoseEstimate.of(new Pose2d(5, 2, 0), Covariance2d.ofDeviations(0.1, 0.1, 0.1)));
        assertThat(odom(odometry, 100, estimate)).contains(new Pose2d(4, 2, 0));
        assertThat(odom(odometry, 5000, estimate)).isEmpty();
        assertThat(odom(odometry, 5000, Optional.empty())).contains(new Pose2d(0, 0, 0)); // the truth
        var broken = new Odometry(new Pose2d(Double.NaN, 0, 0), Twist2d.STOP, false);
        assertThat(odom(broken, 0, estimate)).isEmpty();
    }

    /// Of a robot at (1, 0), whose frame of odometry is the last of its blocks.
    private Optional<Pose2d> odom(Odometry odometry, long millis, Optional<PoseEstimate> estimate) {
        var reported = new Stamped<>(Instant.EPOCH.plusMillis(millis), "r/odom", odometry);
        var robot = new RobotView(
                "r",
                "hunter",
                "#0072b2",
                "pioneer3at",
                false,
                Optional.empty(),
                Optional.of(new Pose2d(1, 0, 0)),
                Optional.of(reported),
                estimate.map(FrameEncoderTest::stamped),
                Optional.empty(),
                Optional.empty(),
                Optional.empty(),
                Optional.empty(),
                Path2d.EMPTY,
                Path2d.EMPTY,
                Optional.empty(),
                "",
                "",
                "",
                Optional.empty(),
                false,
                false,
                false,
                List.of(),
                Optional.empty(),
                List.of(),
                List.of());
        byte[] frame = encode(List.of(robot));
        ByteBuffer bytes = ByteBuffer.wrap(frame).order(ByteOrder.LITTLE_ENDIAN);
        boolean isReported = (bytes.getShort(FrameEncoder.HEADER_BYTES + 14) & FrameEncoder.ODOM) != 0;
        int at = frame.length - 12;
        return isReported
                ? Optional.of(new Pose2d(bytes.getInt(at) / 1e3, bytes.getInt(at + 4) / 1e3, 0))
                : Optional.empty();
    }

    @Test
    void saturatesWhatIsOutOfReach() {
        var far = robot(
                "far", Optional.of(new Pose2d(1e9, -1e9, 0)), Optional.empty(), Optional.empty(), Optional.empty());
        ByteBuffer frame = ByteBuffer.wrap(encode(List.of(far))).order(ByteOrder.LITTLE_ENDIAN);
        assertThat(frame.getInt(FrameEncoder.HEADER_BYTES)).isEqualTo(Integer.MAX_VALUE);
        assertThat(frame.getInt(FrameEncoder.HEADER_BYTES + 4)).isEqualTo(Integer.MIN_VALUE);
    }

    private byte[] encode(List<RobotView> robots) {
        return encoder.encode(
                1, 1, snapshot(robots), robots.stream().map(RobotView::id).toList(), List.of());
    }

    private static Snapshot snapshot(List<RobotView> robots) {
        return new Snapshot(
                5,
                Duration.ofMillis(12_300),
                true,
                true,
                Double.POSITIVE_INFINITY,
                42.5,
                Optional.of("success"),
                robots,
                List.of(),
                List.of(),
                List.of(),
                Answer.Linked.NONE);
    }

    private static Standing moved(int number, double height) {
        var body = Solid.standing(new Shape.Disc(new Point2d(0, 0), 1), 1);
        return new Standing(number, "thing", body, new Pose2d(-1.5, 2.25, 1), height, false);
    }

    /// A robot with one of everything; the page's `frame.test.ts` knows these numbers.
    private static RobotView full() {
        var scan = new LaserScan(new Pose2d(0.1, -0.05, 0.5), -1.5, 0.5, 0.02, 4, new float[] {
            1.234f, Float.POSITIVE_INFINITY, Float.NEGATIVE_INFINITY, Float.NaN, 4.0f
        });
        var ranges =
                new RangeArray(List.of(new Pose2d(0.2, 0.1, 1), new Pose2d(0.2, -0.1, -1)), 0.5, 0.1, 80, new float[] {
                    40f, Float.POSITIVE_INFINITY
                });
        var here = new Pose2d(-12.3, 6.8, 3);
        var covariance = new Covariance2d(0.25, 0.125, 0, 0.5, 0, 0.04);
        var estimate = new PoseEstimate(
                here,
                covariance,
                List.of(
                        new Hypothesis(0.5, here, covariance),
                        new Hypothesis(0.25, new Pose2d(4, -2, 1), new Covariance2d(1, 0.5, 0, 2, 0, 1)),
                        new Hypothesis(0.2, new Pose2d(5, -2, 1), covariance)),
                0.5,
                PoseEstimate.Quality.AMBIGUOUS);
        var particles = new ParticleCloud(new float[] {1, 2, 0, 1.5f, 2.25f, -1.5f}, new float[] {0.25f, 0.75f});
        return new RobotView(
                "full",
                "hunter",
                "#0072b2",
                "pioneer3at",
                false,
                Optional.empty(),
                Optional.of(new Pose2d(-12.345, 6.789, -2.5)),
                Optional.of(stamped(new Odometry(new Pose2d(1, 2, 0.5), new Twist2d(0.4, -0.1, -0.25), true))),
                Optional.of(stamped(estimate)),
                Optional.of(stamped(particles)),
                Optional.of(stamped(scan)),
                Optional.of(stamped(ranges)),
                Optional.empty(),
                new Path2d(List.of(new Point2d(-12.3, 6.8), new Point2d(0, -1.5))),
                new Path2d(List.of(new Point2d(-12.3, 6.8), new Point2d(-12.7, 6.4), new Point2d(-12.9, 5.9))),
                Optional.of(new Pose2d(0, -1.5, 0.75)),
                "",
                "",
                "",
                Optional.of(stamped(new GripperState(
                        GripperState.Paddles.CLOSED,
                        0.25,
                        GripperState.Lift.STOPPED,
                        0.5,
                        false,
                        false,
                        true,
                        true,
                        true))),
                false,
                false,
                true,
                List.of(),
                Optional.empty(),
                List.of(),
                List.of());
    }

    /// A robot of which nothing is known but where it is.
    private static RobotView bare() {
        return robot("bare", Optional.of(new Pose2d(1, 2, 0)), Optional.empty(), Optional.empty(), Optional.empty());
    }

    private static RobotView scanning(int beams) {
        var scan = new LaserScan(Pose2d.ORIGIN, 0, 0.01, 0.02, 4, new float[beams]);
        return robot("scanning", Optional.of(Pose2d.ORIGIN), Optional.empty(), Optional.empty(), Optional.of(scan));
    }

    private static RobotView robot(
            String id,
            Optional<Pose2d> truth,
            Optional<PoseEstimate> estimate,
            Optional<ParticleCloud> particles,
            Optional<LaserScan> scan) {
        return robot(id, truth, estimate.map(FrameEncoderTest::stamped), particles, scan, "");
    }

    private static RobotView robot(
            String id,
            Optional<Pose2d> truth,
            Optional<Stamped<PoseEstimate>> estimate,
            Optional<ParticleCloud> particles,
            Optional<LaserScan> scan,
            String behavior) {
        return new RobotView(
                id,
                "hunter",
                "#0072b2",
                "pioneer3at",
                false,
                Optional.empty(),
                truth,
                Optional.empty(),
                estimate,
                particles.map(FrameEncoderTest::stamped),
                scan.map(FrameEncoderTest::stamped),
                Optional.empty(),
                Optional.empty(),
                Path2d.EMPTY,
                Path2d.EMPTY,
                Optional.empty(),
                "",
                behavior,
                "",
                Optional.empty(),
                false,
                false,
                false,
                List.of(),
                Optional.empty(),
                List.of(),
                List.of());
    }

    private static <T> Stamped<T> stamped(T value) {
        return new Stamped<>(Instant.EPOCH, "map", value);
    }
}
