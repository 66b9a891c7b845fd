package rsal.sim.world;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.awt.geom.Path2D;
import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import rsal.data.Point2d;
import rsal.data.Shape;

class ConvexTest {
    /// A star-shaped outline with dents, around the origin.
    private static Shape.Polygon star(SplittableRandom random) {
        int count = random.nextInt(3, 30);
        double size = random.nextDouble(0.1, 5);
        var corners = new ArrayList<Point2d>();
        for (int i = 0; i < count; i++) {
            double radius = size * (random.nextInt(3) == 0 ? 0.5 : random.nextDouble(0.1, 1));
            double angle = 2 * Math.PI * i / count;
            corners.add(new Point2d(radius * Math.cos(angle), radius * Math.sin(angle)));
        }
        return new Shape.Polygon(corners);
    }

    private static Path2D path(List<Point2d> corners) {
        var path = new Path2D.Double();
        path.moveTo(corners.getFirst().x(), corners.getFirst().y());
        corners.forEach(corner -> path.lineTo(corner.x(), corner.y()));
        path.closePath();
        return path;
    }

    @Test
    void partsAreConvexSmallAndCoverWhatTheOutlineEncloses() {
        for (long seed = 0; seed < 300; seed++) {
            var random = new SplittableRandom(seed);
            var outline = star(random);
            List<List<Point2d>> parts = Convex.small(outline.corners());

            double area = 0;
            for (List<Point2d> part : parts) {
                area += area(part);
                for (int i = 0; i < part.size(); i++) {
                    Point2d a = part.get(i);
                    Point2d b = part.get((i + 1) % part.size());
                    Point2d c = part.get((i + 2) % part.size());
                    double turn = (b.x() - a.x()) * (c.y() - b.y()) - (b.y() - a.y()) * (c.x() - b.x());
                    assertThat(turn).as("seed %d", seed).isGreaterThan(-1e-12);
                }
                var bounds = path(part).getBounds2D();
                assertThat(Math.max(bounds.getWidth(), bounds.getHeight())).isLessThanOrEqualTo(2);
            }
            assertThat(area).as("seed %d", seed).isCloseTo(outline.area(), within(1e-9));
            Path2D whole = path(outline.corners());
            for (int i = 0; i < 100; i++) {
                double x = random.nextDouble(-5, 5);
                double y = random.nextDouble(-5, 5);
                assertThat(parts.stream().anyMatch(part -> path(part).contains(x, y)))
                        .as("seed %d: (%s, %s)", seed, x, y)
                        .isEqualTo(whole.contains(x, y));
            }
        }
    }

    private static double area(List<Point2d> corners) {
        double twice = 0;
        for (int i = 0; i < corners.size(); i++) {
            Point2d a = corners.get(i);
            Point2d b = corners.get((i + 1) % corners.size());
            twice += a.x() * b.y() - a.y() * b.x();
        }
        return twice / 2;
    }

    @Test
    void whatIsConvexAndSmallStaysWhole() {
        var box = List.of(new Point2d(0, 0), new Point2d(1, 0), new Point2d(1, 1), new Point2d(0, 1));
        assertThat(Convex.small(box)).hasSize(1);
        var inLine = List.of(new Point2d(0, 0), new Point2d(0.5, 0), new Point2d(1, 0), new Point2d(1, 1));
        assertThat(Convex.small(inLine)).hasSize(1);
    }
}
