package rsal.device;

import java.util.List;
import rsal.data.OccupancyGrid;
import rsal.data.Point2d;
import rsal.data.Pose2d;

/// Draws a map while its robot goes about. Its readings are the whole map as known so far; robots that work together
/// may tell the same one. Their frame is `map`, or `<robot>/map` when nobody told where the robot started.
public interface Mapper extends Sensor<OccupancyGrid> {
    /// Whether all that its robot can get to is on the map, as far as is known now: a door may open later.
    boolean isComplete();

    /// Where the map ends and its robot can get to, as known now. Who pauses it may go there instead.
    List<End> ends();

    /// Counts a place no more as an end for a while, as a robot was there or could not get there.
    void leaveAlone(End end);

    /// Leaves the driving to others, and maps whatever it sees meanwhile.
    void pause();

    /// Goes on driving its robot to where the map ends.
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
