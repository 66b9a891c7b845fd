package rsal.data;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
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
}
