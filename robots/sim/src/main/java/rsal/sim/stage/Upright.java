package rsal.sim.stage;

import java.util.BitSet;
import java.util.Optional;
import rsal.data.Pose2d;
import rsal.scene.Raster;
import rsal.scene.Surface;

/// Turns bitmaps of models that stand at right angles into upright ones, without loss.
final class Upright {
    private static final double EXACT = 1e-9; // [rad]

    private Upright() {}

    /// The cells as they are in the world; empty when they are neither upright nor at right angles to that.
    static Optional<Raster> of(Body.Raster raster, Placement worldFromModel, Surface surface) {
        Pose2d corner = worldFromModel.pose().compose(raster.modelFromCorner());
        long quarters = Math.round(corner.theta() / (Math.PI / 2));
        if (Math.abs(corner.theta() - quarters * (Math.PI / 2)) > EXACT
                || !(raster.cellLength() > 0 && raster.cellWidth() > 0)) {
            return Optional.empty();
        }
        int turns = (int) Math.floorMod(quarters, 4L);
        Bitmap bitmap = raster.bitmap();
        boolean across = turns % 2 == 1;
        double length = bitmap.width() * raster.cellLength();
        double width = bitmap.height() * raster.cellWidth();
        double left = corner.x() - (turns == 1 ? width : turns == 2 ? length : 0);
        double bottom = corner.y() - (turns == 2 ? width : turns == 3 ? length : 0);
        return Optional.of(new Raster(
                across ? bitmap.height() : bitmap.width(),
                across ? bitmap.width() : bitmap.height(),
                turned(bitmap, turns),
                left,
                bottom,
                across ? raster.cellWidth() : raster.cellLength(),
                across ? raster.cellLength() : raster.cellWidth(),
                worldFromModel.z() + raster.heights().min(),
                worldFromModel.z() + raster.heights().max(),
                false,
                surface));
    }

    /// @param turns quarter turns, counter-clockwise
    private static BitSet turned(Bitmap bitmap, int turns) {
        if (turns == 0) {
            return bitmap.solid();
        }
        int width = bitmap.width();
        int height = bitmap.height();
        var turned = new BitSet(width * height);
        for (int i = bitmap.solid().nextSetBit(0); i >= 0; i = bitmap.solid().nextSetBit(i + 1)) {
            int column = i % width;
            int row = i / width;
            turned.set(
                    switch (turns) {
                        case 1 -> column * height + (height - 1 - row);
                        case 2 -> (height - 1 - row) * width + (width - 1 - column);
                        default -> (width - 1 - column) * height + row;
                    });
        }
        return turned;
    }
}
