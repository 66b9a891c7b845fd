package rsal.sim.world;

import java.util.HashMap;
import java.util.Map;
import java.util.function.ToDoubleFunction;

/// How a body gets out of others into which it was put.
final class Withdrawal {
    private static final double STRIDE = 0.005; // m

    private final World world;
    private final Body body;

    Withdrawal(World world, Body body) {
        this.world = world;
        this.body = body;
    }

    /// Moves the body, which overlaps others, as they were [World#put] into it, as far as that leads no deeper
    /// into any of them and into nothing else. It is checked every few millimeters.
    ///
    /// @param distance that any point of it makes, at most [m]
    /// @return how much of the way it made, 0–1; when less than 1, [World#obstacle] says why
    double goOn(Arc arc, double distance) {
        var depths = new HashMap<Body, Double>();
        isNoDeeper(body.figure, _ -> Double.NEGATIVE_INFINITY, depths);
        int strides = (int) Math.ceil(distance / STRIDE);
        for (int made = 0; made < strides; made++) {
            body.trial.placeAt(arc.at((made + 1.0) / strides), body.height());
            var now = new HashMap<Body, Double>();
            if (!isNoDeeper(body.trial, other -> depths.getOrDefault(other, World.HAIR), now)) {
                return (double) made / strides;
            }
            body.figure.placeAt(body.trial);
            depths.clear();
            depths.putAll(now);
        }
        return 1;
    }

    /// Whether a figure keeps off walls, and off each body by as much as that asks for.
    ///
    /// @param least by which it must keep off a body [m]; less than 0 for how deep it may be in it
    /// @param depths takes by how much it is in each that it is in [m], all less than a hair
    private boolean isNoDeeper(Figure figure, ToDoubleFunction<Body> least, Map<Body, Double> depths) {
        world.obstacle(null);
        if (world.clearanceOfWalls(figure, World.HAIR) < World.HAIR) {
            return false;
        }
        for (PlacedShape piece : figure.pieces) {
            PieceGrid.Found near = world.nowNear(piece.x(), piece.y(), piece.radius() + World.HAIR);
            for (int i = 0; i < near.count; i++) {
                Body owner = world.owner(near.slots[i]);
                PlacedShape other = world.now(near.slots[i]);
                if (owner != body && World.obstructing(piece, other)) {
                    double gap = piece.separation(other);
                    if (gap < least.applyAsDouble(owner)) {
                        world.obstacle(owner);
                        return false;
                    }
                    if (gap < World.HAIR) {
                        depths.merge(owner, gap, Math::min);
                    }
                }
            }
        }
        return true;
    }
}
