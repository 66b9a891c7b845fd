package rsal.navigation.avoid;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import rsal.data.Footprint;
import rsal.data.OccupancyGrid;
import rsal.data.Path2d;
import rsal.data.Point2d;
import rsal.data.Pose2d;
import rsal.data.RangeArray;
import rsal.data.Twist2d;
import rsal.navigation.avoid.Controller.Motion;
import rsal.navigation.avoid.Controller.Target;
import rsal.navigation.grid.DistanceField;
import rsal.navigation.wavefront.CostMap;
import rsal.navigation.wavefront.CostMap.Clearance;
import rsal.navigation.wavefront.Plan;
import rsal.navigation.wavefront.Route;
import rsal.navigation.wavefront.Wavefront;
import rsal.testkit.DrawnMap;
import rsal.testkit.Trials;

/// What every controller keeps to.
public abstract class ControllerContract {
    protected static final DriveLimits LIMITS = new DriveLimits(0.6, 1.5, 0.8, 3);
    protected static final Footprint BOX = Footprint.box(0.44, 0.38, new Point2d(-0.04, 0));
    private static final Footprint WEDGE =
            new Footprint(List.of(new Point2d(0.4, 0), new Point2d(-0.3, 0.25), new Point2d(-0.3, -0.25)));
    private static final double BEAT = 0.1;
    private static final double VIEW = 3;
    private static final double LOOKAHEAD = 1.4;
    private static final DrawnMap NOOK = DrawnMap.grid(0.1, """
            ..................................................
            ..................................................
            ..................................................
            ..................................................
            ..................................................
            ..................................................
            ..................................................
            ..................................................
            ..................................................
            ..................................................
            ..................................................
            ..................................................
            ..................................................
            .............#####################................
            .................................#................
            .................................#................
            .................................#................
            .................................#................
            .................................#................
            .................................#................
            .................................#................
            .................................#................
            .................................#................
            .........................a.......#.......b........
            .................................#................
            .................................#................
            .................................#................
            .................................#................
            .................................#................
            .................................#................
            .................................#................
            .................................#................
            .................................#................
            .............#####################................
            ..................................................
            ..................................................
            ..................................................
            ..................................................
            ..................................................
            ..................................................
            ..................................................
            ..................................................
            ..................................................
            ..................................................
            ..................................................
            ..................................................""");

    protected abstract Controller planner(Footprint footprint, double reaction, double beat);

    private Controller planner(Footprint footprint) {
        return planner(footprint, 2 * BEAT, BEAT);
    }

    @Test
    void nothingAroundItGoesAhead() {
        Drive drive = new Drive(BOX, List.of());
        drive.goTo(new Point2d(4, 0), 12);
        assertThat(drive.pose.x()).isGreaterThan(3.5);
        assertThat(drive.fastest).isGreaterThan(0.55);
    }

    @ParameterizedTest
    @ValueSource(ints = {1, 2, 3})
    void turnsWithItsWorld(int quarters) {
        double angle = quarters * Math.PI / 2;
        var obstacles = new Obstacles(VIEW);
        obstacles.add(1.1, 0.1);
        obstacles.add(0.9, -0.6);
        Target target = Target.at(new Point2d(2, 0.5), false);
        var motion = new Motion(new Pose2d(0.01, 0.01, 0.1), Twist2d.drive(0.2, 0));
        var turned = new Motion(new Pose2d(0, 0, angle).compose(motion.odomFromBase()), Twist2d.drive(0.2, 0));
        Twist2d one = planner(BOX).drive(obstacles, target, motion);
        Twist2d other = planner(BOX).drive(obstacles, target, turned);
        assertThat(other.vx()).isCloseTo(one.vx(), within(1e-6));
        assertThat(other.omega()).isCloseTo(one.omega(), within(1e-6));
    }

