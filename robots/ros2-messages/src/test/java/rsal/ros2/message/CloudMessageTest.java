package rsal.ros2.message;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.time.Instant;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import rsal.data.ParticleCloud;
import rsal.data.Path2d;
import rsal.data.Point2d;
import rsal.data.Pose2d;
import rsal.ros2.cdr.CdrReader;
import rsal.ros2.cdr.CdrWriter;
import rsal.ros2.cdr.MessageCodec;
import rsal.ros2.cdr.RosMessage;
import rsal.ros2.type.Distribution;
import rsal.ros2.type.TypeLibrary;

/// Particles and paths come back as they were, and damaged ones do not come at all.
class CloudMessageTest {
    private static final TypeLibrary JAZZY = TypeLibrary.of(Distribution.JAZZY);

    private static RosMessage read(String type, CdrWriter written) throws Exception {
        return MessageCodec.of(JAZZY.get(type), JAZZY).read(CdrReader.of(written.toBytes()));
    }

    private static RosMessage cloud(float... weights) throws Exception {
        var poses = new float[3 * weights.length];
        for (int i = 0; i < poses.length; i++) {
            poses[i] = i % 3 == 2 ? 0.5f : i;
        }
        return read(
                "nav2_msgs/msg/ParticleCloud",
                CloudMessage.write(new CdrWriter(), Instant.EPOCH, "map", new ParticleCloud(poses, weights)));
    }

    @Test
    void weightsSumToOne() throws Exception {
        ParticleCloud cloud = CloudMessage.of(cloud(1, 3)).orElseThrow();
        assertThat(cloud.weights()).containsExactly(0.25f, 0.75f);
        assertThat(cloud.poses()).containsExactly(new float[] {0, 1, 0.5f, 3, 4, 0.5f}, within(1e-6f));
        assertThat(CloudMessage.of(cloud(0, 0)).orElseThrow().weights()).containsExactly(0.5f, 0.5f);
    }

    @ParameterizedTest
    @ValueSource(floats = {-1, Float.NaN, Float.POSITIVE_INFINITY})
    void weightsThatAreNoneAreNoCloud(float weight) throws Exception {
        assertThat(CloudMessage.of(cloud(1, weight))).isEmpty();
    }

    @Test
    void noParticlesAreNoCloud() throws Exception {
        assertThat(CloudMessage.of(cloud())).isEmpty();
    }

    private static RosMessage path(List<Pose2d> poses) throws Exception {
        return read("nav_msgs/msg/Path", PathMessage.write(new CdrWriter(), Instant.EPOCH, "map", poses));
    }

    @Test
    void aPathHasItsPointsAndPosesBetweenThem() throws Exception {
        var corner = new Point2d(1, 0);
        var path = new Path2d(List.of(new Point2d(0, 0), corner, new Point2d(1, 0.25)));
        List<Pose2d> poses = PathMessage.poses(path);
        assertThat(poses).hasSize(10 + 3 + 1);
        assertThat(poses.get(5).theta()).isZero();
        assertThat(poses.getLast().theta()).isCloseTo(Math.PI / 2, within(1e-9));
        Path2d back = PathMessage.of(path(poses)).orElseThrow();
        assertThat(back.points()).contains(corner).endsWith(new Point2d(1, 0.25));
        assertThat(back.length()).isCloseTo(path.length(), within(1e-9));
        assertThat(PathMessage.poses(Path2d.EMPTY)).isEmpty();
        assertThat(PathMessage.poses(new Path2d(List.of(corner)))).containsExactly(new Pose2d(1, 0, 0));
        assertThat(PathMessage.of(path(List.of(new Pose2d(0, Double.NaN, 0))))).isEmpty();
    }

    @Test
    void aLongPathHasNoMorePosesThanAreUseful() {
        var far = new Path2d(List.of(new Point2d(0, 0), new Point2d(1e6, 0)));
        assertThat(PathMessage.poses(far)).hasSizeBetween(10_000, 10_002);
    }
}
