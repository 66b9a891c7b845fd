package rsal.sim.world;

import java.util.ArrayList;
import java.util.List;
import rsal.data.Footprint;
import rsal.data.Point2d;
import rsal.data.Shape;
import rsal.scene.Block;
import rsal.scene.Surface;

/// Something solid of a body, in the body's base frame: upright, convex, between two heights, and not large, so
/// that who looks for what is near finds little else.
public sealed interface CollisionShape {
    /// Lower end above the base [m]; −∞ where heights don't matter.
    double bottom();

    /// Upper end above the base [m]; +∞ where heights don't matter.
    double top();

    Surface surface();

    record Prism(ConvexOutline outline, double bottom, double top, Surface surface) implements CollisionShape {}

    /// @param radius [m]
    record Cylinder(Point2d center, double radius, double bottom, double top, Surface surface)
            implements CollisionShape {}

    /// One that moves with an actuator.
    ///
    /// @param chunk in the base frame while all actuators are at home
    /// @param carrier the actuator's name
    record Carried(CollisionShape chunk, String carrier) implements CollisionShape {
        @Override
        public double bottom() {
            return chunk.bottom();
        }

        @Override
        public double top() {
            return chunk.top();
        }

        @Override
        public Surface surface() {
            return chunk.surface();
        }
    }

    /// A body of one outline that is of every height.
    static List<CollisionShape> of(Footprint outline) {
        var all = new ConvexOutline(outline.corners());
        return List.of(new Prism(all, Double.NEGATIVE_INFINITY, Double.POSITIVE_INFINITY, Surface.PLAIN));
    }

    /// What a body's blocks are made of.
    static List<CollisionShape> of(List<Block> blocks) {
        var chunks = new ArrayList<CollisionShape>();
        for (Block block : blocks) {
            double bottom = block.prism().bottom();
            double top = block.prism().top();
            switch (block.prism().shape()) {
                case Shape.Disc disc ->
                    chunks.add(on(block, new Cylinder(disc.center(), disc.radius(), bottom, top, block.surface())));
                case Shape.Polygon polygon -> {
                    for (List<Point2d> part : Convex.small(polygon.corners())) {
                        chunks.add(on(block, new Prism(new ConvexOutline(part), bottom, top, block.surface())));
                    }
                }
            }
        }
        return List.copyOf(chunks);
    }

    private static CollisionShape on(Block block, CollisionShape chunk) {
        return block.carrier().isEmpty()
                ? chunk
                : new Carried(chunk, block.carrier().get());
    }
}