    @Test
    void reportsThePathThatItMeansToTake() {
        Controller planner = planner(BOX);
        assertThat(planner.predictedTrajectory()).isEmpty();
        var nothing = new Obstacles(VIEW);
        var target = new Point2d(2, 0.5);
        var motion = new Motion(new Pose2d(3, 4, 1), Twist2d.drive(0.3, 0));
        planner.drive(nothing, Target.at(target, false), motion);
        List<Point2d> prediction = planner.predictedTrajectory();
        assertThat(prediction.getLast().distanceTo(target)).isLessThan(new Point2d(0, 0).distanceTo(target) - 0.3);
        assertThat(prediction.getLast().y()).isPositive();
        planner.drive(nothing, Target.at(new Point2d(0.25, 0), true), motion);
        assertThat(new Path2d(planner.predictedTrajectory()).length()).isBetween(0.05, 0.3);
        planner.turn(nothing, 1, motion);
        assertThat(planner.predictedTrajectory()).isEmpty();
        planner.drive(nothing, Target.at(target, false), motion);
        planner.guarded(nothing, Twist2d.drive(-0.1, 0), motion);
        assertThat(planner.predictedTrajectory().getLast().distanceTo(new Point2d(-0.2, 0)))
                .isLessThan(1e-9);
        planner.reset();
        assertThat(planner.predictedTrajectory()).isEmpty();
    }

    @Test
    void passesAPost() {
        Drive drive = new Drive(BOX, List.of(new Point2d(1.5, 0.1), new Point2d(1.5, 0), new Point2d(1.5, -0.1)));
        drive.goTo(new Point2d(3.5, 0), 40);
        assertThat(drive.pose.position().distanceTo(new Point2d(3.5, 0))).isLessThan(0.4);
    }

    /// Cones say how far things are, and no more than roughly where.
    @Test
    void passesAPostBySonarsAlone() {
        Drive drive = new Drive(BOX, List.of(new Point2d(1.5, 0.1), new Point2d(1.5, 0), new Point2d(1.5, -0.1)));
        drive.sonars = 16;
        drive.goTo(new Point2d(3.5, 0), 60);
        assertThat(drive.pose.position().distanceTo(new Point2d(3.5, 0))).isLessThan(0.4);
    }

    @Trials(
            value = {"1", "2", "3", "4"},
            landing = 1)
    void touchesNothingBySonarsAlone(long seed) {
        var random = new SplittableRandom(seed);
        var posts = new ArrayList<Point2d>();
        for (int i = 0; i < 20; i++) {
            posts.addAll(drum(Pose2d.polar(random.nextDouble(0.9, 5), random.nextDouble(2 * Math.PI))));
        }
        Drive drive = new Drive(BOX, posts);
        drive.sonars = 16;
        for (int goal = 0; goal < 4; goal++) {
            drive.goTo(new Point2d(random.nextDouble(-4, 4), random.nextDouble(-4, 4)), 15);
        }
        assertThat(drive.prediction).as("way made with seed %d", seed).isGreaterThan(0.5);
    }

    /// Drives among drums and sees whether the ways that it tells lead through one: for planners that know theirs to be
    /// free not only as far as they need to stop.
    ///
    /// @param inside how far a drum may reach into the outline on such a way [m]
    protected void assertReportsFreePaths(long seed, double inside) {
        var random = new SplittableRandom(seed);
        var drums = new ArrayList<Point2d>();
        for (int i = 0; i < 25; i++) {
            drums.addAll(drum(Pose2d.polar(random.nextDouble(0.9, 5), random.nextDouble(2 * Math.PI))));
        }
        Drive drive = new Drive(seed % 2 == 0 ? BOX : WEDGE, drums);
        drive.inside = inside;
        for (int goal = 0; goal < 4; goal++) {
            drive.goTo(new Point2d(random.nextDouble(-4, 4), random.nextDouble(-4, 4)), 15);
        }
        assertThat(drive.freeWays).as("ways told with seed %d", seed).isGreaterThan(20);
    }

    /// The rim of one of 0.2 m.
    private static List<Point2d> drum(Pose2d place) {
        return IntStream.range(0, 24)
                .mapToObj(i -> place.compose(new Pose2d(0, 0, i * Math.PI / 12)).transform(new Point2d(0.1, 0)))
                .toList();
    }

