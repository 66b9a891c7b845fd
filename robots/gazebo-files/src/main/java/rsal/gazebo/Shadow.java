package rsal.gazebo;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import rsal.data.Footprint;
import rsal.data.Point2d;
import rsal.data.Prism;
import rsal.data.Shape;
import rsal.model.xml.Transform;
import rsal.model.xml.Transform.Point;

/// What a shape in space looks like from above, with the heights between which it is.
final class Shadow {
    private static final int CORNERS = 24; // of a circle that is not seen from its axis
    private static final double UPRIGHT = 1e-3; // sine of the tilt of what is taken for upright
    private static final double THIN = 1e-3; // of what is flat [m]
    private static final double DUST = 1e9; // parts of a meter that count

    private Shadow() {}

    /// Whether a frame's z axis points upwards or downwards.
    static boolean isUpright(Transform in) {
        return Math.abs(in.r()[2][0]) < UPRIGHT && Math.abs(in.r()[2][1]) < UPRIGHT;
    }

    /// Whether a frame's z axis is level, so that a cylinder around it is seen as a rectangle.
    static boolean isLevel(Transform in) {
        return Math.abs(in.r()[2][2]) < UPRIGHT;
    }

    /// Whether any axis of a frame does, so that a box in it is seen as a rectangle.
    static boolean isSquare(Transform in) {
        double most = Math.max(Math.abs(in.r()[2][0]), Math.max(Math.abs(in.r()[2][1]), Math.abs(in.r()[2][2])));
        return 1 - most < UPRIGHT * UPRIGHT / 2;
    }

    /// Of a box. A tilted one is taken for what is around its corners.
    ///
    /// @param low corner in its frame [m]
    /// @param high corner in its frame [m]
    static Optional<Prism> box(Transform in, Point low, Point high) {
        var corners = new ArrayList<Point>();
        for (int i = 0; i < 8; i++) {
            corners.add(in.apply(
                    (i & 1) == 0 ? low.x() : high.x(),
                    (i & 2) == 0 ? low.y() : high.y(),
                    (i & 4) == 0 ? low.z() : high.z()));
        }
        return around(corners, 0);
    }

    /// Of a cylinder or a capsule around the z axis.
    ///
    /// @param round whether half a sphere is at each end
    static Optional<Prism> cylinder(Transform in, double radius, double length, boolean round) {
        Point low = in.apply(0, 0, -length / 2);
        Point high = in.apply(0, 0, length / 2);
        if (isUpright(in)) {
            double more = round ? radius : 0;
            return disc(
                    new Point2d((low.x() + high.x()) / 2, (low.y() + high.y()) / 2),
                    radius,
                    Math.min(low.z(), high.z()) - more,
                    Math.max(low.z(), high.z()) + more);
        }
        var points = new ArrayList<Point>();
        for (double end : new double[] {-length / 2, length / 2}) {
            for (int i = 0; i < CORNERS; i++) {
                double angle = 2 * Math.PI * i / CORNERS;
                points.add(
                        round
                                ? offset(in.apply(0, 0, end), radius * Math.cos(angle), radius * Math.sin(angle))
                                : in.apply(radius * Math.cos(angle), radius * Math.sin(angle), end));
            }
        }
        return around(points, round ? radius : 0);
    }

    private static Point offset(Point point, double x, double y) {
        return new Point(point.x() + x, point.y() + y, point.z());
    }

    /// Of an ellipsoid; a sphere when the radii are the same.
    static Optional<Prism> ellipsoid(Transform in, double a, double b, double c) {
        double[][] r = in.r();
        double up = Math.sqrt(sq(r[2][0] * a) + sq(r[2][1] * b) + sq(r[2][2] * c));
        if (a == b && (a == c || isUpright(in))) {
            return disc(new Point2d(in.x(), in.y()), a, in.z() - up, in.z() + up);
        }
        var points = new ArrayList<Point>();
        for (int i = 0; i < CORNERS; i++) { // the outermost point in each direction
            double dx = Math.cos(2 * Math.PI * i / CORNERS);
            double dy = Math.sin(2 * Math.PI * i / CORNERS);
            double u = (r[0][0] * dx + r[1][0] * dy) * a;
            double v = (r[0][1] * dx + r[1][1] * dy) * b;
            double w = (r[0][2] * dx + r[1][2] * dy) * c;
            double norm = Math.sqrt(u * u + v * v + w * w);
            points.add(in.apply(a * u / norm, b * v / norm, c * w / norm));
        }
        return around(points, 0).map(prism -> new Prism(prism.shape(), in.z() - up, in.z() + up, Optional.empty()));
    }

    private static double sq(double x) {
        return x * x;
    }

    /// Of an outline that reaches up from the plane z = 0.
    ///
    /// @throws IllegalArgumentException when it is no outline, saying why
    static Optional<Prism> extrusion(Transform in, List<Point2d> outline, double height) {
        if (isUpright(in)) {
            double end = in.z() + in.r()[2][2] * height;
            return prism(
                    new Shape.Polygon(outline.stream()
                            .map(corner -> clean(in.apply(corner.x(), corner.y(), 0)))
                            .toList()),
                    Math.min(in.z(), end),
                    Math.max(in.z(), end));
        }
        var points = new ArrayList<Point>();
        for (Point2d corner : outline) {
            points.add(in.apply(corner.x(), corner.y(), 0));
            points.add(in.apply(corner.x(), corner.y(), height));
        }
        return around(points, 0);
    }

    private static Optional<Prism> disc(Point2d center, double radius, double bottom, double top) {
        return radius > 0
                ? prism(new Shape.Disc(new Point2d(clean(center.x()), clean(center.y())), radius), bottom, top)
                : Optional.empty();
    }

    /// The convex outline around points.
    ///
    /// @param more that it reaches below and above them [m]
    private static Optional<Prism> around(List<Point> points, double more) {
        double bottom = points.stream().mapToDouble(Point::z).min().orElseThrow();
        double top = points.stream().mapToDouble(Point::z).max().orElseThrow();
        try {
            Footprint outline =
                    Footprint.around(points.stream().map(Shadow::clean).toList());
            return prism(Shape.Polygon.of(outline), bottom - more, top + more);
        } catch (IllegalArgumentException _) {
            return Optional.empty(); // it has no area
        }
    }

    private static Optional<Prism> prism(Shape shape, double bottom, double top) {
        double low = clean(bottom);
        double high = Math.max(low + THIN, clean(top));
        return Double.isFinite(high - low) && low < high
                ? Optional.of(new Prism(shape, low, high, Optional.empty()))
                : Optional.empty();
    }

    private static Point2d clean(Point point) {
        return new Point2d(clean(point.x()), clean(point.y()));
    }

    /// Without the dust of a multiplication.
    private static double clean(double value) {
        return Math.rint(value * DUST) / DUST + 0.0; // no -0
    }
}
