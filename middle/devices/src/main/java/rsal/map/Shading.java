package rsal.map;

import rsal.data.OccupancyGrid;

/// What a pixel's shade means. See [Maps].
///
/// @param negate whether white is occupied
/// @param occupied darker than this is occupied (0–1)
/// @param free lighter than this is free (0–1)
/// @param transparentIsUnknown whether what can be seen through says nothing
record Shading(boolean negate, double occupied, double free, boolean transparentIsUnknown) {
    /// @param brightness 0 (black) to 1 (white)
    byte cell(double brightness, boolean opaque) {
        double darkness = negate ? brightness : 1 - brightness;
        if (transparentIsUnknown && !opaque) {
            return OccupancyGrid.UNKNOWN;
        }
        if (darkness > occupied) {
            return OccupancyGrid.OCCUPIED;
        }
        return darkness < free ? OccupancyGrid.FREE : OccupancyGrid.UNKNOWN;
    }
}
