package rsal.sim.world;

import java.util.List;
import rsal.data.Footprint;
import rsal.data.Point2d;

/// Something solid of a body, in the body's base frame: upright, convex, between two heights.
public sealed interface Solid {
    /// Lower end above the base [m]; −∞ where heights don't matter.
    double bottom();

    /// Upper end above the base [m]; +∞ where heights don't matter.
    double top();

    Surface surface();

    /// @param outline convex
    record Prism(Footprint outline, double bottom, double top, Surface surface) implements Solid {}

    /// @param radius [m]
    record Cylinder(Point2d center, double radius, double bottom, double top, Surface surface) implements Solid {}

    /// A body of one outline that is of every height.
    static List<Solid> of(Footprint outline) {
        return List.of(new Prism(outline, Double.NEGATIVE_INFINITY, Double.POSITIVE_INFINITY, Surface.PLAIN));
    }
}
