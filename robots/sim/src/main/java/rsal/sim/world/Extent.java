package rsal.sim.world;

import java.util.List;

/// An upright box on the ground, in the map frame [m].
public record Extent(double left, double bottom, double right, double top) {

    /// The smallest one around others.
    ///
    /// @param others at least one
    public static Extent around(List<Extent> others) {
        Extent all = others.getFirst();
        for (Extent other : others) {
            all = new Extent(
                    Math.min(all.left, other.left),
                    Math.min(all.bottom, other.bottom),
                    Math.max(all.right, other.right),
                    Math.max(all.top, other.top));
        }
        return all;
    }

    double width() {
        return right - left;
    }

    double height() {
        return top - bottom;
    }
}
