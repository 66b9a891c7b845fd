package rsal.ros2.bag;

import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Path;
import rsal.navigation.log.LaserHints;
import rsal.navigation.log.LogCollector;
import rsal.navigation.log.LogFormat;

/// Bags that rosbag2 has written, in one of its storages: a file, or the folder of a bag with all of its files.
public abstract sealed class BagFormat implements LogFormat permits McapBagFormat, SqliteBagFormat {
    private final String suffix;
    private final String storage;

    /// @param storage for people
    BagFormat(String suffix, String storage) {
        this.suffix = suffix;
        this.storage = storage;
    }

    @Override
    public final String suffix() {
        return suffix;
    }

    @Override
    public final String description() {
        return "Bags of ROS 2 in %s: sensor_msgs/LaserScan, nav_msgs/Odometry or TF, and static TF.".formatted(storage);
    }

    /// Copies the stream to a file first, as both storages are read at any place.
    @Override
    public final void read(String file, InputStream in, LaserHints hints, LogCollector log) throws IOException {
        try (BagFiles files = BagFiles.copy(file, in)) {
            files.read(hints, log);
        }
    }

    @Override
    public final void read(Path file, LaserHints hints, LogCollector log) throws IOException {
        try (BagFiles files = BagFiles.at(file)) {
            files.read(hints, log);
        }
    }
}
