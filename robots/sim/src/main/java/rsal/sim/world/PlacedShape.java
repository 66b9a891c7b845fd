package rsal.sim.world;

import rsal.scene.Surface;

/// A solid, placed somewhere. Rays and collision checks look at nothing else.
abstract sealed class PlacedShape permits Polygon, Disc {
    final Surface surface;
    private static final double SAME_HEIGHT = 1e-9; // heights are sums, as of a sensor on a robot on a box [m]

    private final double bottom;
    private final double top;
    private double height; // of its body [m]

    PlacedShape(CollisionShape chunk) {
        this.surface = chunk.surface();
        this.bottom = chunk.bottom();
        this.top = chunk.top();
    }

    /// Places it with its body.
    ///
    /// @param x of mapFromBase
    /// @param cos of mapFromBase's heading
    /// @param height of the body above ground [m]
    final void place(double x, double y, double cos, double sin, double height) {
        this.height = height;
        place(x, y, cos, sin);
    }

    abstract void place(double x, double y, double cos, double sin);

    /// Of the smallest circle around its middle that holds it [m].
    abstract double radius();

    /// Of its middle, in the map frame.
    abstract double x();

    abstract double y();

    abstract double minX();

    abstract double minY();

    abstract double maxX();

    abstract double maxY();

    /// Way of a ray from a place to where it enters [m]; 0 from inside, +∞ when it misses.
    ///
    /// @param dx direction; (dx, dy) has length 1
    abstract double ray(double x, double y, double dx, double dy);

    /// Way of a ray that does not miss it to where it leaves [m].
    abstract double rayOut(double x, double y, double dx, double dy);

    /// How far this is from another [m]: at most the true distance, 0 or less when they overlap.
    final double separation(PlacedShape other) {
        return switch (this) {
            case Polygon polygon ->
                switch (other) {
                    case Polygon second -> polygon.separation(second);
                    case Disc disc -> disc.separation(polygon);
                };
            case Disc disc ->
                switch (other) {
                    case Polygon polygon -> disc.separation(polygon);
                    case Disc second -> disc.separation(second);
                };
        };
    }

    /// As [#separation(Piece)], from an upright box.
    abstract double separation(double left, double bottom, double right, double top);

    /// How far it reaches against a direction: the least of (nx, ny) · (x, y) over all its points [m];
    /// (nx, ny) has length 1.
    abstract double least(double nx, double ny);

    /// Lower end above ground [m].
    final double low() {
        return bottom + height;
    }

    /// Upper end above ground [m].
    final double high() {
        return top + height;
    }

    /// Whether a level ray at a height above ground [m] can meet it. Its top and its underside belong to it, as in
    /// Stage: a finder on top of a robot sees robots that are as high.
    final boolean isAt(double z) {
        return isBetween(bottom + height, z, top + height);
    }

    /// Whether a height is between two others, up to rounding [m].
    static boolean isBetween(double low, double z, double high) {
        return low - SAME_HEIGHT <= z && z <= high + SAME_HEIGHT;
    }

    /// How far one of the two begins above where the other ends [m]; less than 0 when they are level.
    final double gapAbove(PlacedShape other) {
        return Math.max(low() - other.high(), other.low() - high());
    }

    /// Whether the two are at a height in common.
    final boolean isLevelWith(PlacedShape other) {
        return bottom + height < other.top + other.height && other.bottom + other.height < top + height;
    }

    /// Whether it is at some of the heights from one to another.
    final boolean isBetween(double low, double high) {
        return bottom + height < high && low < top + height;
    }
}
