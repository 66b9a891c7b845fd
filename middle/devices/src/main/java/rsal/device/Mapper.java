package rsal.device;

import rsal.data.OccupancyGrid;

/// Draws a map while its robot goes about. Its readings are the whole map as known so far, in the frame `map`; robots
/// that work together may tell the same one.
public interface Mapper extends Sensor<OccupancyGrid> {}