    @Test
    void goesToAPlaceBeforeAWall() {
        var room = new ArrayList<Point2d>();
        for (double along = -2; along <= 2; along += 0.05) {
            room.addAll(List.of(
                    new Point2d(along, 2), new Point2d(along, -2), new Point2d(2, along), new Point2d(-2, along)));
        }
        Drive drive = new Drive(BOX, room);
        drive.goTo(new Point2d(1, -1.3), 30);
        assertThat(drive.pose.position().distanceTo(new Point2d(1, -1.3))).isLessThan(0.35);
    }

    /// It stands before the end of a nook. What it is sent to is right behind that end; the planned way leads back out
    /// and around.
    @Test
    void followsAPlannedWayOutOfADeadEnd() {
        Pose2d start = NOOK.pose('a', 0);
        Point2d goal = NOOK.place('b');
        CostMap map = CostMap.of(NOOK.grid(), DistanceField.toNotFree(NOOK.grid()), new Clearance(0.3, 0.7, 3));
        var plan = (Plan.Found) new Wavefront(map).plan(start.position(), goal, 0);
        Drive drive = new Drive(BOX, walls(NOOK.grid()));
        drive.pose = start;
        drive.along(plan.path(), map, 60);
        assertThat(plan.path().length()).isGreaterThan(3 * start.position().distanceTo(goal));
        assertThat(drive.pose.position().distanceTo(goal)).isLessThan(0.4);
    }

    /// Nine points in each occupied cell.
    private static List<Point2d> walls(OccupancyGrid map) {
        var points = new ArrayList<Point2d>();
        for (int cell = 0; cell < map.cells().length; cell++) {
            Point2d middle = map.middle(cell);
            for (int part = 0; part < 9 && map.cells()[cell] == OccupancyGrid.OCCUPIED; part++) {
                double third = map.resolution() / 3;
                points.add(new Point2d(middle.x() + (part % 3 - 1) * third, middle.y() + (part / 3 - 1) * third));
            }
        }
        return points;
    }

    @Test
    void turnsInPlace() {
        Drive drive = new Drive(WEDGE, List.of());
        for (int beat = 0; beat < 50; beat++) {
            drive.move(drive.planner.turn(drive.look(), 2 - drive.pose.theta(), drive.motion()));
        }
        assertThat(drive.pose.theta()).isCloseTo(2, within(0.05));
        assertThat(drive.pose.position().distanceTo(new Point2d(0, 0))).isLessThan(0.01);
    }

    @Trials(
            value = {"1", "2", "3", "4", "5", "6"},
            landing = 1)
    void neverTouchesAnything(long seed) {
        var random = new SplittableRandom(seed);
        var posts = new ArrayList<Point2d>();
        for (int i = 0; i < 60; i++) {
            posts.add(Pose2d.polar(random.nextDouble(0.6, 5), random.nextDouble(2 * Math.PI))
                    .position());
        }
        Drive drive = new Drive(seed % 2 == 0 ? BOX : WEDGE, posts);
        for (int goal = 0; goal < 4; goal++) {
            drive.goTo(new Point2d(random.nextDouble(-4, 4), random.nextDouble(-4, 4)), 15);
        }
        assertThat(drive.prediction).as("way made with seed %d", seed).isGreaterThan(0.5);
    }

    /// People walk to and fro. They turn around before a robot that is in their way.
    @Trials(
            value = {"1", "2", "3", "4"},
            landing = 1)
    void touchesNobodyWhoWalksAbout(long seed) {
        var random = new SplittableRandom(seed);
        Drive drive = new Drive(seed % 2 == 0 ? BOX : WEDGE, List.of());
        for (int i = 0; i < 6; i++) {
            drive.people.add(new Walker(
                    Pose2d.polar(random.nextDouble(1, 4), random.nextDouble(2 * Math.PI))
                            .position(),
                    Pose2d.polar(random.nextDouble(1, 4), random.nextDouble(2 * Math.PI))
                            .position(),
                    random.nextDouble(0.3, 1.2)));
        }
        for (int goal = 0; goal < 4; goal++) {
            drive.goTo(new Point2d(random.nextDouble(-4, 4), random.nextDouble(-4, 4)), 20);
        }
        assertThat(drive.prediction).as("way made with seed %d", seed).isGreaterThan(0.5);
        assertThat(drive.people).allMatch(person -> person.walked > 2);
    }

