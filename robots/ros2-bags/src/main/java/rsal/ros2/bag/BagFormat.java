package rsal.ros2.bag;

import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.util.List;
import java.util.stream.Stream;
import rsal.mcap.InvalidMcap;
import rsal.mcap.McapFile;
import rsal.navigation.log.BrokenLog;
import rsal.navigation.log.LaserHints;
import rsal.navigation.log.LogCollector;
import rsal.navigation.log.LogFormat;

/// Bags that rosbag2 has written in MCAP, a file or the folder of a bag with all of its files.
public final class BagFormat implements LogFormat {
    private static final String SUFFIX = ".mcap";

    @Override
    public String suffix() {
        return SUFFIX;
    }

    @Override
    public String description() {
        return "Bags of ROS 2 in MCAP: sensor_msgs/LaserScan, nav_msgs/Odometry or TF, and static TF.";
    }

    /// Copies the stream to a file first, as MCAP is read by its index.
    @Override
    public void read(String file, InputStream in, LaserHints hints, LogCollector log) throws IOException {
        Path copy = Files.createTempFile("rsal-bag-", SUFFIX);
        try {
            Files.copy(in, copy, StandardCopyOption.REPLACE_EXISTING);
            read(file, List.of(copy), hints, log);
        } finally {
            Files.delete(copy);
        }
    }

    @Override
    public void read(Path file, LaserHints hints, LogCollector log) throws IOException {
        read(file.toString(), Files.isDirectory(file) ? parts(file) : List.of(file), hints, log);
    }

    /// The files of a bag that was split, in the order of their numbers: `run_0.mcap`, …, `run_10.mcap`.
    private static List<Path> parts(Path folder) throws IOException {
        try (Stream<Path> files = Files.list(folder)) {
            return files.filter(file -> file.toString().endsWith(SUFFIX))
                    .sorted((one, other) -> {
                        int byLength =
                                one.toString().length() - other.toString().length();
                        return byLength != 0 ? byLength : one.compareTo(other);
                    })
                    .toList();
        }
    }

    private static void read(String name, List<Path> files, LaserHints hints, LogCollector log) throws IOException {
        var reader = new BagReader(name, hints, log);
        for (Path file : files) {
            try (McapFile bag = McapFile.open(file)) {
                reader.readFrames(bag);
            } catch (InvalidMcap e) {
                throw new BrokenLog(name, 0, String.valueOf(e.getMessage()), e);
            }
        }
        for (Path file : files) {
            try (McapFile bag = McapFile.open(file)) {
                reader.readScans(bag);
            }
        }
        reader.end();
    }
}
