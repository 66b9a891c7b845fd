package rsal.ros2.bag;

import java.util.Optional;
import rsal.navigation.log.LogWriter;

/// Bags that rosbag2 has written in MCAP.
public final class McapBagFormat extends BagFormat {
    public McapBagFormat() {
        super(BagFiles.MCAP, "MCAP");
    }

    @Override
    public Optional<LogWriter> writer() {
        return Optional.of(new BagLogWriter());
    }
}
