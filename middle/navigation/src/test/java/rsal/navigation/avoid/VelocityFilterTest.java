package rsal.navigation.avoid;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import rsal.data.Footprint;
import rsal.data.Point2d;
import rsal.data.Pose2d;
import rsal.data.Twist2d;
import rsal.navigation.avoid.Controller.Motion;
import rsal.navigation.avoid.Controller.Target;

class VelocityFilterTest {
    private static final Footprint BOX = Footprint.box(0.6, 0.4, new Point2d(0, 0));
    private static final DriveLimits LIMITS = new DriveLimits(0.8, 1.2, 0.5, 2);
    private static final Motion STANDING = new Motion(Pose2d.ORIGIN, Twist2d.STOP);

    private final VelocityFilter filter = new VelocityFilter(BOX, LIMITS, 0.2);
    private final Obstacles nothing = new Obstacles(5);

    /// v = v_max share (1 - |d| / 90°), ω = ω_max d / 90°; not beyond 90°.
    @Test
    void drivesTheSlowerTheMoreItHasToTurn() {
        Target far = Target.at(new Point2d(5, 0), false);
        for (double share : new double[] {0.3, 1}) {
            for (double degrees = -170; degrees <= 170; degrees += 17) {
                double turn = Math.clamp(Math.toRadians(degrees), -Math.PI / 2, Math.PI / 2);
                Twist2d command = filter.towards(Math.toRadians(degrees), share, far, STANDING, nothing);
                assertThat(command.omega()).isCloseTo(1.2 * turn / (Math.PI / 2), within(1e-12));
                assertThat(command.vx()).isCloseTo(0.8 * share * (1 - Math.abs(turn) / (Math.PI / 2)), within(1e-12));
            }
        }
    }

    @Test
    void arrivesNoFasterThanItCanStop() {
        for (double distance : new double[] {0.1, 0.5, 1, 5}) {
            Target there = Target.at(new Point2d(distance, 0), true);
            assertThat(filter.towards(0, 1, there, STANDING, nothing).vx())
                    .isCloseTo(Math.min(0.8, Math.sqrt(0.5 * distance)), within(1e-12));
        }
    }

    /// ω = 2 angle per second, at most ω_max and √(α |angle|).
    @Test
    void turnsInPlaceSoThatItStopsAtTheAngle() {
        for (double angle = -3; angle <= 3; angle += 0.13) {
            double most = Math.min(1.2, Math.sqrt(2 * Math.abs(angle)));
            Twist2d command = filter.turn(angle, Twist2d.STOP, nothing);
            assertThat(command.vx()).isZero();
            assertThat(command.omega()).isCloseTo(Math.clamp(2 * angle, -most, most), within(1e-12));
        }
    }

    @Test
    void whatIsMirroredIsMirrored() {
        var random = new SplittableRandom(3);
        int stopped = 0;
        for (int draw = 0; draw < 500; draw++) {
            var here = new Obstacles(5);
            var mirrored = new Obstacles(5);
            for (int i = 0; i < 6; i++) {
                double x = random.nextDouble(-0.8, 1.2);
                double y = random.nextDouble(-0.8, 0.8);
                here.add(x, y);
                mirrored.add(x, -y);
            }
            Twist2d wanted = Twist2d.drive(random.nextDouble(-0.5, 0.8), random.nextDouble(-1, 1));
            Twist2d velocity = Twist2d.drive(random.nextDouble(-0.3, 0.8), random.nextDouble(-1, 1));
            Twist2d one = filter.guarded(wanted, velocity, here);
            Twist2d other = filter.guarded(
                    Twist2d.drive(wanted.vx(), -wanted.omega()),
                    Twist2d.drive(velocity.vx(), -velocity.omega()),
                    mirrored);
            assertThat(other.vx()).as("draw %d", draw).isEqualTo(one.vx());
            assertThat(other.omega()).as("draw %d", draw).isEqualTo(0.0 - one.omega());
            stopped += one.equals(wanted) ? 0 : 1;
        }
        assertThat(stopped).isBetween(50, 450);
    }

    /// Where it is too long to turn, it creeps: ahead when the turn is less than 90°, else back.
    @Test
    void creepsWhereItHasNoRoomToTurn() {
        for (double side : new double[] {1, -1}) {
            var beside = new Obstacles(5);
            beside.add(-0.32, side * -0.24); // behind the rear corner that swings out
            beside.add(0.32, side * 0.24);
            assertThat(new VelocityFilter(BOX, LIMITS, 0.2)
                            .turn(side * 0.7, Twist2d.STOP, beside)
                            .omega())
                    .isZero();
            assertThat(new VelocityFilter(BOX, LIMITS, 0.2)
                            .turn(side * 0.7, Twist2d.STOP, beside)
                            .vx())
                    .isEqualTo(0.08);
            assertThat(new VelocityFilter(BOX, LIMITS, 0.2)
                            .turn(side * 2.5, Twist2d.STOP, beside)
                            .vx())
                    .isEqualTo(-0.08);
            assertThat(new VelocityFilter(BOX, LIMITS, 0.2)
                            .turn(side * 0.05, Twist2d.STOP, beside)
                            .vx())
                    .as("not worth creeping for")
                    .isZero();
        }
    }

