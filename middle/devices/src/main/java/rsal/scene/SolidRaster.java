package rsal.scene;

import java.util.BitSet;
import rsal.data.OccupancyGrid;

/// An upright grid of cells, some of which are solid: a floor plan.
///
/// @param width [cells]
/// @param height [cells]
/// @param solid row by row from the lower left cell; handed over, not shared
/// @param left of the lower left corner, in the map frame [m]
/// @param bottom the same [m]
/// @param cellX size of a cell [m]
/// @param cellY the same [m]
/// @param lowest underside above the floor [m]; −∞ where heights don't matter
/// @param highest top above the floor [m]; +∞ where heights don't matter
/// @param fenced whether no robot leaves it
public record SolidRaster(
        int width,
        int height,
        BitSet solid,
        double left,
        double bottom,
        double cellX,
        double cellY,
        double lowest,
        double highest,
        boolean fenced,
        Surface surface) {

    /// The occupied cells of a map, of all heights. Unknown cells are not solid. No robot leaves it. Blob finders
    /// don't tell of it, as a map knows no colors.
    public static SolidRaster of(OccupancyGrid map) {
        var solid = new BitSet(map.cells().length);
        for (int i = 0; i < map.cells().length; i++) {
            solid.set(i, map.cells()[i] == OccupancyGrid.OCCUPIED);
        }
        return new SolidRaster(
                map.width(),
                map.height(),
                solid,
                map.originX(),
                map.originY(),
                map.resolution(),
                map.resolution(),
                Double.NEGATIVE_INFINITY,
                Double.POSITIVE_INFINITY,
                true,
                Surface.PLAIN.withoutBlobs());
    }
}
