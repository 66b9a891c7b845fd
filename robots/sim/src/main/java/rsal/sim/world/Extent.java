package rsal.sim.world;

/// An upright box on the ground, in the map frame [m].
public record Extent(double left, double bottom, double right, double top) {

    /// Whether a place is in it or on its edge.
    public boolean contains(double x, double y) {
        return x >= left && x <= right && y >= bottom && y <= top;
    }

    double width() {
        return right - left;
    }

    double height() {
        return top - bottom;
    }
}
