package rsal.map;

import rsal.data.OccupancyGrid;

/// What a pixel's shade means. See [Maps].
///
/// @param negate whether white is occupied
/// @param occupied darker than this is occupied (0–1)
/// @param free lighter than this is free (0–1)
record Shading(boolean negate, double occupied, double free, Opacity opacity) {
    /// What it means when a pixel can be seen through.
    enum Opacity {
        /// Nothing.
        IGNORED,
        /// What can be seen through says nothing about the place.
        NEEDED,
        /// It counts like a fourth color.
        COLOR
    }

    /// A pixel of an image whose pixels can't be seen through.
    ///
    /// @param brightness 0 (black) to 1 (white)
    byte cell(double brightness) {
        double darkness = negate ? brightness : 1 - brightness;
        if (darkness > occupied) {
            return OccupancyGrid.OCCUPIED;
        }
        return darkness < free ? OccupancyGrid.FREE : OccupancyGrid.UNKNOWN;
    }

    /// A pixel of an image whose pixels may be seen through.
    ///
    /// @param opaque 0 (not to be seen) to 1
    byte cell(double brightness, double opaque) {
        return switch (opacity) {
            case IGNORED -> cell(brightness);
            case NEEDED -> opaque < 1 ? OccupancyGrid.UNKNOWN : cell(brightness);
            case COLOR -> cell((3 * brightness + opaque) / 4);
        };
    }
}
