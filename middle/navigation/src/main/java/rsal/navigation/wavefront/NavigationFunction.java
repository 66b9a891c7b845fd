package rsal.navigation.wavefront;

import rsal.data.OccupancyGrid;
import rsal.data.Point2d;

/// What the way to a goal, or the nearest of several, costs from everywhere on a map. Immutable; made by
/// [Wavefront#everywhere].
public final class NavigationFunction {
    private final OccupancyGrid grid;
    private final Wave wave;

    /// @param wave that has spread everywhere and stays as it is
    NavigationFunction(OccupancyGrid grid, Wave wave) {
        this.grid = grid;
        this.wave = wave;
    }

    /// Length of the way from a place [m], more where it leads near obstacles; +∞ where there is none.
    public double cost(Point2d from) {
        int column = grid.column(from.x());
        int row = grid.row(from.y());
        int cost = grid.contains(column, row) ? wave.at(row * grid.width() + column) : Wave.UNREACHED;
        return cost < 0 || cost == Wave.UNREACHED ? Double.POSITIVE_INFINITY : cost * grid.resolution() / CostMap.SIDE;
    }
}
