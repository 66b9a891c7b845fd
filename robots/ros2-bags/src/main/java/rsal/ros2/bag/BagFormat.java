package rsal.ros2.bag;

import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Path;
import java.util.Optional;
import rsal.navigation.log.LaserHints;
import rsal.navigation.log.LogCollector;
import rsal.navigation.log.LogFormat;
import rsal.navigation.log.LogWriter;

/// Bags that rosbag2 has written in MCAP, a file or the folder of a bag with all of its files.
public final class BagFormat implements LogFormat {
    @Override
    public String suffix() {
        return BagFiles.MCAP;
    }

    @Override
    public String description() {
        return "Bags of ROS 2 in MCAP: sensor_msgs/LaserScan, nav_msgs/Odometry or TF, and static TF.";
    }

    @Override
    public Optional<LogWriter> writer() {
        return Optional.of(new BagLogWriter());
    }

    /// Copies the stream to a file first, as MCAP is read by its index.
    @Override
    public void read(String file, InputStream in, LaserHints hints, LogCollector log) throws IOException {
        try (BagFiles files = BagFiles.copy(file, in)) {
            files.read(hints, log);
        }
    }

    @Override
    public void read(Path file, LaserHints hints, LogCollector log) throws IOException {
        try (BagFiles files = BagFiles.at(file)) {
            files.read(hints, log);
        }
    }
}
