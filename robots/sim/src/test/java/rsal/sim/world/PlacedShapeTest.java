package rsal.sim.world;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.awt.geom.Area;
import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import rsal.data.Footprint;
import rsal.data.Point2d;
import rsal.data.Pose2d;
import rsal.scene.Surface;

class PlacedShapeTest {
    private static final Footprint BOX = RandomWorld.box(0.5, 0.4, -0.04, 0);
    private static final Footprint TRIANGLE =
            new Footprint(List.of(new Point2d(0.3, 0), new Point2d(-0.2, 0.2), new Point2d(-0.2, -0.2)));

    private static Pose2d anywhere(SplittableRandom random) {
        return new Pose2d(random.nextDouble(-0.6, 0.6), random.nextDouble(-0.6, 0.6), random.nextDouble(-3, 3));
    }

    private static PlacedShape polygon(Footprint footprint, Pose2d pose) {
        return placed(
                new Polygon((CollisionShape.Prism) CollisionShape.of(footprint).getFirst()), pose);
    }

    private static PlacedShape disc(Point2d center, double radius, Pose2d pose) {
        return placed(new Disc(new CollisionShape.Cylinder(center, radius, 0, 1, Surface.PLAIN)), pose);
    }

    private static PlacedShape placed(PlacedShape piece, Pose2d pose) {
        piece.place(pose.x(), pose.y(), Math.cos(pose.theta()), Math.sin(pose.theta()), 0);
        return piece;
    }

    @Test
    void separationDistinguishesOverlapFromAGapAndIsNeverTooMuch() {
        var random = new SplittableRandom(5);
        int overlaps = 0;
        for (int i = 0; i < 500; i++) {
            Pose2d a = anywhere(random);
            Pose2d b = anywhere(random);
            double separation = polygon(BOX, a).separation(polygon(TRIANGLE, b));
            var common = new Area(RandomWorld.shape(BOX, a));
            common.intersect(new Area(RandomWorld.shape(TRIANGLE, b)));
            assertThat(separation <= 0).as("pair %d: %s, %s", i, a, b).isEqualTo(!common.isEmpty());
            assertThat(separation).as("pair %d: %s, %s", i, a, b).isLessThanOrEqualTo(gap(a, b) + 1e-9);
            assertThat(polygon(TRIANGLE, b).separation(polygon(BOX, a))).isEqualTo(separation);
            overlaps += common.isEmpty() ? 0 : 1;
        }
        assertThat(overlaps).isBetween(125, 375);
    }

    /// Between points all along the two borders; more than the true gap by as much as those are apart.
    private static double gap(Pose2d a, Pose2d b) {
        double gap = Double.POSITIVE_INFINITY;
        for (int i = 0; i < 200; i++) {
            Point2d p = a.transform(border(BOX, i / 200.0));
            for (int j = 0; j < 200; j++) {
                gap = Math.min(gap, p.distanceTo(b.transform(border(TRIANGLE, j / 200.0))));
            }
        }
        return gap;
    }

    private static Point2d border(Footprint footprint, double part) {
        int count = footprint.corners().size();
        int edge = (int) (part * count);
        double along = part * count - edge;
        Point2d from = footprint.corners().get(edge);
        Point2d to = footprint.corners().get((edge + 1) % count);
        return new Point2d(from.x() + along * (to.x() - from.x()), from.y() + along * (to.y() - from.y()));
    }

