package rsal.navigation.avoid;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import org.junit.jupiter.api.Test;
import rsal.data.Pose2d;
import rsal.data.Twist2d;
import rsal.navigation.avoid.Controller.Motion;
import rsal.navigation.avoid.MultiPointTurn.Leg;

/// Legs driven by a robot that does at once what it is told.
class ShuntTest {
    private static final double STEP = 0.05; // s

    private static Pose2d driven(List<Leg> legs, Pose2d from) {
        var shunt = new Shunt(legs, 0.1, from);
        Pose2d pose = from;
        double time = 0;
        while (true) {
            Twist2d command = shunt.drive(new Motion(pose, Twist2d.STOP));
            if (shunt.done()) {
                assertThat(command).isEqualTo(Twist2d.STOP);
                assertThat(time).isLessThanOrEqualTo(2 * shunt.seconds());
                return pose;
            }
            assertThat(Math.abs(command.vx())).isLessThanOrEqualTo(0.1);
            assertThat(time).as("it ends").isLessThan(100);
            double turn = command.omega() * STEP;
            pose = pose.compose(new Pose2d(0, 0, turn / 2))
                    .compose(new Pose2d(command.vx() * STEP, 0, 0))
                    .compose(new Pose2d(0, 0, turn / 2));
            time += STEP;
        }
    }

    @Test
    void drivesALegAheadAndBack() {
        Pose2d from = new Pose2d(1, 2, 0.5);
        Pose2d ahead = driven(List.of(new Leg(0.3, 0)), from);
        assertThat(ahead.distanceTo(from.compose(new Pose2d(0.3, 0, 0)))).isLessThan(0.01);
        Pose2d back = driven(List.of(new Leg(-0.3, 0)), from);
        assertThat(back.distanceTo(from.compose(new Pose2d(-0.3, 0, 0)))).isLessThan(0.01);
    }

    @Test
    void turnsInPlaceToBothSides() {
        for (double angle : new double[] {1, -2}) {
            Pose2d turned = driven(List.of(new Leg(0, angle)), new Pose2d(1, 2, 0.5));
            assertThat(turned.theta()).isCloseTo(0.5 + angle, within(Math.toRadians(2)));
            assertThat(turned.position()).isEqualTo(new Pose2d(1, 2, 0).position());
        }
    }

    /// An arc of 0.4 m that turns by 0.8 rad has the radius 0.5 m.
    @Test
    void drivesArcsEvenly() {
        for (double side : new double[] {1, -1}) {
            Pose2d end = driven(List.of(new Leg(0.4, side * 0.8)), Pose2d.ORIGIN);
            assertThat(end.x()).isCloseTo(0.5 * Math.sin(0.8), within(0.02));
            assertThat(end.y()).isCloseTo(side * 0.5 * (1 - Math.cos(0.8)), within(0.02));
            assertThat(end.theta()).isCloseTo(side * 0.8, within(0.05));
        }
    }

    @Test
    void drivesLegsOneAfterTheOther() {
        Pose2d end = driven(List.of(new Leg(0.2, 0), new Leg(0, Math.PI / 2), new Leg(-0.1, 0)), Pose2d.ORIGIN);
        assertThat(end.x()).isCloseTo(0.2, within(0.02));
        assertThat(end.y()).isCloseTo(-0.1, within(0.02));
    }

    /// A second for each leg, and as long as its way at 0.1 m/s or its turn at 0.5 rad/s takes.
    @Test
    void saysHowLongItTakes() {
        var shunt = new Shunt(List.of(new Leg(0.3, 0.1), new Leg(-0.1, 1), new Leg(0, -0.25)), 0.1, Pose2d.ORIGIN);
        assertThat(shunt.seconds()).isCloseTo(1 + 3 + 1 + 2 + 1 + 0.5, within(1e-9));
    }

    private static Twist2d first(Leg leg, Pose2d began, Pose2d now) {
        var shunt = new Shunt(List.of(leg), 0.1, began);
        assertThat(shunt.drive(new Motion(began, Twist2d.STOP))).isNotEqualTo(Twist2d.STOP);
        return shunt.drive(new Motion(now, Twist2d.STOP));
    }

    /// v as told, ω = v · turn / length + 2 · what is missing to the turn that is due after this much of the
    /// way.
    @Test
    void steersBackOntoItsArc() {
        Pose2d began = new Pose2d(1, 2, 3);
        for (double length : new double[] {0.4, -0.4}) {
            for (double off : new double[] {0, 0.05, -0.05}) {
                Pose2d now = new Pose2d(1.06, 2.08, 3 + off); // a quarter of the way
                Twist2d command = first(new Leg(length, 0.8), began, now);
                assertThat(command.vx()).isEqualTo(Math.copySign(0.1, length));
                assertThat(command.omega()).isCloseTo(0.1 * 0.8 / 0.4 + 2 * (0.25 * 0.8 - off), within(1e-9));
            }
        }
    }

    /// In place by 2 · what is missing, at most 0.5 rad/s.
    @Test
    void turnsInPlaceTheSlowerTheLessIsMissing() {
        Pose2d began = new Pose2d(1, 2, 3);
        for (double turn : new double[] {1, -1, 0.1, -0.1, 0.04, -0.04}) {
            Twist2d command = first(new Leg(0, turn), began, began);
            assertThat(command.vx()).isZero();
            assertThat(command.omega()).isCloseTo(Math.clamp(2 * turn, -0.5, 0.5), within(1e-9));
        }
        var there = new Shunt(List.of(new Leg(0, 0.03)), 0.1, began);
        assertThat(there.drive(new Motion(began, Twist2d.STOP)))
                .as("2° are near enough")
                .isEqualTo(Twist2d.STOP);
        assertThat(there.done()).isTrue();
    }

    /// What one leg turned too little or too far the next one makes up for.
    @Test
    void eachLegBeginsWhereTheOneBeforeShouldHaveEnded() {
        var shunt = new Shunt(List.of(new Leg(0.2, 0.4), new Leg(-0.5, 0)), 0.1, Pose2d.ORIGIN);
        shunt.drive(new Motion(Pose2d.ORIGIN, Twist2d.STOP));
        Twist2d back = shunt.drive(new Motion(new Pose2d(0.2, 0, 0.3), Twist2d.STOP));
        assertThat(back.vx()).isEqualTo(-0.1);
        assertThat(back.omega()).isCloseTo(2 * 0.1, within(1e-9));
        Twist2d on = shunt.drive(new Motion(new Pose2d(-0.29, 0, 0.4), Twist2d.STOP));
        assertThat(on.vx()).as("0.49 m of it").isEqualTo(-0.1);
        assertThat(shunt.done()).isFalse();
        assertThat(shunt.drive(new Motion(new Pose2d(-0.301, 0, 0.4), Twist2d.STOP)))
                .isEqualTo(Twist2d.STOP);
        assertThat(shunt.done()).isTrue();
    }
}
