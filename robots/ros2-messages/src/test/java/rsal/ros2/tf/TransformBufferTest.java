package rsal.ros2.tf;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.nio.ByteBuffer;
import java.time.Duration;
import java.time.Instant;
import java.util.List;
import java.util.Optional;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import rsal.data.Pose2d;
import rsal.ros2.cdr.CdrReader;
import rsal.ros2.cdr.InvalidCdr;
import rsal.ros2.cdr.MessageCodec;
import rsal.ros2.message.FrameTransform;
import rsal.ros2.message.FrameTransform.Quaternion;
import rsal.ros2.message.RosMessages;
import rsal.ros2.message.RosMessages.Transform;
import rsal.ros2.tf.TransformLookup.Failure;
import rsal.ros2.tf.TransformLookup.Found;
import rsal.ros2.tf.TransformLookup.Reason;
import rsal.ros2.type.Distribution;
import rsal.ros2.type.TypeLibrary;
import rsal.testkit.Rounds;

@Timeout(120)
class TransformBufferTest {
    private static final long SECOND = 1_000_000_000;
    private static final long ROUNDS = Rounds.of(200, 20_000); // times 100 questions

    private final TransformBuffer buffer = new TransformBuffer(TransformBuffer.HISTORY);

    private static long stamp(double seconds) {
        return Math.round(seconds * SECOND);
    }

    private boolean add(double seconds, String parent, String child, Pose2d pose) {
        return buffer.add(new StampedTransform(stamp(seconds), parent, child, FrameTransform.of(pose)));
    }

    private void addFixed(String parent, String child, Pose2d pose) {
        buffer.addFixed(new StampedTransform(0, parent, child, FrameTransform.of(pose)));
    }

    private Pose2d pose(String target, String source, double seconds) {
        return buffer.find(target, source, stamp(seconds))
                .transform()
                .orElseThrow()
                .planar();
    }

    private Failure failure(String target, String source, double seconds) {
        return (Failure) buffer.find(target, source, stamp(seconds));
    }

    @Test
    void chainsLeadThroughTheTree() {
        add(1, "map", "odom", new Pose2d(1, 2, Math.PI / 2));
        add(1, "/odom", "base_link", new Pose2d(3, 0, 0));
        addFixed("base_link", "laser", new Pose2d(0.2, 0, 0));
        addFixed("base_link", "camera", new Pose2d(0, 0.1, 0));
        assertThat(pose("map", "/laser", 1).distanceTo(new Pose2d(1, 5.2, 0))).isLessThan(1e-9);
        assertThat(pose("laser", "camera", 7).distanceTo(new Pose2d(-0.2, 0.1, 0)))
                .isLessThan(1e-9); // they never move
        assertThat(pose("map", "map", 9)).isEqualTo(Pose2d.ORIGIN);
    }

    @Test
    void posesBetweenTwoStampsLieOnTheShortestWay() {
        add(10, "odom", "base_link", new Pose2d(1, 0, 3));
        add(11, "odom", "base_link", new Pose2d(3, 4, -3));
        Pose2d quarter = pose("odom", "base_link", 10.25);
        assertThat(quarter.distanceTo(new Pose2d(1.5, 1, 0))).isLessThan(1e-9);
        assertThat(quarter.theta()).isCloseTo(3 + (2 * Math.PI - 6) / 4, within(1e-9));
        assertThat(pose("odom", "base_link", 10)).isEqualTo(new Pose2d(1, 0, 3));
    }

    @Test
    void theNewestIsOfTheNewestTimeThatAllHave() {
        add(10, "map", "odom", new Pose2d(1, 0, 0));
        add(11, "map", "odom", new Pose2d(2, 0, 0));
        add(10, "odom", "base_link", new Pose2d(10, 0, 0));
        add(10.5, "odom", "base_link", new Pose2d(20, 0, 0));
        assertThat(pose("map", "base_link", 0).x()).isCloseTo(21.5, within(1e-9));
    }

    @Test
    void failuresSayWhatIsMissing() {
        add(10, "odom", "base_link", Pose2d.ORIGIN);
        add(12, "odom", "base_link", Pose2d.ORIGIN);
        addFixed("base_link", "laser", Pose2d.ORIGIN);
        addFixed("elsewhere", "thing", Pose2d.ORIGIN);
        assertThat(failure("odom", "laser", 9.5).message())
                .isEqualTo("The frame 'base_link' has transforms (TF) from 10.000 s on, but 9.500 s is needed.");
        assertThat(failure("odom", "laser", 12.25).message())
                .isEqualTo("The frame 'base_link' has transforms (TF) until 12.000 s, but 12.250 s is needed.");
        assertThat(failure("odom", "thing", 11).message())
                .isEqualTo("No transforms (TF) connect the frames 'odom' and 'thing'.");
        assertThat(failure("odom", "gripper", 11).message()).isEqualTo("No transform (TF) names the frame 'gripper'.");
        assertThat(failure("odom", "thing", 0).reason()).isEqualTo(Reason.NOT_CONNECTED);
        assertThat(failure("odom", "gripper", 0).reason()).isEqualTo(Reason.UNKNOWN_FRAME);
        assertThat(pose("laser", "base_link", 99)).isEqualTo(Pose2d.ORIGIN); // what is above does not matter
    }

