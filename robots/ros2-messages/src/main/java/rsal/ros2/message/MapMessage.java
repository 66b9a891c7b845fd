package rsal.ros2.message;

import java.util.Optional;
import rsal.data.OccupancyGrid;
import rsal.data.Pose2d;
import rsal.ros2.cdr.RosMessage;

/// What is said in a `nav_msgs/OccupancyGrid`, and in the `map_msgs/OccupancyGridUpdate` that change it.
public final class MapMessage {
    private static final double STRAIGHT = 1e-3; // rad

    private MapMessage() {}

    /// The map, with cells that are free, occupied or unknown. Empty for one that is none, or that is turned, which no
    /// map of ours is.
    ///
    /// @param message whose cells the map takes over
    public static Optional<OccupancyGrid> of(RosMessage message) {
        return of(message, CellMeaning.OCCUPANCY);
    }

    /// As [#of(RosMessage)], with cells of any meaning.
    public static Optional<OccupancyGrid> of(RosMessage message, CellMeaning meaning) {
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
        meaning.read(cells);
        return Optional.of(new OccupancyGrid((int) width, (int) height, resolution, origin.x(), origin.y(), cells));
    }

    /// A map after a change of a rectangle of its cells. Empty when the rectangle is not inside of the map, or has not
    /// as many cells as it says.
    ///
    /// @param map which is left as it is
    /// @param update whose cells are used up
    public static Optional<OccupancyGrid> updated(OccupancyGrid map, RosMessage update, CellMeaning meaning) {
        long x = update.integer("x");
        long y = update.integer("y");
        long width = update.integer("width");
        long height = update.integer("height");
        byte[] changed = update.get("data", byte[].class);
        boolean isInside = x >= 0 && y >= 0 && x + width <= map.width() && y + height <= map.height();
        if (!isInside || width * height != changed.length) {
            return Optional.empty();
        }
        meaning.read(changed);
        byte[] cells = map.cells().clone();
        for (int row = 0; row < height; row++) {
            System.arraycopy(changed, (int) (row * width), cells, (int) ((y + row) * map.width() + x), (int) width);
        }
        return Optional.of(
                new OccupancyGrid(map.width(), map.height(), map.resolution(), map.originX(), map.originY(), cells));
    }
}
