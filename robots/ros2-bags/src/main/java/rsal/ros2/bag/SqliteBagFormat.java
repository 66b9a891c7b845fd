package rsal.ros2.bag;

/// Bags that rosbag2 has written in sqlite3.
public final class SqliteBagFormat extends BagFormat {
    public SqliteBagFormat() {
        super(BagFiles.SQLITE, "sqlite3");
    }
}
