package rsal.ros2.bag;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.file.Path;
import java.time.Instant;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import rsal.data.LaserScan;
import rsal.data.Odometry;
import rsal.data.Pose2d;
import rsal.data.Twist2d;
import rsal.navigation.log.BrokenLog;
import rsal.navigation.log.LaserHints;
import rsal.navigation.log.LogFormats;
import rsal.navigation.log.RobotLog;
import rsal.ros2.message.FrameTransform;
import rsal.ros2.message.RosMessages;
import rsal.ros2.message.RosMessages.Transform;
import rsal.ros2.record.BagWriter;
import rsal.ros2.record.OfferedQuality;

/// Of a bag with several robots, all that is read is of one of them.
class BagReaderTest {
    @TempDir
    private Path folder;

    private final RosMessages messages = new RosMessages();

    /// @param odometries how many messages of odometry for each scan
    /// @param mount where its laser is [m]
    private void write(BagWriter bag, String robot, int scans, int odometries, double mount) throws IOException {
        int fixed = bag.topic(robot + "/tf_static", "tf2_msgs/msg/TFMessage", OfferedQuality.LATCHED);
        int odometry = bag.topic(robot + "/odom", "nav_msgs/msg/Odometry", OfferedQuality.RELIABLE);
        int scan = bag.topic(robot + "/front/scan", "sensor_msgs/msg/LaserScan", OfferedQuality.BEST_EFFORT);
        var laser = new Transform(Instant.EPOCH, "base_link", "laser", FrameTransform.of(new Pose2d(mount, 0, 0)));
        bag.message(fixed, 0, messages.transforms(List.of(laser)));
        for (int i = 0; i < scans; i++) {
            Instant time = Instant.ofEpochMilli(100L * (i + 1));
            for (int k = 0; k < odometries; k++) {
                var value = new Odometry(new Pose2d(mount, i, 0), Twist2d.STOP, false);
                bag.message(odometry, time.toEpochMilli(), messages.odometry(time, value, "odom", "base_link"));
            }
            var seen = new LaserScan(Pose2d.ORIGIN, -1, 0.5, 0.1, 30, new float[] {1, 2, 3, 4, 5});
            bag.message(scan, time.toEpochMilli(), messages.scan(time, seen, "laser", 0));
        }
    }

    @Test
    void odometryAndMountAreThoseOfTheRobotWithTheMostScans() throws Exception {
        Path file = folder.resolve("two.mcap");
        try (BagWriter bag = BagWriter.file(file, false, "a test", () -> 0)) {
            write(bag, "/one", 20, 1, 0.25);
            write(bag, "/two", 10, 9, 0.75);
        }
        RobotLog log = LogFormats.read(file, LaserHints.DEFAULT);
        assertThat(log.scans())
                .hasSize(20)
                .allSatisfy(scan -> assertThat(scan.scan().baseFromLaser().x()).isEqualTo(0.25));
        assertThat(log.motions())
                .hasSize(20)
                .allSatisfy(motion -> assertThat(motion.odomFromBase().x()).isEqualTo(0.25));
        assertThat(log.parameters()).extracting(each -> each.value()).containsExactly("/one/front/scan", "/one/odom");
    }

    @Test
    void anotherRobotIsReadByItsTopic() throws Exception {
        Path file = folder.resolve("two.mcap");
        try (BagWriter bag = BagWriter.file(file, false, "a test", () -> 0)) {
            write(bag, "/one", 20, 1, 0.25);
            write(bag, "/two", 10, 2, 0.75);
        }
        RobotLog log = LogFormats.read(file, of("two/front/scan"));
        assertThat(log.topic()).contains(new RobotLog.ScanTopic("/two/front/scan", List.of("/one/front/scan")));
        assertThat(log.scans())
                .hasSize(10)
                .allSatisfy(scan -> assertThat(scan.scan().baseFromLaser().x()).isEqualTo(0.75));
        assertThat(log.motions())
                .hasSize(20)
                .allSatisfy(motion -> assertThat(motion.odomFromBase().x()).isEqualTo(0.75));
        assertThatThrownBy(() -> LogFormats.read(file, of("/three/scan")))
                .isInstanceOf(BrokenLog.class)
                .hasMessageContaining(
                        "It has no scans of topic '/three/scan'. Topics of scans are: /one/front/scan, /two/front/scan.");
    }

    private static LaserHints of(String topic) {
        return new LaserHints(Math.PI, 50, false, Optional.of(topic));
    }
}
