package rsal.data;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.Test;
import rsal.data.Shape.Disc;
import rsal.data.Shape.Polygon;

class ShapeTest {
    @Test
    void anOutlineMayBeDentedAndRunEitherWay() {
        Polygon angle = polygon(0, 0, 2, 0, 2, 1, 1, 1, 1, 2, 0, 2);
        assertThat(angle.area()).isCloseTo(3, within(1e-12));
        assertThat(new Polygon(angle.corners().reversed())).isEqualTo(angle);
        assertThat(angle.hull().corners()).hasSize(5).doesNotContain(new Point2d(1, 1));
    }

    @Test
    void refusesWhatIsNoOutline() {
        assertRefused("at least 3 corners", 0, 0, 1, 0);
        assertRefused("in a line", 0, 0, 1, 0, 2, 0);
        assertRefused("meets", 0, 0, 1, 1, 1, 0, 0, 1);
        assertRefused("meets", 0, 0, 4, 0, 4, 4, 2, 0, 0, 4);
        assertRefused("once", 0, 0, 1, 0, 1, 0, 1, 1);
        assertRefused("not finite", 0, 0, 1, 0, Double.NaN, 1);
        assertThatIllegalArgumentException().isThrownBy(() -> new Disc(new Point2d(0, 0), 0));
        assertThatIllegalArgumentException().isThrownBy(() -> new Disc(new Point2d(0, Double.NaN), 1));
    }

    @Test
    void aHullIsConvexHoldsAllCornersAndHasNoOthers() {
        for (long seed = 0; seed < 300; seed++) {
            Polygon star = star(new Random(seed));
            Footprint hull = star.hull(); // a footprint is convex, or it is not made
            assertThat(star.corners()).as("seed %d", seed).containsAll(hull.corners());
            for (int i = 0; i < hull.corners().size(); i++) {
                Point2d a = hull.corners().get(i);
                Point2d b = hull.corners().get((i + 1) % hull.corners().size());
                for (Point2d c : star.corners()) {
                    double left = (b.x() - a.x()) * (c.y() - a.y()) - (b.y() - a.y()) * (c.x() - a.x());
                    assertThat(left).as("seed %d", seed).isGreaterThanOrEqualTo(-1e-12);
                }
            }
        }
    }

    @Test
    void theHullOfADiscHoldsItAndHardlyMore() {
        Footprint hull = new Disc(new Point2d(0, 0), 0.5).hull();
        assertThat(hull.inscribedRadius()).isCloseTo(0.5, within(1e-12));
        assertThat(hull.circumscribedRadius()).isBetween(0.5, 0.5 * 1.009);
    }

    /// Around the origin, in and out.
    private static Polygon star(Random random) {
        var corners = new ArrayList<Point2d>();
        int n = 3 + random.nextInt(10);
        for (int i = 0; i < n; i++) {
            corners.add(
                    Pose2d.polar(0.1 + random.nextDouble(), 2 * Math.PI * i / n).position());
        }
        return new Polygon(corners);
    }

    private static Polygon polygon(double... xy) {
        return new Polygon(points(xy));
    }

    private static List<Point2d> points(double... xy) {
        var points = new ArrayList<Point2d>();
        for (int i = 0; i < xy.length; i += 2) {
            points.add(new Point2d(xy[i], xy[i + 1]));
        }
        return points;
    }

    private static void assertRefused(String why, double... xy) {
        assertThatIllegalArgumentException()
                .isThrownBy(() -> new Polygon(points(xy)))
                .withMessageContaining(why);
    }
}
