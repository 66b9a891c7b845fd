package rsal.device;

import java.util.List;
import rsal.data.OccupancyGrid;
import rsal.data.Point2d;
import rsal.data.Pose2d;

/// Draws a map while its robot drives. Each reading is the whole map so far. Robots that work together may
/// share one map. Their frame is `map`, or `<robot>/map` if the start pose of the robot is unknown.
public interface Mapper extends Sensor<OccupancyGrid> {
    /// Whether all places that its robot can reach are on the map, as far as is known now: a door may open
    /// later.
    boolean isComplete();

    /// The frontiers of the map that its robot can reach, as known now. Who pauses it may go there instead.
    List<End> ends();

    /// Ignores a frontier for a while, because a robot was there or could not get there.
    void leaveAlone(End end);

    /// Stops driving, and continues to map what it sees.
    void pause();

    /// Resumes driving its robot to frontiers.
    void resume();

    boolean paused();

    /// A stretch where what is free meets what nobody has seen.
    ///
    /// @param mapFromMiddle of it, in the frame of the map
    /// @param mapFromStand where the robot can be to see beyond it, looking there
    /// @param length of it [m]
    /// @param cost of the way to the stand from where the robot was [m], more where it is narrow
    record End(Point2d mapFromMiddle, Pose2d mapFromStand, double length, double cost) {}
}
