package rsal.world;

import java.util.Optional;
import rsal.data.Interval;
import rsal.data.Pose2d;
import rsal.image.Bitmap;
import rsal.scene.SolidRaster;
import rsal.scene.Surface;

/// Places images that stand at right angles, without loss.
public final class Upright {
    private static final double EXACT = 1e-9; // [rad]

    private Upright() {}

    /// The cells as they are in the world; empty when they are not at right angles to it.
    ///
    /// @param mapFromCorner where the lower left corner is, columns along its x
    /// @param cellLength along a row, above 0 [m]
    /// @param cellWidth along a column, above 0 [m]
    /// @param heights of underside and top above the floor [m]
    /// @param fenced whether no robot leaves it
    public static Optional<SolidRaster> of(
            Bitmap bitmap,
            Pose2d mapFromCorner,
            double cellLength,
            double cellWidth,
            Interval heights,
            Surface surface,
            boolean fenced) {
        long quarters = Math.round(mapFromCorner.theta() / (Math.PI / 2));
        if (Math.abs(mapFromCorner.theta() - quarters * (Math.PI / 2)) > EXACT) {
            return Optional.empty();
        }
        int turns = (int) Math.floorMod(quarters, 4L);
        boolean across = turns % 2 == 1;
        double length = bitmap.width() * cellLength;
        double width = bitmap.height() * cellWidth;
        Bitmap turned = bitmap.turned(turns);
        return Optional.of(new SolidRaster(
                turned.width(),
                turned.height(),
                turned.solid(),
                mapFromCorner.x() - (turns == 1 ? width : turns == 2 ? length : 0),
                mapFromCorner.y() - (turns == 2 ? width : turns == 3 ? length : 0),
                across ? cellWidth : cellLength,
                across ? cellLength : cellWidth,
                heights.least(),
                heights.most(),
                fenced,
                surface));
    }
}
