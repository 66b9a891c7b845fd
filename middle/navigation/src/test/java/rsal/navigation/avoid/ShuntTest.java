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
}
