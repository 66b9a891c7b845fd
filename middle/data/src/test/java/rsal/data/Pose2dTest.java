package rsal.data;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.Random;
import org.junit.jupiter.api.Test;

class Pose2dTest {
    private final Random random = new Random(2);

    @Test
    void composingWalksAlongTheAxesOfTheFirst() {
        Pose2d mapFromLaser = Pose2d.ofDegrees(1, 2, 90).compose(Pose2d.ofDegrees(0.5, 0.1, -90));
        assertNear(mapFromLaser, new Pose2d(0.9, 2.5, 0));
    }

    @Test
    void composingIsAssociative() {
        for (int i = 0; i < 1000; i++) {
            Pose2d a = any();
            Pose2d b = any();
            Pose2d c = any();
            assertNear(a.compose(b).compose(c), a.compose(b.compose(c)));
        }
    }

    @Test
    void theInverseUndoes() {
        for (int i = 0; i < 1000; i++) {
            Pose2d pose = any();
            assertNear(pose.compose(pose.inverse()), Pose2d.ORIGIN);
            assertNear(pose.inverse().compose(pose), Pose2d.ORIGIN);
            assertNear(pose.inverse().inverse(), pose);
            assertNear(pose.compose(Pose2d.ORIGIN), pose);
        }
    }

    @Test
    void transformingAPointIsComposingItsPlace() {
        for (int i = 0; i < 1000; i++) {
            Pose2d pose = any();
            Pose2d place = any();
            assertThat(pose.transform(place.position()))
                    .isEqualTo(pose.compose(place).position());
        }
    }

    @Test
    void distancesDoNotDependOnTheFrame() {
        for (int i = 0; i < 1000; i++) {
            Pose2d frame = any();
            Pose2d a = any();
            Pose2d b = any();
            assertThat(frame.compose(a).distanceTo(frame.compose(b))).isCloseTo(a.distanceTo(b), within(1e-9));
        }
    }

    @Test
    void bearingAndDistanceLeadThere() {
        for (int i = 0; i < 1000; i++) {
            Pose2d from = any();
            Point2d to = any().position();
            double bearing = from.bearingTo(to);
            Pose2d there = from.compose(Pose2d.polar(from.position().distanceTo(to), bearing));
            assertThat(there.position().distanceTo(to)).isLessThan(1e-9);
        }
    }

    @Test
    void nearnessIsRightAcrossPi() {
        Pose2d a = Pose2d.ofDegrees(0, 0, 179);
        Pose2d b = Pose2d.ofDegrees(0.1, 0, -179);
        assertThat(a.isNear(b, 0.2, Math.toRadians(3))).isTrue();
        assertThat(a.isNear(b, 0.2, Math.toRadians(1))).isFalse();
        assertThat(a.isNear(b, 0.05, Math.toRadians(3))).isFalse();
        assertThat(a.isNear(new Pose2d(Double.NaN, 0, 0), 1, 4)).isFalse();
    }

    @Test
    void headingsAreWrappedAndOddOnesAreNotFinite() {
        assertThat(Pose2d.ofDegrees(0, 0, 450).theta()).isCloseTo(Math.PI / 2, within(1e-12));
        assertThat(new Pose2d(0, 0, Double.POSITIVE_INFINITY).isFinite()).isFalse();
        assertThat(new Pose2d(0, Double.NaN, 0).isFinite()).isFalse();
        assertThat(any().isFinite()).isTrue();
    }

    @Test
    void betweenTwoPosesItTurnsTheShorterWay() {
        Pose2d here = Pose2d.ofDegrees(1, 2, 170);
        Pose2d there = Pose2d.ofDegrees(3, -2, -170);
        assertNear(here.towards(there, 0), here);
        assertNear(here.towards(there, 1), there);
        assertNear(here.towards(there, 0.25), Pose2d.ofDegrees(1.5, 1, 175));
    }

    private Pose2d any() {
        return new Pose2d(random.nextDouble(-50, 50), random.nextDouble(-50, 50), random.nextDouble(-9, 9));
    }

    private static void assertNear(Pose2d is, Pose2d expected) {
        assertThat(is.isNear(expected, 1e-9, 1e-9))
                .as("%s, expected %s", is, expected)
                .isTrue();
    }
}
