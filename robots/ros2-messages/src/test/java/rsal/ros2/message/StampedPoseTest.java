package rsal.ros2.message;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.EnumSource;
import rsal.data.Pose2d;
import rsal.ros2.cdr.MessageCodec;
import rsal.ros2.cdr.RosMessage;
import rsal.ros2.type.Distribution;
import rsal.ros2.type.TypeLibrary;

/// Poses on the map come back as they were; others are none.
class StampedPoseTest {
    private static RosMessage zero(Distribution distribution) {
        TypeLibrary types = TypeLibrary.of(distribution);
        return MessageCodec.of(types.get("geometry_msgs/msg/PoseStamped"), types)
                .zero();
    }

    @ParameterizedTest
    @EnumSource
    void whatIsWrittenIsRead(Distribution distribution) {
        var pose = new Pose2d(1.5, -2, 3);
        RosMessage written = StampedPose.of(zero(distribution), StampedPose.MAP, pose);
        assertThat(StampedPose.onMap(written)).hasValueSatisfying(read -> {
            assertThat(read.distanceTo(pose)).isLessThan(1e-12);
            assertThat(read.theta()).isCloseTo(3, within(1e-12));
        });
    }

    @ParameterizedTest
    @CsvSource({"'', 1, true", "/map, 1, true", "odom, 1, false", "map, NaN, false", "map, Infinity, false"})
    void posesAreOnTheMapIfTheirFrameIsTheMapAndTheyAreFinite(String frame, double x, boolean isOnMap) {
        RosMessage written = StampedPose.of(zero(Distribution.JAZZY), frame, new Pose2d(x, 0, 0));
        assertThat(StampedPose.onMap(written).isPresent()).isEqualTo(isOnMap);
    }
}