    @Test
    void raysEnterWhereSteppingRaysDo() {
        var random = new SplittableRandom(6);
        int hits = 0;
        for (int i = 0; i < 500; i++) {
            Pose2d from = anywhere(random);
            Pose2d pose = anywhere(random);
            var shape = RandomWorld.shape(BOX, pose);
            double dx = Math.cos(from.theta());
            double dy = Math.sin(from.theta());
            double range = polygon(BOX, pose).ray(from.x(), from.y(), dx, dy);
            double stepping = 0;
            while (stepping < 3 && !shape.contains(from.x() + stepping * dx, from.y() + stepping * dy)) {
                stepping += 1e-3;
            }
            if (stepping < 3) {
                hits++;
                assertThat(range).as("ray %d from %s to %s", i, from, pose).isCloseTo(stepping, within(1.1e-3));
            } else if (range < Double.POSITIVE_INFINITY) { // it cuts a corner that steps jump over
                assertThat(shape.intersects(from.x() + range * dx - 1e-9, from.y() + range * dy - 1e-9, 2e-9, 2e-9))
                        .as("ray %d from %s to %s", i, from, pose)
                        .isTrue();
            }
        }
        assertThat(hits).isGreaterThan(100);
    }

    @Test
    void discsKeepTheirDistanceAsPointsOfTheirBordersDo() {
        var random = new SplittableRandom(7);
        for (int i = 0; i < 300; i++) {
            var center = new Point2d(random.nextDouble(-0.2, 0.2), 0.1);
            double radius = random.nextDouble(0.01, 0.5);
            Pose2d a = anywhere(random);
            Pose2d b = anywhere(random);
            PlacedShape disc = disc(center, radius, a);
            Point2d middle = a.transform(center);

            double fromBox = Double.POSITIVE_INFINITY;
            for (int j = 0; j < 4000; j++) {
                fromBox = Math.min(fromBox, middle.distanceTo(b.transform(border(BOX, j / 4000.0))) - radius);
            }
            boolean inside = RandomWorld.shape(BOX, b).contains(middle.x(), middle.y());
            double separation = disc.separation(polygon(BOX, b));
            assertThat(polygon(BOX, b).separation(disc)).isEqualTo(separation);
            if (inside) {
                assertThat(separation).as("pair %d", i).isNegative();
            } else {
                assertThat(separation).as("pair %d", i).isCloseTo(fromBox, within(1e-4));
            }

            PlacedShape second = disc(new Point2d(0, 0), 0.2, b);
            assertThat(disc.separation(second))
                    .isCloseTo(middle.distanceTo(new Point2d(b.x(), b.y())) - radius - 0.2, within(1e-12));

            double left = random.nextDouble(-1, 1);
            var box = Footprint.box(0.3, 0.2, new Point2d(left + 0.15, 0.1));
            double fromUpright = disc.separation(left, 0, left + 0.3, 0.2);
            double sameTurned = disc.separation(polygon(box, Pose2d.ORIGIN));
            assertThat(fromUpright <= 0).as("pair %d", i).isEqualTo(sameTurned <= 0);
            if (fromUpright > 0) {
                assertThat(fromUpright).as("pair %d", i).isCloseTo(sameTurned, within(1e-12));
            }
        }
    }

    @Test
    void raysEnterDiscsAtTheirBorder() {
        var random = new SplittableRandom(8);
        int hits = 0;
        for (int i = 0; i < 1000; i++) {
            Pose2d from = anywhere(random);
            Pose2d at = anywhere(random);
            double radius = random.nextDouble(0.01, 0.5);
            double dx = Math.cos(from.theta());
            double dy = Math.sin(from.theta());
            double range = disc(new Point2d(0, 0), radius, at).ray(from.x(), from.y(), dx, dy);
            double along = (at.x() - from.x()) * dx + (at.y() - from.y()) * dy;
            double aside = (at.x() - from.x()) * dy - (at.y() - from.y()) * dx;
            if (from.distanceTo(at) <= radius) {
                assertThat(range).isZero();
            } else if (along < 0 || Math.abs(aside) > radius) {
                assertThat(range).as("ray %d", i).isEqualTo(Double.POSITIVE_INFINITY);
            } else {
                hits++;
                double fromMiddle = Math.hypot(from.x() + range * dx - at.x(), from.y() + range * dy - at.y());
                assertThat(fromMiddle).as("ray %d", i).isCloseTo(radius, within(1e-9));
                assertThat(range).as("ray %d", i).isLessThanOrEqualTo(along);
            }
        }
        assertThat(hits).isGreaterThan(100);
    }
}