    @Test
    void aLoopEndsAndIsNamed() {
        add(1, "a", "b", Pose2d.ORIGIN);
        add(1, "b", "c", Pose2d.ORIGIN);
        add(1, "c", "a", Pose2d.ORIGIN);
        addFixed("map", "odom", Pose2d.ORIGIN);
        for (double seconds : new double[] {0, 1}) {
            assertThat(failure("map", "b", seconds).message())
                    .isEqualTo("The transforms (TF) above the frame 'b' form a loop, or are too many.");
        }
    }

    @Test
    void transformsThatCantBeAreRefused() {
        assertThat(add(1, "a", "a", Pose2d.ORIGIN)).isFalse();
        assertThat(add(1, "a", "", Pose2d.ORIGIN)).isFalse();
        assertThat(add(1, "/", "b", Pose2d.ORIGIN)).isFalse();
        assertThat(add(1, "a", "b".repeat(257), Pose2d.ORIGIN)).isFalse();
        assertThat(add(-1, "a", "b", Pose2d.ORIGIN)).isFalse();
        assertThat(add(1, "a", "b", new Pose2d(Double.NaN, 0, 0))).isFalse();
        assertThat(failure("a", "b", 1).reason()).isEqualTo(Reason.UNKNOWN_FRAME);
    }

    @Test
    void whatIsOlderThanTheHistoryIsForgotten() {
        for (int i = 0; i <= 300; i++) {
            add(i / 10.0 + 1, "odom", "base_link", new Pose2d(i, 0, 0));
        }
        assertThat(pose("odom", "base_link", 21).x()).isCloseTo(200, within(1e-6));
        assertThat(failure("odom", "base_link", 20.9).reason()).isEqualTo(Reason.PAST);
    }

    @Test
    void aTimeThatGoesBackBeginsAgain() {
        add(500, "map", "odom", new Pose2d(5, 0, 0));
        add(500, "odom", "base_link", new Pose2d(5, 0, 0));
        addFixed("base_link", "laser", new Pose2d(0.2, 0, 0));
        add(1, "odom", "base_link", new Pose2d(1, 0, 0)); // by itself, as the history is over
        assertThat(pose("odom", "laser", 0).x()).isCloseTo(1.2, within(1e-9));
        add(1.5, "odom", "base_link", new Pose2d(2, 0, 0));
        assertThat(buffer.clear("odom")).containsExactlyInAnyOrder("odom", "base_link");
        assertThat(buffer.find("odom", "base_link", 0).isConnected()).isFalse();
        assertThat(pose("base_link", "laser", 1).x()).isEqualTo(0.2); // which does not move
        add(0.5, "odom", "base_link", new Pose2d(7, 0, 0));
        assertThat(pose("odom", "laser", 0.5).x()).isCloseTo(7.2, within(1e-9));
    }

    /// Robots may share a topic, and have times of their own.
    @Test
    void framesOfAnotherRobotStay() {
        for (String robot : List.of("r1", "r2")) {
            add(5, "map", robot + "/odom", new Pose2d(1, 0, 0));
            add(5, robot + "/odom", robot + "/base_link", new Pose2d(1, 0, 0));
            addFixed(robot + "/base_link", robot + "/mast", new Pose2d(0.2, 0, 0));
            add(5, robot + "/mast", robot + "/camera", new Pose2d(0.1, 0, 0));
        }
        assertThat(buffer.clear("/r1/odom")).containsExactlyInAnyOrder("r1/odom", "r1/base_link", "r1/camera");
        assertThat(buffer.find("map", "r1/base_link", 0).isConnected()).isFalse();
        assertThat(pose("map", "r2/camera", 5).x()).isCloseTo(2.3, within(1e-9));
        assertThat(pose("r1/base_link", "r1/mast", 1).x()).isEqualTo(0.2);
        assertThat(buffer.clear("r1/odom")).isEmpty();
        assertThat(buffer.clear("map")).hasSize(3);
    }

    @Test
    void onlyWhatMovesBetweenTwoFramesIsNamed() {
        add(1, "map", "odom", Pose2d.ORIGIN);
        add(1, "odom", "base_link", Pose2d.ORIGIN);
        add(1, "base_link", "turret", Pose2d.ORIGIN);
        addFixed("turret", "laser", Pose2d.ORIGIN);
        assertThat(buffer.moving("base_link", "laser")).containsExactly("turret");
        assertThat(buffer.moving("map", "base_link")).containsExactlyInAnyOrder("odom", "base_link");
        assertThat(buffer.moving("map", "nowhere")).isEmpty();
    }

