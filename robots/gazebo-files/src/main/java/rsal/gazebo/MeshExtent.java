package rsal.gazebo;

import java.util.Optional;
import rsal.model.xml.Transform.Point;

/// Grows to the box around corners.
final class MeshExtent {
    private final double[] low = {Double.MAX_VALUE, Double.MAX_VALUE, Double.MAX_VALUE};
    private final double[] high = {-Double.MAX_VALUE, -Double.MAX_VALUE, -Double.MAX_VALUE};

    /// @param corner x, y, z [m]; those that are not finite are left out
    void add(double... corner) {
        for (int i = 0; i < 3; i++) {
            if (Double.isFinite(corner[i])) {
                low[i] = Math.min(low[i], corner[i]);
                high[i] = Math.max(high[i], corner[i]);
            }
        }
    }

    /// Empty without a corner.
    Optional<MeshBounds> bounds() {
        for (int i = 0; i < 3; i++) {
            if (!(low[i] <= high[i])) {
                return Optional.empty();
            }
        }
        return Optional.of(new MeshBounds(new Point(low[0], low[1], low[2]), new Point(high[0], high[1], high[2])));
    }
}
