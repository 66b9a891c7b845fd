package rsal.data;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;

class FootprintTest {
    @Test
    void aBoxAroundTheOriginHoldsAndIsHeldByCircles() {
        Footprint box = Footprint.box(0.4, 0.3, new Point2d(0, 0));
        assertThat(box.circumscribedRadius()).isCloseTo(0.25, within(1e-12));
        assertThat(box.inscribedRadius()).isCloseTo(0.15, within(1e-12));
    }

    @Test
    void circlesAreAroundTheBaseNotAroundTheMiddle() {
        Footprint box = Footprint.box(0.4, 0.3, new Point2d(-0.1, 0));
        assertThat(box.circumscribedRadius()).isCloseTo(Math.hypot(0.3, 0.15), within(1e-12));
        assertThat(box.inscribedRadius()).isCloseTo(0.1, within(1e-12));
    }

    @Test
    void itsWidthIsThatOfTheLaneItDrivesIn() {
        var wedge = new Footprint(List.of(new Point2d(0.45, 0), new Point2d(-0.25, 0.3), new Point2d(-0.25, -0.3)));
        assertThat(wedge.halfWidth()).isEqualTo(0.3);
        assertThat(wedge.inscribedRadius()).isLessThan(0.2);
        assertThat(Footprint.box(0.4, 0.3, new Point2d(0, 0.1)).halfWidth()).isCloseTo(0.25, within(1e-12));
    }

    @Test
    void aBodyBesideTheOriginHoldsNoCircle() {
        assertThat(Footprint.box(0.4, 0.3, new Point2d(1, 0)).inscribedRadius()).isZero();
    }

    @Test
    void refusesWhatIsFlatClockwiseDentedOrBroken() {
        var a = new Point2d(0, 0);
        var b = new Point2d(1, 0);
        var c = new Point2d(1, 1);
        assertThatIllegalArgumentException().isThrownBy(() -> new Footprint(List.of(a, b)));
        assertThatIllegalArgumentException().isThrownBy(() -> new Footprint(List.of(a, b, new Point2d(2, 0))));
        assertThatIllegalArgumentException().isThrownBy(() -> new Footprint(List.of(c, b, a)));
        assertThatIllegalArgumentException().isThrownBy(() -> new Footprint(List.of(a, b, c, new Point2d(0.9, 0.2))));
        assertThatIllegalArgumentException().isThrownBy(() -> new Footprint(List.of(a, b, new Point2d(Double.NaN, 1))));
    }

    @Test
    void refusesWhatGoesAroundTwice() {
        List<Point2d> star = IntStream.range(0, 5)
                .mapToObj(i -> Pose2d.polar(1, i * Math.toRadians(144)).position())
                .toList();
        assertThatIllegalArgumentException().isThrownBy(() -> new Footprint(star));
    }

    @Test
    void anOutlineAroundPointsThatAreInALineUpToRoundingIsMade() {
        var hull = Footprint.around(List.of( // three of them in a line, of which rounding makes a dent of 1e-17 m
                new Point2d(-0.14285714285714288, -0.15),
                new Point2d(0.028571428571428574, -0.09),
                new Point2d(0.2, -0.03),
                new Point2d(0.2, 0.03),
                new Point2d(-0.14285714285714288, 0.15),
                new Point2d(-0.2, 0.0)));
        assertThat(hull.circumscribedRadius()).isCloseTo(Math.hypot(0.14285714285714288, 0.15), within(1e-12));
    }

    /// Points on lines, on a lattice or nearly the same, in a frame that is moved and rotated: where rounding decides.
    @Test
    void anOutlineAroundAnyPointsHoldsThemAll() {
        var random = new Random(20261127);
        for (int round = 0; round < 20_000; round++) {
            double size = Math.pow(10, random.nextInt(-3, 4));
            var frame = new Pose2d(
                    random.nextGaussian() * 100, random.nextGaussian() * 100, random.nextDouble(-Math.PI, Math.PI));
            List<Point2d> points = new ArrayList<>();
            for (int i = random.nextInt(4, 12); i > 0; i--) {
                double nudge = random.nextInt(4) == 0 ? random.nextGaussian() * 1e-15 : 0;
                points.add(frame.transform(new Point2d(
                        size * (random.nextInt(7) / 6.0 + nudge), size * (random.nextInt(7) / 6.0 - nudge))));
            }
            points.add(frame.transform(new Point2d(0, 0)));
            points.add(frame.transform(new Point2d(size, 0)));
            points.add(frame.transform(new Point2d(0, size)));
            Footprint hull = Footprint.around(points);
            for (Point2d point : points) {
                assertThat(isLeft(hull, point, 1e-9 * size * size))
                        .as("round %d: %s holds %s", round, hull, point)
                        .isTrue();
            }
        }
    }

    private static boolean isLeft(Footprint hull, Point2d point, double slack) {
        List<Point2d> corners = hull.corners();
        return IntStream.range(0, corners.size())
                .allMatch(i -> Footprint.turn(corners.get(i), corners.get((i + 1) % corners.size()), point) >= -slack);
    }
}