    /// A million frames and a million samples of one frame within its history: old ones make room, and what is asked
    /// next is answered at once.
    @Test
    void floodsAreBounded() {
        for (int i = 0; i < 1_000_000; i++) {
            add(1, "map", "frame" + i, Pose2d.ORIGIN);
            add(1 + i * 1e-6, "odom", "base_link", new Pose2d(i, 0, 0));
        }
        assertThat(failure("map", "frame999999", 1).reason()).isEqualTo(Reason.UNKNOWN_FRAME);
        assertThat(pose("odom", "base_link", 0).x()).isEqualTo(999_999);
        assertThat(failure("odom", "base_link", 1.5).reason()).isEqualTo(Reason.PAST); // within 10 s, but too many
        for (int i = 0; i < 5_000; i++) {
            add(1, "frame" + i, "frame" + (i + 1), Pose2d.ORIGIN);
        }
        assertThat(failure("map", "frame4000", 1).reason()).isEqualTo(Reason.LOOP); // or too many levels
    }

    private static FrameTransform random(SplittableRandom random) {
        var rotation = new Quaternion(
                random.nextDouble(-1, 1), random.nextDouble(-1, 1), random.nextDouble(-1, 1), random.nextDouble(1, 2));
        return new FrameTransform(
                random.nextDouble(-5, 5), random.nextDouble(-5, 5), random.nextDouble(-5, 5), rotation.unit());
    }

    private static boolean isFixed(int child) {
        return child % 3 == 0;
    }

    /// Trees of up to nine frames, some of which change their parents, with a history of 2 s.
    @Test
    void answersAreThoseOfTheObviousWay() {
        long questions = 0;
        long found = 0;
        for (long seed = 1; seed <= ROUNDS; seed++) {
            var random = new SplittableRandom(seed);
            var fast = new TransformBuffer(Duration.ofSeconds(2));
            var slow = new ObviousTransforms(2 * SECOND);
            int frames = random.nextInt(2, 10);
            for (int i = 0; i < 60; i++) {
                int child = random.nextInt(1, frames);
                int parent = random.nextInt(5) == 0 ? random.nextInt(child) : child - 1;
                long stamp = SECOND + random.nextInt(40) * 100_000_000L;
                var added = new StampedTransform(stamp, "f" + parent, "f" + child, random(random));
                if (isFixed(child)) {
                    fast.addFixed(added);
                    slow.addFixed(added);
                } else {
                    assertThat(fast.add(added)).isTrue();
                    slow.add(added);
                }
            }
            for (int i = 0; i < 100; i++) {
                String target = "f" + random.nextInt(frames);
                String source = "f" + random.nextInt(frames);
                long stamp = random.nextInt(5) == 0 ? 0 : SECOND + random.nextInt(820) * 5_000_000L;
                TransformLookup answer = fast.find(target, source, stamp);
                Optional<double[]> expected = slow.find(target, source, stamp);
                questions++;
                if (expected.isPresent()) {
                    found++;
                    assertThat(answer).as("seed %d", seed).isInstanceOf(Found.class);
                    assertThat(ObviousTransforms.matrix(answer.transform().orElseThrow()))
                            .as("seed %d: %s from %s at %d", seed, target, source, stamp)
                            .containsExactly(expected.get(), within(1e-6));
                } else {
                    assertThat(answer).as("seed %d", seed).isInstanceOf(Failure.class);
                }
            }
        }
        assertThat(found).isBetween(questions / 5, questions * 4 / 5); // both happen often
    }

    @Test
    void transformsOfAMessageAreReadButForThoseWithoutNumbers() throws InvalidCdr {
        FrameTransform pose = FrameTransform.of(new Pose2d(1, 2, 0.5));
        Instant time = Instant.ofEpochSecond(7, 5);
        byte[] bytes = new RosMessages()
                .transforms(List.of(
                        new Transform(time, "/odom", "base_link", pose),
                        new Transform(time, "odom", "broken", new FrameTransform(Double.NaN, 0, 0, pose.rotation()))));
        TypeLibrary types = TypeLibrary.of(Distribution.JAZZY);
        MessageCodec codec = MessageCodec.of(types.get("tf2_msgs/msg/TFMessage"), types);
        assertThat(StampedTransform.of(codec.read(CdrReader.of(ByteBuffer.wrap(bytes)))))
                .singleElement()
                .satisfies(read -> {
                    assertThat(read.stamp()).isEqualTo(7_000_000_005L);
                    assertThat(read.parent()).isEqualTo("odom");
                    assertThat(read.parentFromChild().planar().distanceTo(new Pose2d(1, 2, 0)))
                            .isLessThan(1e-12);
                });
    }
}
