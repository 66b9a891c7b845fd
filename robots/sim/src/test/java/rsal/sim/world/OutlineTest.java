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

class OutlineTest {
    private static final Footprint BOX = RandomWorld.box(0.5, 0.4, -0.04, 0);
    private static final Footprint TRIANGLE =
            new Footprint(List.of(new Point2d(0.3, 0), new Point2d(-0.2, 0.2), new Point2d(-0.2, -0.2)));

    private static Pose2d anywhere(SplittableRandom random) {
        return new Pose2d(random.nextDouble(-0.6, 0.6), random.nextDouble(-0.6, 0.6), random.nextDouble(-3, 3));
    }

    private static Outline outline(Footprint footprint, Pose2d pose) {
        var outline = new Outline(footprint);
        outline.placeAt(pose);
        return outline;
    }

    @Test
    void separationTellsOverlapFromAGapAndNeverTooMuch() {
        var random = new SplittableRandom(5);
        int overlaps = 0;
        for (int i = 0; i < 500; i++) {
            Pose2d a = anywhere(random);
            Pose2d b = anywhere(random);
            double separation = outline(BOX, a).separation(outline(TRIANGLE, b), 10);
            var common = new Area(RandomWorld.shape(BOX, a));
            common.intersect(new Area(RandomWorld.shape(TRIANGLE, b)));
            assertThat(separation <= 0).as("pair %d: %s, %s", i, a, b).isEqualTo(!common.isEmpty());
            assertThat(separation).as("pair %d: %s, %s", i, a, b).isLessThanOrEqualTo(gap(a, b) + 1e-9);
            assertThat(outline(TRIANGLE, b).separation(outline(BOX, a), 10)).isEqualTo(separation);
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
            double range = outline(BOX, pose).ray(from.x(), from.y(), dx, dy);
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
}
