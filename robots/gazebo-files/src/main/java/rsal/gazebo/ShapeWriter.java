package rsal.gazebo;

import java.util.List;
import java.util.Optional;
import rsal.data.Footprint;
import rsal.data.Point2d;
import rsal.data.Prism;
import rsal.data.Rgb;
import rsal.data.Shape;

/// Writes pieces of bodies as shapes: what is in the way as `collision`, what is seen as `visual`.
final class ShapeWriter {
    private static final double SAME = 1e-9; // [m]

    private final SdfXml xml;

    ShapeWriter(SdfXml xml) {
        this.xml = xml;
    }

    /// @param name unique in its link
    /// @param friction coefficient; empty for the usual one
    void collision(String name, Prism prism, Optional<Double> friction) {
        xml.open("collision", "name", name);
        shape(prism);
        friction.ifPresent(this::friction);
        xml.close("collision");
    }

    private void friction(double mu) {
        xml.open("surface").open("friction").open("ode").numbers("mu", mu).numbers("mu2", mu);
        xml.close("ode").close("friction").close("surface");
    }

    /// @param name unique in its link
    void visual(String name, Prism prism, Rgb color) {
        xml.open("visual", "name", name);
        shape(prism);
        color(color);
        xml.close("visual");
    }

    void color(Rgb color) {
        String written = SdfColor.written(color);
        xml.open("material").leaf("ambient", written).leaf("diffuse", written).close("material");
    }

    private void shape(Prism prism) {
        double middle = (prism.bottom() + prism.top()) / 2;
        double tall = prism.top() - prism.bottom();
        switch (prism.shape()) {
            case Shape.Disc disc -> {
                xml.numbers("pose", disc.center().x(), disc.center().y(), middle, 0, 0, 0);
                xml.open("geometry")
                        .open("cylinder")
                        .numbers("radius", disc.radius())
                        .numbers("length", tall);
                xml.close("cylinder").close("geometry");
            }
            case Shape.Polygon polygon -> {
                Optional<Point2d[]> box = box(polygon.corners());
                if (box.isPresent()) {
                    Point2d low = box.get()[0];
                    Point2d high = box.get()[1];
                    xml.numbers("pose", (low.x() + high.x()) / 2, (low.y() + high.y()) / 2, middle, 0, 0, 0);
                    xml.open("geometry").open("box").numbers("size", high.x() - low.x(), high.y() - low.y(), tall);
                    xml.close("box").close("geometry");
                } else {
                    xml.numbers("pose", 0, 0, prism.bottom(), 0, 0, 0);
                    xml.open("geometry").open("polyline");
                    polygon.corners().forEach(corner -> xml.numbers("point", corner.x(), corner.y()));
                    xml.numbers("height", tall).close("polyline").close("geometry");
                }
            }
        }
    }

    /// The lower left and upper right corner of an outline that is a box along the axes.
    private static Optional<Point2d[]> box(List<Point2d> corners) {
        if (corners.size() != 4) {
            return Optional.empty();
        }
        double left = corners.stream().mapToDouble(Point2d::x).min().orElseThrow();
        double right = corners.stream().mapToDouble(Point2d::x).max().orElseThrow();
        double low = corners.stream().mapToDouble(Point2d::y).min().orElseThrow();
        double high = corners.stream().mapToDouble(Point2d::y).max().orElseThrow();
        boolean upright = corners.stream()
                .allMatch(corner -> Math.min(corner.x() - left, right - corner.x()) < SAME
                        && Math.min(corner.y() - low, high - corner.y()) < SAME);
        return upright && right - left > 2 * SAME && high - low > 2 * SAME
                ? Optional.of(new Point2d[] {new Point2d(left, low), new Point2d(right, high)})
                : Optional.empty();
    }

    /// Mass and moments of what fills a box around an outline.
    ///
    /// @param floor height of its underside [m]
    void inertia(Footprint outline, double floor, double top, double mass) {
        List<Point2d> corners = outline.corners();
        double left = corners.stream().mapToDouble(Point2d::x).min().orElseThrow();
        double right = corners.stream().mapToDouble(Point2d::x).max().orElseThrow();
        double low = corners.stream().mapToDouble(Point2d::y).min().orElseThrow();
        double high = corners.stream().mapToDouble(Point2d::y).max().orElseThrow();
        double a = right - left;
        double b = high - low;
        double c = top - floor;
        xml.open("inertial").numbers("pose", (left + right) / 2, (low + high) / 2, floor + c / 3, 0, 0, 0);
        moments(mass, mass / 12 * (b * b + c * c), mass / 12 * (a * a + c * c), mass / 12 * (a * a + b * b));
        xml.close("inertial");
    }

    void moments(double mass, double xx, double yy, double zz) {
        xml.numbers("mass", mass);
        xml.open("inertia").numbers("ixx", least(xx)).numbers("iyy", least(yy)).numbers("izz", least(zz));
        xml.numbers("ixy", 0).numbers("ixz", 0).numbers("iyz", 0).close("inertia");
    }

    /// What engines can still compute with, and the file can tell [kg m²].
    private static double least(double moment) {
        return Math.max(1e-7, moment);
    }
}
