package rsal.navigation.avoid;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import rsal.data.Angles;
import rsal.data.Footprint;
import rsal.data.Point2d;
import rsal.data.Pose2d;
import rsal.data.Twist2d;
import rsal.navigation.avoid.Controller.Motion;
import rsal.navigation.avoid.MultiPointTurn.Leg;

class MultiPointTurnTest {
    private static final Footprint BODY = Footprint.box(0.44, 0.38, new Point2d(-0.04, 0));
    private static final FootprintOutline OUTLINE = new FootprintOutline(BODY, 0);
    private static final DriveLimits LIMITS = new DriveLimits(0.4, 1.2, 0.8, 3);
    private static final double LEAST = 0.02; // m that stay
    private static final double ROUNDING = 0.007; // m; places between those that were looked at

    private final MultiPointTurn shunting = new MultiPointTurn(BODY, LIMITS, 0.2);
    private final Obstacles obstacles = new Obstacles(5);

    @Test
    void turnsInPlaceWhereThereIsRoom() {
        List<Leg> legs = shunting.search(obstacles, 2, 0.3).get().orElseThrow();
        assertThat(legs).singleElement().satisfies(leg -> {
            assertThat(leg.meters()).isZero();
            assertThat(leg.radians()).isBetween(2 - Math.toRadians(11), 2.0);
        });
    }

    /// A dead end so narrow that its tail would touch.
    @Test
    void drivesBackOutOfADeadEndToTurn() {
        wall(-0.15, 0.25, 0.25, 0.25);
        wall(0.25, 0.25, 0.25, -0.25);
        wall(0.25, -0.25, -0.15, -0.25);
        List<Leg> legs = shunting.search(obstacles, Math.PI, 0.3).get().orElseThrow();
        assertThat(legs).anyMatch(leg -> leg.meters() < 0);
        assertKeepsRoom(legs);
        assertThat(Math.abs(Angles.difference(end(legs).theta(), Math.PI))).isLessThan(Math.toRadians(10.1));
    }

    @Test
    void findsNothingWhereThereIsNothing() {
        wall(-0.3, 0.23, 0.22, 0.23);
        wall(0.22, 0.23, 0.22, -0.23);
        wall(0.22, -0.23, -0.3, -0.23);
        wall(-0.3, -0.23, -0.3, 0.23);
        assertThat(shunting.search(obstacles, Math.PI, 0.3).get()).isEmpty();
    }

    @Test
    void neverDrivesBackWhereSomebodyMayCome() {
        wall(-0.15, 0.25, 0.25, 0.25);
        wall(0.25, 0.25, 0.25, -0.25);
        wall(0.25, -0.25, -0.15, -0.25);
        obstacles.add(-0.8, 0);
        obstacles.keepRoom(obstacles.count() - 1, 0.1);
        assertThat(shunting.search(obstacles, Math.PI, 0.3).get()).isEmpty();
    }

    @Test
    void touchesNothingOnItsWayAndCanGoOnAtItsEnd() {
        int found = 0;
        for (long seed = 0; seed < 60; seed++) {
            var random = new SplittableRandom(seed);
            obstacles.clear();
            for (int i = 0; i < 5; i++) {
                scatter(random);
            }
            double angle = random.nextDouble(-Math.PI, Math.PI);
            Optional<List<Leg>> legs = shunting.search(obstacles, angle, 0.3).get();
            if (legs.isPresent()) {
                found++;
                assertKeepsRoom(legs.get());
                Pose2d end = end(legs.get());
                assertThat(Math.abs(Angles.difference(end.theta(), angle)))
                        .as("seed %d", seed)
                        .isLessThan(Math.toRadians(10.1));
                assertKeepsRoom(List.of(new Leg(0.3, 0)), end);
            }
        }
        assertThat(found).isBetween(15, 58);
    }

    /// A piece of wall somewhere around, not into the robot.
    private void scatter(SplittableRandom random) {
        double direction = random.nextDouble(-Math.PI, Math.PI);
        double distance = random.nextDouble(0.2, 0.5);
        double along = random.nextDouble(0.05, 0.3);
        for (double t = -along; t <= along; t += 0.03) {
            double x = distance * Math.cos(direction) - t * Math.sin(direction);
            double y = distance * Math.sin(direction) + t * Math.cos(direction);
            if (OUTLINE.distance(x, y) > 0.015) {
                obstacles.add(x, y);
            }
        }
    }

    @Test
    void isDrivenAsItWasFound() {
        wall(-0.15, 0.25, 0.25, 0.25);
        wall(0.25, 0.25, 0.25, -0.25);
        wall(0.25, -0.25, -0.15, -0.25);
        List<Leg> legs = shunting.search(obstacles, Math.PI, 0.3).get().orElseThrow();
        var shunt = new Shunt(legs, 0.1, new Pose2d(3, -2, 1));
        var odomFromBase = new Pose2d(3, -2, 1);
        Twist2d velocity = Twist2d.STOP;
        double seconds = 0;
        while (!shunt.done()) {
            velocity = shunt.drive(new Motion(odomFromBase, velocity));
            odomFromBase = odomFromBase.compose(
                    new Pose2d(0.1 * velocity.vx(), 0, 0.1 * velocity.omega())); // short enough for a chord
            seconds += 0.1;
            assertThat(seconds).isLessThan(2 * shunt.seconds());
        }
        Pose2d there = new Pose2d(3, -2, 1).compose(end(legs));
        assertThat(odomFromBase.distanceTo(there)).isLessThan(0.06);
        assertThat(Angles.difference(odomFromBase.theta(), there.theta())).isBetween(-0.1, 0.1);
        assertThat(shunt.drive(new Motion(odomFromBase, velocity))).isEqualTo(Twist2d.STOP);
    }

    private void wall(double fromX, double fromY, double toX, double toY) {
        int points = (int) Math.ceil(Math.hypot(toX - fromX, toY - fromY) / 0.04);
        for (int i = 0; i <= points; i++) {
            double t = (double) i / points;
            obstacles.add(fromX + t * (toX - fromX), fromY + t * (toY - fromY));
        }
    }

    private void assertKeepsRoom(List<Leg> legs) {
        assertKeepsRoom(legs, Pose2d.ORIGIN);
    }

    private void assertKeepsRoom(List<Leg> legs, Pose2d from) {
        for (Pose2d pose : poses(legs, from)) {
            for (int i = 0; i < obstacles.count(); i++) {
                Point2d seen = pose.inverse().transform(obstacles.at(i));
                double least = Math.min(LEAST, OUTLINE.distance(obstacles.x(i), obstacles.y(i)));
                assertThat(OUTLINE.distance(seen.x(), seen.y())).isGreaterThan(least - ROUNDING);
            }
        }
    }

    private static Pose2d end(List<Leg> legs) {
        return poses(legs, Pose2d.ORIGIN).getLast();
    }

    /// Close to each other.
    private static List<Pose2d> poses(List<Leg> legs, Pose2d from) {
        var poses = new ArrayList<Pose2d>(List.of(from));
        for (Leg leg : legs) {
            int steps = (int) Math.ceil(Math.max(Math.abs(leg.meters()) / 0.002, Math.abs(leg.radians()) / 0.01));
            for (int i = 0; i < steps; i++) {
                Pose2d half = poses.getLast().compose(new Pose2d(0, 0, leg.radians() / steps / 2));
                poses.add(half.compose(new Pose2d(leg.meters() / steps, 0, leg.radians() / steps / 2)));
            }
        }
        return poses;
    }
}
