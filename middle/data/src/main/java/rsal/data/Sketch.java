package rsal.data;

import java.util.List;
import java.util.Optional;

/// What is drawn for people to see, in the frame of who draws it.
///
/// @param strokes later ones over earlier ones
public record Sketch(List<Stroke> strokes) {
    public static final Sketch EMPTY = new Sketch(List.of());

    public Sketch {
        strokes = List.copyOf(strokes);
    }

    /// One thing of it.
    public sealed interface Stroke {
        List<Point2d> points();

        Rgb color();
    }

    /// Points.
    public record Dots(List<Point2d> points, Rgb color) implements Stroke {
        public Dots {
            points = List.copyOf(points);
        }
    }

    /// Lines from one point to the next.
    public record Line(List<Point2d> points, Rgb color) implements Stroke {
        public Line {
            points = List.copyOf(points);
        }
    }

    /// What is within lines from one point to the next, and from the last to the first.
    ///
    /// @param fill of what is within; empty when only the lines are drawn
    public record Area(List<Point2d> points, Rgb color, Optional<Rgb> fill) implements Stroke {
        public Area {
            points = List.copyOf(points);
        }
    }
}
