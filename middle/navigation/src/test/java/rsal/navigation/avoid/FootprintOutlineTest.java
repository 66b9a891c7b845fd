package rsal.navigation.avoid;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import rsal.data.Footprint;
import rsal.data.Point2d;
import rsal.data.Pose2d;

class FootprintOutlineTest {
    private static final Footprint BOX = Footprint.box(0.6, 0.4, new Point2d(-0.1, 0));

    @Test
    void distancesAreToTheOutline() {
        var outline = new FootprintOutline(BOX, 0);
        assertThat(outline.distance(0.5, 0)).isCloseTo(0.3, within(1e-9));
        assertThat(outline.distance(0, -0.25)).isCloseTo(0.05, within(1e-9));
        assertThat(outline.distance(-0.1, 0)).isCloseTo(-0.2, within(1e-9));
        assertThat(new FootprintOutline(BOX, 0.1).distance(0.5, 0)).isCloseTo(0.2, within(1e-9));
        assertThat(outline.reach()).isCloseTo(Math.hypot(0.4, 0.2), within(1e-9));
    }

    @Test
    void goesStraightUntilItMeetsAPoint() {
        var outline = new FootprintOutline(BOX, 0);
        assertThat(outline.freeDistance(1, 0.1, 0)).isCloseTo(0.8, within(1e-9));
        assertThat(outline.freeDistance(1, 0.3, 0)).isInfinite();
        assertThat(outline.freeDistance(-1, 0, 0)).isInfinite();
        assertThat(outline.freeDistance(0, 0, 0)).isZero();
    }

    /// The slow, obvious way: many small steps.
    @Test
    void waysOnArcsAreThoseOfManySmallSteps() {
        var random = new SplittableRandom(1);
        var outline = new FootprintOutline(BOX, 0.05);
        double step = 0.001;
        for (int i = 0; i < 300; i++) {
            double x = random.nextDouble(-2, 2);
            double y = random.nextDouble(-2, 2);
            double curvature = random.nextDouble(-3, 3);
            double stepped = 0;
            Pose2d pose = Pose2d.ORIGIN;
            double full = 2 * Math.PI / Math.abs(curvature);
            while (stepped < full) {
                Point2d seen = pose.inverse().transform(new Point2d(x, y));
                if (outline.distance(seen.x(), seen.y()) <= 0) {
                    break;
                }
                pose = pose.compose(new Pose2d(step, 0, 0)).compose(new Pose2d(0, 0, step * curvature));
                stepped += step;
            }
            double way = outline.freeDistance(x, y, curvature);
            if (stepped < full) {
                assertThat(way).as("(%s, %s), curvature %s", x, y, curvature).isCloseTo(stepped, within(0.03));
            } else {
                assertThat(way).as("(%s, %s), curvature %s", x, y, curvature).isGreaterThan(full - 0.05);
            }
        }
    }

    /// A circle of the same area.
    @Test
    void itsRadiusIsThatOfACircleThatCoversAsMuch() {
        Footprint box = Footprint.box(0.6, 0.4, new Point2d(0.3, -0.2));
        assertThat(FootprintOutline.radius(box)).isCloseTo(Math.sqrt(0.24 / Math.PI), within(1e-9));
        var triangle = new Footprint(List.of(new Point2d(-0.1, -0.1), new Point2d(0.5, -0.1), new Point2d(-0.1, 0.3)));
        assertThat(FootprintOutline.radius(triangle)).isCloseTo(Math.sqrt(0.12 / Math.PI), within(1e-9));
    }

    /// The slow, obvious way, straight on: of a body whose sides are slanted.
    @Test
    void waysStraightOnAreThoseOfManySmallSteps() {
        var wedge = new Footprint(List.of(new Point2d(0.4, 0.05), new Point2d(-0.3, 0.25), new Point2d(-0.2, -0.35)));
        var outline = new FootprintOutline(wedge, 0);
        var random = new SplittableRandom(2);
        int met = 0;
        for (int i = 0; i < 300; i++) {
            double x = random.nextDouble(-1, 2);
            double y = random.nextDouble(-0.5, 0.5);
            double stepped = 0;
            while (stepped < 3 && outline.distance(x - stepped, y) > 0) {
                stepped += 1e-3;
            }
            double way = outline.freeDistance(x, y, i % 2 == 0 ? 0 : 5e-5);
            if (stepped < 3) {
                assertThat(way).as("(%s, %s)", x, y).isCloseTo(stepped, within(2e-3));
                met++;
            } else {
                assertThat(way).as("(%s, %s)", x, y).isInfinite();
            }
        }
        assertThat(met).isBetween(50, 250);
    }

    /// Of each corner as far as the sides are pushed outward.
    @Test
    void itsReachIsThatOfItsFarthestCorner() {
        assertThat(new FootprintOutline(BOX, 0.1).reach()).isCloseTo(Math.hypot(0.5, 0.3), within(1e-9));
        Footprint ahead = Footprint.box(0.6, 0.4, new Point2d(0.5, -0.3));
        assertThat(new FootprintOutline(ahead, 0).reach()).isCloseTo(Math.hypot(0.8, 0.5), within(1e-9));
    }
}
