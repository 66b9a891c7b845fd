package rsal.sim.world;

/// An upright box on the ground, in the map frame [m].
public record Extent(double left, double bottom, double right, double top) {

    double width() {
        return right - left;
    }

    double height() {
        return top - bottom;
    }
}
