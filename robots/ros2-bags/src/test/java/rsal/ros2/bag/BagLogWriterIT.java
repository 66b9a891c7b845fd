package rsal.ros2.bag;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import rsal.navigation.log.LaserHints;
import rsal.navigation.log.LogFormats;
import rsal.navigation.log.RobotLog;
import rsal.testkit.LongTest;
import rsal.testkit.OfficialBagReader;

/// What is written of logs is read by rosbags and by MCAP's package.
class BagLogWriterIT {
    @TempDir
    private Path folder;

    @LongTest
    @Test
    void aLogOfCarmenIsABagForOthers() throws Exception {
        Path log = Files.writeString(folder.resolve("lab.log"), CarmenText.of(40, false));
        RobotLog read = LogFormats.read(log, LaserHints.DEFAULT);
        Path bag = folder.resolve("lab");
        new BagLogWriter().write(read, bag, false);
        assertThat(OfficialBagReader.topics(bag))
                .containsExactly(
                        "/odom nav_msgs/msg/Odometry 40 VOLATILE",
                        "/scan sensor_msgs/msg/LaserScan 40 VOLATILE",
                        "/tf tf2_msgs/msg/TFMessage 40 VOLATILE",
                        "/tf_static tf2_msgs/msg/TFMessage 1 TRANSIENT_LOCAL");
        assertThat(OfficialBagReader.first(bag, "/scan")).contains("frame_id='laser'", "range_max=30.0");
    }

    @Test
    void correctedPosesAreATransformFromTheMap() throws Exception {
        Path log = Files.writeString(folder.resolve("lab.log"), CarmenText.of(10, true));
        Path bag = folder.resolve("lab");
        new BagLogWriter().write(LogFormats.read(log, LaserHints.DEFAULT), bag, false);
        assertThat(OfficialBagReader.topics(bag)).contains("/tf tf2_msgs/msg/TFMessage 20 VOLATILE");
    }
}
