package rsal.ros2.message;

import rsal.data.OccupancyGrid;

/// What the cells of a `nav_msgs/OccupancyGrid` stand for.
public enum CellMeaning {
    /// How likely a place is occupied [percent]: free, occupied or unknown, as for ROS's `map_server`, for which those
    /// between are unknown.
    OCCUPANCY {
        @Override
        byte read(byte cell) {
            if (cell >= OCCUPIED_FROM) {
                return OccupancyGrid.OCCUPIED;
            }
            return cell >= 0 && cell <= FREE_UP_TO ? OccupancyGrid.FREE : OccupancyGrid.UNKNOWN;
        }
    },

    /// What a place costs a robot, as costmaps of Nav2 have it. From 99 on, the middle of the robot can't be there.
    COSTS {
        @Override
        byte read(byte cell) {
            if (cell >= INSCRIBED) {
                return OccupancyGrid.OCCUPIED;
            }
            return cell >= 0 ? cell : OccupancyGrid.UNKNOWN;
        }
    };

    private static final int FREE_UP_TO = 19;
    private static final int OCCUPIED_FROM = 65;
    private static final int INSCRIBED = 99;

    /// A cell as maps of ours have it.
    abstract byte read(byte cell);

    /// @param cells which become those of a map of ours
    final void read(byte[] cells) {
        for (int i = 0; i < cells.length; i++) {
            cells[i] = read(cells[i]);
        }
    }
}