    /// Somebody who goes from one place to another and back, again and again.
    private static final class Walker {
        private static final double POLITE = 0.15; // m that is left between them and a robot

        private final double speed; // m/s
        private Point2d at;
        private Point2d to;
        private Point2d from;
        private double walked;

        Walker(Point2d from, Point2d to, double speed) {
            this.at = from;
            this.from = from;
            this.to = to;
            this.speed = speed;
        }

        void walk(double seconds, FootprintOutline robot, Pose2d worldFromRobot) {
            double step = speed * seconds;
            if (at.distanceTo(to) < step) {
                turnAround();
            }
            double share = step / Math.max(step, at.distanceTo(to));
            var next = new Point2d(at.x() + share * (to.x() - at.x()), at.y() + share * (to.y() - at.y()));
            boolean free = outline(next).stream()
                    .map(worldFromRobot.inverse()::transform)
                    .allMatch(point -> robot.distance(point.x(), point.y()) > POLITE);
            if (free) {
                at = next;
                walked += step;
            } else {
                turnAround();
            }
        }

        private void turnAround() {
            Point2d back = from;
            from = to;
            to = back;
        }

        List<Point2d> outline() {
            return outline(at);
        }

        private static List<Point2d> outline(Point2d middle) {
            return drum(new Pose2d(middle.x(), middle.y(), 0));
        }
    }

    /// A robot with the dynamics of its limits among posts and people, which fails when it touches one.
    protected final class Drive {
        private final Controller planner;
        private final FootprintOutline body;
        private final List<Point2d> posts;
        private final List<Walker> people = new ArrayList<>();
        private final Obstacles obstacles = new Obstacles(VIEW);
        private Pose2d pose = Pose2d.ORIGIN;
        private Twist2d velocity = Twist2d.STOP;
        private double fastest;
        private double prediction;
        private int sonars; // around it; 0 for a laser
        private double inside = Double.POSITIVE_INFINITY; // its outline on the ways that it tells
        private int freeWays;

        public Drive(Footprint footprint, List<Point2d> posts) {
            this.planner = planner(footprint);
            this.body = new FootprintOutline(footprint, 0);
            this.posts = posts;
        }

        public Pose2d pose() {
            return pose;
        }

        Motion motion() {
            return new Motion(pose, velocity);
        }

        Obstacles look() {
            obstacles.clear();
            if (sonars > 0) {
                obstacles.add(listen());
                return obstacles;
            }
            Pose2d baseFromWorld = pose.inverse();
            posts.forEach(post -> {
                Point2d seen = baseFromWorld.transform(post);
                obstacles.add(seen.x(), seen.y());
            });
            for (Walker person : people) {
                int before = obstacles.count();
                person.outline().stream()
                        .map(baseFromWorld::transform)
                        .forEach(seen -> obstacles.add(seen.x(), seen.y()));
                for (int i = before; i < obstacles.count(); i++) {
                    obstacles.keepRoom(i, 0.05 + 0.4 * Math.abs(velocity.vx())); // as navigators do
                }
            }
            return obstacles;
        }

        /// A ring of cones of 30°, each of which tells how far the nearest post in it is.
        private RangeArray listen() {
            double cone = Math.toRadians(30);
            List<Pose2d> mounts = IntStream.range(0, sonars)
                    .mapToDouble(i -> i * 2 * Math.PI / sonars)
                    .mapToObj(angle -> new Pose2d(0, 0, angle).compose(new Pose2d(0.15, 0, 0)))
                    .toList();
            var ranges = new float[sonars];
            for (int i = 0; i < sonars; i++) {
                Pose2d sonarFromWorld = pose.compose(mounts.get(i)).inverse();
                ranges[i] = (float) posts.stream()
                        .map(sonarFromWorld::transform)
                        .filter(post -> Math.abs(Math.atan2(post.y(), post.x())) <= cone / 2)
                        .mapToDouble(post -> Math.hypot(post.x(), post.y()))
                        .min()
                        .orElse(Double.POSITIVE_INFINITY);
            }
            return new RangeArray(mounts, cone, 0, VIEW, ranges);
        }

