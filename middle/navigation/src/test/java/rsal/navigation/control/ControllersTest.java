package rsal.navigation.control;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.List;
import java.util.ServiceLoader;
import java.util.SplittableRandom;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import rsal.data.Footprint;
import rsal.data.Point2d;
import rsal.data.Pose2d;
import rsal.data.Twist2d;
import rsal.navigation.avoid.Controller;
import rsal.navigation.avoid.Controller.Motion;
import rsal.navigation.avoid.Controller.Target;
import rsal.navigation.avoid.DriveLimits;
import rsal.navigation.avoid.Obstacles;
import rsal.navigation.control.ControllerType.Driven;
import rsal.settings.Arguments;

/// What each controller of the installation owes.
class ControllersTest {
    private static final Driven DRIVEN = new Driven(
            Footprint.box(0.45, 0.38, new Point2d(0, 0)),
            new DriveLimits(0.4, Math.toRadians(70), 10, Math.toRadians(720)),
            1.4,
            0.1,
            0.2);
    private static final double FRONT = 0.225; // m
    private static final double VIEW = 5; // m

    static Stream<ControllerType> controllers() {
        return ServiceLoader.load(ControllerType.class).stream().map(ServiceLoader.Provider::get);
    }

    private static Controller make(ControllerType type) {
        return type.create(Arguments.defaults(type.parameters()), DRIVEN);
    }

    private static Obstacles obstacles(List<Point2d> places) {
        var obstacles = new Obstacles(VIEW);
        places.forEach(place -> obstacles.add(place.x(), place.y()));
        return obstacles;
    }

    private static Motion standing() {
        return new Motion(Pose2d.ORIGIN, Twist2d.STOP);
    }

    private static Target ahead(double x, double y) {
        return new Target(new Point2d(x, y), false, List.of(new Point2d(0, 0), new Point2d(x, y)));
    }

    @Test
    void thereAreFive() {
        assertThat(controllers().map(ControllerType::key)).containsExactlyInAnyOrder("dwa", "mpc", "nd", "snd", "vfh");
    }

    @ParameterizedTest
    @MethodSource("controllers")
    void theySayWhatTheyAre(ControllerType type) {
        assertThat(type.description()).isNotBlank().endsWith(".");
        assertThat(type.refusal(Arguments.defaults(type.parameters()))).isEmpty();
        assertThat(type.view(Arguments.defaults(type.parameters()), DRIVEN)).isPositive();
    }

    @ParameterizedTest
    @MethodSource("controllers")
    void theyDriveAheadWhereNothingIs(ControllerType type) {
        Twist2d command = make(type).drive(obstacles(List.of()), ahead(1.4, 0), standing());
        assertThat(command.vx()).isPositive();
        assertThat(command.omega()).isCloseTo(0, within(0.05));
    }

    @ParameterizedTest
    @MethodSource("controllers")
    void theyTurnToTheSideOfTheTarget(ControllerType type) {
        assertThat(make(type)
                        .drive(obstacles(List.of()), ahead(1, 1), standing())
                        .omega())
                .isPositive();
        assertThat(make(type)
                        .drive(obstacles(List.of()), ahead(1, -1), standing())
                        .omega())
                .isNegative();
        assertThat(make(type).turn(obstacles(List.of()), 1, standing()).omega()).isPositive();
        assertThat(make(type).turn(obstacles(List.of()), -1, standing()).omega())
                .isNegative();
    }

    @ParameterizedTest
    @MethodSource("controllers")
    void theyKeepTheLimits(ControllerType type) {
        for (long seed = 0; seed < 50; seed++) {
            Twist2d command = drive(type, places(seed), ahead(1.2, 0.3));
            assertThat(Math.hypot(command.vx(), command.vy())).isLessThanOrEqualTo(0.4 + 1e-9);
            assertThat(Math.abs(command.omega())).isLessThanOrEqualTo(Math.toRadians(70) + 1e-9);
        }
    }

    /// A wall just ahead over the whole width: what it takes to stop is left.
    @ParameterizedTest
    @MethodSource("controllers")
    void theyDoNotDriveIntoAWall(ControllerType type) {
        var wall = new ArrayList<Point2d>();
        for (double y = -2; y <= 2; y += 0.05) {
            wall.add(new Point2d(FRONT + 0.05, y));
        }
        double speed = drive(type, wall, ahead(1.4, 0)).vx();
        assertThat(speed * DRIVEN.reaction()).isLessThanOrEqualTo(0.05);
    }

    /// Left and right are worth the same: what is mirrored is driven mirrored, but for the width of sectors and
    /// cells by which some look around.
    @ParameterizedTest
    @MethodSource("controllers")
    void whatIsMirroredIsDrivenMirrored(ControllerType type) {
        int same = 0;
        int opposite = 0; // turned to the wrong side
        for (long seed = 0; seed < 200; seed++) {
            List<Point2d> places = places(seed);
            double y = new SplittableRandom(seed).nextDouble(-1, 1);
            Twist2d one = drive(type, places, ahead(1.2, y));
            Twist2d other = drive(
                    type,
                    places.stream()
                            .map(place -> new Point2d(place.x(), -place.y()))
                            .toList(),
                    ahead(1.2, -y));
            opposite += one.omega() * other.omega() > 0.01 ? 1 : 0;
            same += Math.abs(other.vx() - one.vx()) < 0.02 && Math.abs(other.omega() + one.omega()) < 0.1 ? 1 : 0;
        }
        assertThat(opposite).isZero();
        assertThat(same).isGreaterThanOrEqualTo(150); // mpc plans on a grid; of the others it is all
    }

    private static Twist2d drive(ControllerType type, List<Point2d> places, Target target) {
        return make(type).drive(obstacles(places), target, standing());
    }

    /// A few posts around the robot.
    private static List<Point2d> places(long seed) {
        var random = new SplittableRandom(seed);
        var places = new ArrayList<Point2d>();
        for (int i = random.nextInt(1, 6); i > 0; i--) {
            double angle = random.nextDouble(-2.5, 2.5);
            double range = random.nextDouble(0.6, 3);
            places.add(new Point2d(range * Math.cos(angle), range * Math.sin(angle)));
        }
        return places;
    }
}
