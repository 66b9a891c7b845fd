package rsal.device;

import rsal.data.OccupancyGrid;

/// Draws a map while its robot goes about. Its readings are the whole map as known so far; robots that work together
/// may tell the same one. Their frame is `map`, or `<robot>/map` when nobody told where the robot started.
public interface Mapper extends Sensor<OccupancyGrid> {
    /// Whether all that its robot can get to is on the map, as far as is known now: a door may open later.
    boolean isComplete();

    /// Leaves the driving to others, and maps whatever it sees meanwhile.
    void pause();

    /// Goes on driving its robot to where the map ends.
    void resume();

    boolean paused();
}