        public void goTo(Point2d goal, double seconds) {
            for (int beat = 0; beat * BEAT < seconds && pose.position().distanceTo(goal) > 0.3; beat++) {
                Target target = Target.at(pose.inverse().transform(goal), true);
                Twist2d command = planner.drive(look(), target, motion());
                assertReportsAPath(command);
                move(command);
            }
        }

        private void assertReportsAPath(Twist2d command) {
            List<Point2d> reported = planner.predictedTrajectory();
            if (Math.abs(command.vx()) < 0.01) {
                assertThat(reported).isEmpty();
                return;
            } else if (reported.isEmpty()) {
                assertThat(Math.abs(command.vx())).isLessThan(0.03);
                return;
            }
            assertThat(reported).hasSizeBetween(2, Controller.PATH_POINTS);
            assertThat(reported.getFirst()).isEqualTo(new Point2d(0, 0));
            assertThat(reported.get(1).x() * command.vx()).isPositive();
            assertThat(new Path2d(reported).length()).isLessThan(LIMITS.speed() * 2 + 0.01);
            if (command.vx() > 0.1) {
                assertIsFree(reported);
            }
        }

        private void assertIsFree(List<Point2d> prediction) {
            for (int i = 1; i < prediction.size() - 1; i++) {
                Point2d before = prediction.get(i - 1);
                Point2d after = prediction.get(i + 1);
                double heading = Math.atan2(after.y() - before.y(), after.x() - before.x());
                Pose2d there =
                        new Pose2d(prediction.get(i).x(), prediction.get(i).y(), heading).inverse();
                for (int k = 0; k < obstacles.count(); k++) {
                    Point2d seen = there.transform(obstacles.at(k));
                    assertThat(body.distance(seen.x(), seen.y()))
                            .as("%s from place %d of %s", seen, i, prediction)
                            .isGreaterThan(-inside);
                }
            }
            freeWays++;
        }

        /// Heads for what is next on a way, as navigators do.
        void along(Path2d prediction, CostMap map, double seconds) {
            var route = new Route(prediction);
            for (int beat = 0; beat * BEAT < seconds && pose.position().distanceTo(route.end()) > 0.3; beat++) {
                route.advance(pose.position());
                Pose2d baseFromMap = pose.inverse();
                Point2d next = route.target(pose.position(), map, LOOKAHEAD);
                List<Point2d> left = route.left(pose.position()).points().stream()
                        .map(baseFromMap::transform)
                        .toList();
                var target = new Target(baseFromMap.transform(next), next.equals(route.end()), left);
                move(planner.drive(look(), target, motion()));
            }
        }

        void move(Twist2d command) {
            int parts = 10;
            double dt = BEAT / parts;
            for (int part = 0; part < parts; part++) {
                velocity = Twist2d.drive(
                        approach(velocity.vx(), command.vx(), LIMITS.acceleration() * dt),
                        approach(velocity.omega(), command.omega(), LIMITS.turnAcceleration() * dt));
                pose = pose.compose(new Pose2d(velocity.vx() * dt, 0, velocity.omega() * dt));
                prediction += Math.abs(velocity.vx()) * dt;
                fastest = Math.max(fastest, velocity.vx());
                posts.forEach(this::assertIsBeside);
                for (Walker person : people) {
                    person.outline().forEach(this::assertIsBeside);
                    person.walk(dt, body, pose);
                }
            }
        }

        private void assertIsBeside(Point2d point) {
            Point2d seen = pose.inverse().transform(point);
            assertThat(body.distance(seen.x(), seen.y()))
                    .as("%s, seen at %s", point, seen)
                    .isPositive();
        }

        private static double approach(double from, double to, double most) {
            return from + Math.clamp(to - from, -most, most);
        }
    }
}
