package rsal.navigation.vfh;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import rsal.data.Footprint;
import rsal.data.Point2d;
import rsal.data.Pose2d;
import rsal.data.Twist2d;
import rsal.navigation.avoid.ContactGuard;
import rsal.navigation.avoid.DriveLimits;
import rsal.navigation.avoid.LocalPlanner.Motion;
import rsal.navigation.avoid.LocalPlanner.Target;
import rsal.navigation.avoid.Obstacles;

class VfhTest {
    private static final Footprint BOX = Footprint.box(0.44, 0.38, new Point2d(-0.04, 0));
    private static final DriveLimits LIMITS = new DriveLimits(0.4, 1.2, 0.8, 3);
    private static final double BEAT = 0.1;

    private final Vfh vfh = new Vfh(BOX, LIMITS, new Vfh.Settings(1.4, 0.1, 0.3), 0.2);
    private final Obstacles obstacles = new Obstacles(3);

    @Test
    void nothingAroundItGoesStraightAtFullSpeed() {
        assertThat(drive(obstacles, 0, 3, false, 0.7)).isEqualTo(Twist2d.drive(0.4, 0));
    }

    @Test
    void turnsOnTheSpotToWhatIsBehind() {
        Twist2d command = drive(obstacles, 2.5, 3, false, 0);
        assertThat(command.vx()).isZero();
        assertThat(command.omega()).isCloseTo(1.2, within(1e-9));
    }

    @Test
    void passesAPostOnTheSideOfTheTarget() {
        obstacles.add(0.8, 0.05);
        assertThat(drive(obstacles, -0.1, 3, false, 0).omega()).isNegative();
        vfh.reset();
        assertThat(drive(obstacles, 0.2, 3, false, 0).omega()).isPositive();
    }

    @Test
    void keepsToTheSideItChose() {
        obstacles.add(0.8, 0);
        double first = drive(obstacles, 0.02, 3, false, 0).omega();
        double second = drive(obstacles, -0.02, 3, false, 0).omega();
        assertThat(Math.signum(second)).isEqualTo(Math.signum(first));
    }

    @Test
    void whatLiesBehindTheTargetDoesNotMatter() {
        obstacles.add(1.3, 0);
        assertThat(drive(obstacles, 0, 0.6, false, 0).omega()).isCloseTo(0, within(1e-9));
    }

    @Test
    void goesSlowlyThroughADoor() {
        wall(1.2, 0.45, 2);
        wall(1.2, -2, -0.45);
        Twist2d open = drive(new Obstacles(3), 0, 2, false, 0);
        wall(0.05, 0.36, 0.4);
        wall(0.05, -0.4, -0.36);
        Twist2d narrow = drive(obstacles, 0, 2, false, 0);
        assertThat(narrow.omega()).isCloseTo(0, within(0.1));
        assertThat(narrow.vx()).isBetween(0.05, 0.7 * open.vx());
    }

    @Test
    void stopsWhereNoDirectionIsOpen() {
        for (int i = 0; i < 360; i += 3) {
            obstacles.add(0.6 * Math.cos(Math.toRadians(i)), 0.6 * Math.sin(Math.toRadians(i)));
        }
        assertThat(drive(obstacles, 0, 3, false, 0)).isEqualTo(Twist2d.STOP);
    }

    @Test
    void comesToRestAtTheTarget() {
        assertThat(drive(obstacles, 0, 0.05, true, 0).vx()).isBetween(0.05, 0.25);
    }

    /// Drives a robot with the dynamics of its limits among random posts, for a minute each.
    @ParameterizedTest
    @ValueSource(longs = {1, 2, 3, 4, 5, 6, 7, 8, 9, 10})
    void neverTouchesAnything(long seed) {
        var random = new SplittableRandom(seed);
        var posts = new Point2d[60];
        for (int i = 0; i < posts.length; i++) {
            double angle = random.nextDouble(2 * Math.PI);
            posts[i] = Pose2d.polar(random.nextDouble(0.4, 5), angle).position();
        }
        var body = new ContactGuard(BOX, LIMITS, 0, BEAT);
        Pose2d pose = Pose2d.ORIGIN;
        Twist2d velocity = Twist2d.STOP;
        Point2d target = new Point2d(3, 0);
        double way = 0;
        for (int beat = 0; beat < 600; beat++) {
            if (pose.position().distanceTo(target) < 0.3 || beat % 150 == 0) {
                target = new Point2d(random.nextDouble(-4, 4), random.nextDouble(-4, 4));
            }
            Pose2d baseFromWorld = pose.inverse();
            obstacles.clear();
            for (Point2d post : posts) {
                Point2d seen = baseFromWorld.transform(post);
                obstacles.add(seen.x(), seen.y());
            }
            Twist2d command =
                    vfh.drive(obstacles, Target.at(baseFromWorld.transform(target), true), new Motion(pose, velocity));
            for (int part = 0; part < 10; part++) {
                velocity = Twist2d.drive(
                        approach(velocity.vx(), command.vx(), LIMITS.acceleration() * BEAT / 10),
                        approach(velocity.omega(), command.omega(), LIMITS.turnAcceleration() * BEAT / 10));
                pose = pose.compose(new Pose2d(velocity.vx() * BEAT / 10, 0, velocity.omega() * BEAT / 10));
                way += Math.abs(velocity.vx()) * BEAT / 10;
                Pose2d bodyFromWorld = pose.inverse();
                for (Point2d post : posts) {
                    Point2d seen = bodyFromWorld.transform(post);
                    assertThat(body.distance(seen.x(), seen.y()))
                            .as("seed %d, beat %d, post %s seen at %s", seed, beat, post, seen)
                            .isPositive();
                }
            }
        }
        assertThat(way).as("way made with seed %d", seed).isGreaterThan(0.5);
    }

    private Twist2d drive(Obstacles around, double bearing, double distance, boolean arriving, double heading) {
        var target = Target.at(Pose2d.polar(distance, bearing).position(), arriving);
        return vfh.drive(around, target, new Motion(new Pose2d(0, 0, heading), Twist2d.STOP));
    }

    private void wall(double x, double fromY, double toY) {
        for (double y = fromY; y <= toY; y += 0.05) {
            obstacles.add(x, y);
        }
    }

    private static double approach(double from, double to, double most) {
        return from + Math.clamp(to - from, -most, most);
    }
}
