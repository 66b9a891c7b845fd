package rsal.data;

import java.util.Optional;

/// A piece of a body: a shape that reaches from one height to another.
///
/// @param shape in the body's frame
/// @param bottom of the piece above the floor [m], when the body stands there
/// @param top the same [m]
/// @param color as cameras see it; empty when it is that of the whole body
public record Prism(Shape shape, double bottom, double top, Optional<Rgb> color) {
    public Prism {
        if (!(bottom < top && Double.isFinite(top - bottom))) {
            throw new IllegalArgumentException(
                    "A piece's bottom '%s' must be below its top '%s', both finite.".formatted(bottom, top));
        }
    }

    /// From the floor up.
    public static Prism standing(Shape shape, double height) {
        return new Prism(shape, 0, height, Optional.empty());
    }

    /// The same in a color.
    public Prism in(Rgb other) {
        return new Prism(shape, bottom, top, Optional.of(other));
    }
}