    /// Of a body whose rear is wider than the circle that fits into it.
    @Test
    void bodiesThatAreWiderThanTheirCircleNeedTheirWidth() {
        assertThat(VelocityFilter.room(BOX, 0.3)).isEqualTo(0.3);
        Footprint wide = Footprint.box(0.2, 0.8, new Point2d(0, 0)); // its circle is 0.1 m
        assertThat(VelocityFilter.room(wide, 0.1)).isCloseTo(0.4 + 0.04 - 0.1, within(1e-12));
        assertThat(VelocityFilter.room(wide, 0.02)).isCloseTo(0.4 + 0.02 - 0.1, within(1e-12));
        assertThat(VelocityFilter.room(wide, 0.9)).isEqualTo(0.9);
    }

    /// Where what it let through leads within 2 s: on its arc, and no farther than it is told.
    @Test
    void saysWhereItsLastCommandLeads() {
        assertThat(filter.predictedTrajectory()).isEmpty();
        Target far = Target.at(new Point2d(5, 0), false);
        filter.towards(0, 1, far, STANDING, nothing);
        assertThat(filter.predictedTrajectory().getFirst()).isEqualTo(new Point2d(0, 0));
        assertThat(filter.predictedTrajectory().getLast().x()).isCloseTo(1.6, within(0.01)); // 0.8 m/s
        filter.upTo(0.5);
        assertThat(filter.predictedTrajectory().getLast().x()).isCloseTo(0.5, within(0.01));
        Target near = Target.at(new Point2d(0.3, 0), true);
        filter.towards(0, 1, near, STANDING, nothing);
        assertThat(filter.predictedTrajectory().getLast().x()).isCloseTo(0.3, within(0.01));
        filter.towards(0, 1, far, STANDING, nothing);
        filter.arrivesAt(far);
        assertThat(filter.predictedTrajectory().getLast().x())
                .as("it goes on there")
                .isCloseTo(1.6, within(0.01));
        filter.stands();
        assertThat(filter.predictedTrajectory()).isEmpty();
        filter.guarded(Twist2d.drive(0.5, 0), Twist2d.STOP, nothing);
        assertThat(filter.predictedTrajectory().getLast().x()).isCloseTo(1, within(0.01));
        filter.reset();
        assertThat(filter.predictedTrajectory()).isEmpty();
    }

    private static Obstacles beside(double... more) {
        var beside = new Obstacles(5);
        beside.add(-0.32, -0.24); // behind the rear corner that swings out
        beside.add(0.32, 0.24);
        for (int i = 0; i < more.length; i += 2) {
            beside.add(more[i], more[i + 1]);
        }
        return beside;
    }

    /// It creeps on the way it began, until it can't, or can turn, or is told to forget it.
    @Test
    void goesOnCreepingTheWayItBegan() {
        assertThat(filter.turn(0.7, Twist2d.STOP, beside()).vx()).isEqualTo(0.08);
        assertThat(filter.turn(2.5, Twist2d.STOP, beside()).vx())
                .as("as before")
                .isEqualTo(0.08);
        filter.reset();
        assertThat(filter.turn(2.5, Twist2d.STOP, beside()).vx()).isEqualTo(-0.08);
        assertThat(filter.turn(0.7, Twist2d.STOP, beside()).vx())
                .as("as before")
                .isEqualTo(-0.08);
        assertThat(filter.turn(0.7, Twist2d.STOP, nothing).omega())
                .as("it can turn")
                .isPositive();
        assertThat(filter.turn(0.7, Twist2d.STOP, beside()).vx()).isEqualTo(0.08);
        assertThat(filter.turn(0.05, Twist2d.STOP, beside()).vx())
                .as("it need not turn")
                .isZero();
        assertThat(filter.turn(2.5, Twist2d.STOP, beside()).vx()).isEqualTo(-0.08);
    }

    @Test
    void creepsBackWhereItCanNotCreepOn() {
        Obstacles before = beside(0.35, 0);
        assertThat(filter.turn(0.7, Twist2d.STOP, before).vx()).isEqualTo(-0.08);
        assertThat(filter.turn(0.7, Twist2d.STOP, before).vx())
                .as("and goes on so")
                .isEqualTo(-0.08);
        Twist2d enclosed = filter.turn(0.7, Twist2d.STOP, beside(0.35, 0, -0.36, 0));
        assertThat(enclosed.vx()).isZero();
        assertThat(enclosed.omega()).isZero();
    }

    /// From a right angle on it creeps back.
    @Test
    void aRightAngleIsTurnedToBackward() {
        for (double side : new double[] {1, -1}) {
            var here = new Obstacles(5);
            here.add(-0.32, side * -0.24);
            here.add(0.32, side * 0.24);
            for (double degrees : new double[] {4, 6, 89, 91, 170}) {
                double vx = new VelocityFilter(BOX, LIMITS, 0.2)
                        .turn(side * Math.toRadians(degrees), Twist2d.STOP, here)
                        .vx();
                assertThat(vx).as("%s°", degrees).isEqualTo(degrees < 5 ? 0 : degrees < 90 ? 0.08 : -0.08);
            }
        }
    }
}
