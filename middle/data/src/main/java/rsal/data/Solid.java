package rsal.data;

import java.util.ArrayList;
import java.util.List;

/// What is solid of a robot or a thing, in its own frame: pieces that may overlap and need not touch.
public record Solid(List<Prism> pieces) {
    public Solid {
        pieces = List.copyOf(pieces);
        if (pieces.isEmpty()) {
            throw new IllegalArgumentException("A body has at least one piece.");
        }
    }

    /// One piece on the floor.
    ///
    /// @param height [m]
    public static Solid standing(Shape shape, double height) {
        return new Solid(List.of(Prism.standing(shape, height)));
    }

    /// The convex outline around all pieces, as seen from above.
    public Footprint hull() {
        var corners = new ArrayList<Point2d>();
        pieces.forEach(piece -> corners.addAll(piece.shape().hull().corners()));
        return Footprint.around(corners);
    }

    /// The highest that is solid [m].
    public double top() {
        return pieces.stream().mapToDouble(Prism::top).max().orElseThrow();
    }
}
