package rsal.ros2.message;

import java.util.Optional;
import rsal.data.OccupancyGrid;
import rsal.data.Pose2d;
import rsal.ros2.cdr.RosMessage;

/// What is said in a `nav_msgs/OccupancyGrid`.
public final class MapMessage {
    private static final int FREE_UP_TO = 19; // percent, as map_server has it
    private static final int OCCUPIED_FROM = 65;
    private static final double STRAIGHT = 1e-3; // rad

    private MapMessage() {}

    /// The map, with cells that are free, occupied or unknown: those between are unknown, as for ROS's `map_server`.
    /// Empty for one that is none, or that is turned, which no map of ours is.
    ///
    /// @param message whose cells the map takes over
    public static Optional<OccupancyGrid> of(RosMessage message) {
        RosMessage info = message.message("info");
        byte[] cells = message.get("data", byte[].class);
        long width = info.integer("width");
        long height = info.integer("height");
        double resolution = Double.parseDouble(Float.toString((float) info.number("resolution"))); // 0.05, not nearly
        Pose2d origin = FrameTransform.of(info.message("origin"), "position", "orientation")
                .planar();
        boolean isMap = width > 0
                && height > 0
                && width <= cells.length
                && width * height == cells.length
                && resolution > 0
                && Double.isFinite(resolution)
                && origin.isFinite()
                && Math.abs(origin.theta()) < STRAIGHT;
        if (!isMap) {
            return Optional.empty();
        }
        for (int i = 0; i < cells.length; i++) {
            cells[i] = cell(cells[i]);
        }
        return Optional.of(new OccupancyGrid((int) width, (int) height, resolution, origin.x(), origin.y(), cells));
    }

    private static byte cell(byte percent) {
        if (percent >= OCCUPIED_FROM) {
            return OccupancyGrid.OCCUPIED;
        }
        return percent >= 0 && percent <= FREE_UP_TO ? OccupancyGrid.FREE : OccupancyGrid.UNKNOWN;
    }
}
