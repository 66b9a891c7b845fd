package rsal.navigation.amcl;

import rsal.data.OccupancyGrid;

/// What beams that end outside a map say of a pose. Where that is shut off by what is not free all around, they are as
/// unlikely as they seem. Of a map that was cut off, nobody knows: they count as what the others of a scan say on
/// average, or poses would be pulled away from the edge; but no more of them than the others are.
///
/// @param isUnknown whether the map was cut off
record OutOfMapModel(boolean isUnknown) {
    static OutOfMapModel of(OccupancyGrid map) {
        return new OutOfMapModel(isFreeAtEdge(map));
    }

    /// Logarithm of the likelihood of all beams.
    ///
    /// @param onMap sum of those that end on the map
    /// @param inside how many these are
    /// @param beyond sum of the others
    /// @param outside how many those are
    double joined(double onMap, int inside, double beyond, int outside) {
        int unknown = isUnknown ? Math.min(inside, outside) : 0;
        return unknown == 0
                ? onMap + beyond
                : onMap + unknown * onMap / inside + (outside - unknown) * beyond / outside;
    }

    private static boolean isFreeAtEdge(OccupancyGrid map) {
        for (int column = 0; column < map.width(); column++) {
            if (isFree(map, column, 0) || isFree(map, column, map.height() - 1)) {
                return true;
            }
        }
        for (int row = 0; row < map.height(); row++) {
            if (isFree(map, 0, row) || isFree(map, map.width() - 1, row)) {
                return true;
            }
        }
        return false;
    }

    private static boolean isFree(OccupancyGrid map, int column, int row) {
        return map.at(column, row) == OccupancyGrid.FREE;
    }
}
