package rsal.ros2.bag;

import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Path;
import rsal.navigation.log.LaserHints;
import rsal.navigation.log.LogCollector;
import rsal.navigation.log.LogFormat;

/// Bags that rosbag2 has written in sqlite3, a file or the folder of a bag with all of its files.
public final class SqliteBagFormat implements LogFormat {
    @Override
    public String suffix() {
        return BagFiles.SQLITE;
    }

    @Override
    public String description() {
        return "Bags of ROS 2 in sqlite3: sensor_msgs/LaserScan, nav_msgs/Odometry or TF, and static TF.";
    }

    /// Copies the stream to a file first, as databases are read page by page.
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
