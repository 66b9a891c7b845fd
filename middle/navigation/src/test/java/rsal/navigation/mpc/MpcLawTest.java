package rsal.navigation.mpc;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import rsal.data.Angles;
import rsal.data.Footprint;
import rsal.data.Point2d;
import rsal.data.Pose2d;
import rsal.data.Twist2d;
import rsal.navigation.avoid.Controller.Motion;
import rsal.navigation.avoid.Controller.Target;
import rsal.navigation.avoid.DriveLimits;
import rsal.navigation.avoid.FootprintOutline;
import rsal.navigation.avoid.Obstacles;
import rsal.navigation.avoid.VelocityFilter;

/// What a way costs, in closed form, and that the cheapest is driven. A way is of 24 steps of 0.06 s, of which
/// each knot of a plan has six.
class MpcLawTest {
    private static final DriveLimits LIMITS = new DriveLimits(0.6, 1.5, 0.8, 3);
    private static final Footprint BOX = Footprint.box(0.44, 0.38, new Point2d(-0.04, 0)); // its front is at 0.18 m
    private static final Footprint WEDGE =
            new Footprint(List.of(new Point2d(0.4, 0), new Point2d(-0.3, 0.25), new Point2d(-0.3, -0.25)));
    private static final Mpc.Settings SETTINGS = new Mpc.Settings(8, 0.05, 0.1, 0.5);
    private static final double SECONDS = 24 * 0.06;
    private static final double INFINITY = Double.POSITIVE_INFINITY;
    private static final Pose2d THERE = new Pose2d(3, 4, 1);

    private final Mpc mpc = new Mpc(BOX, LIMITS, SETTINGS, 0.2, 0.1);
    private final Obstacles obstacles = new Obstacles(3.5);

    private static Motion moving(Pose2d pose, double v, double omega) {
        return new Motion(pose, Twist2d.drive(v, omega));
    }

    /// Of one speed and one turn rate.
    private static double[] even(double v, double omega) {
        return new double[] {v, omega, v, omega, v, omega, v, omega};
    }

    private Twist2d goTo(double x, double y, Motion motion) {
        return mpc.drive(obstacles, Target.at(new Point2d(x, y), true), motion);
    }

    private static double turned(double theta, Pose2d pose) {
        return Angles.difference(pose.theta(), theta);
    }

    /// What the map and the field of a planner hold that sees the obstacles from the origin.
    private record Around(RollingMap map, TimeField field) {}

    private Around around(Point2d goal) {
        var map = new RollingMap(160, 0.05, 600);
        var field = new TimeField(map, mpc::speedAmidst);
        map.note(obstacles, Pose2d.ORIGIN);
        field.spread(goal, new Point2d(0, 0));
        return new Around(map, field);
    }

    @Test
    void itsOutlineIsLookedAtInStepsOfTwoCells() {
        for (Footprint footprint : List.of(BOX, WEDGE)) {
            double[][] points = Mpc.samples(footprint);
            var outline = new FootprintOutline(footprint, 0);
            int count = points[0].length;
            double around = 0;
            for (int i = 0; i < count; i++) {
                int next = (i + 1) % count;
                assertThat(outline.distance(points[0][i], points[1][i])).isCloseTo(0, within(1e-9));
                double step = Math.hypot(points[0][next] - points[0][i], points[1][next] - points[1][i]);
                assertThat(step).isBetween(0.05, 0.1 + 1e-9);
                around += step;
            }
            double expected = 0;
            List<Point2d> corners = footprint.corners();
            for (int i = 0; i < corners.size(); i++) {
                Point2d corner = corners.get(i);
                expected += corner.distanceTo(corners.get((i + 1) % corners.size()));
                int at = 0;
                for (int k = 0; k < count; k++) {
                    at += corner.distanceTo(new Point2d(points[0][k], points[1][k])) < 1e-9 ? 1 : 0;
                }
                assertThat(at).as("each corner once").isEqualTo(1);
            }
            assertThat(around).isCloseTo(expected, within(1e-9));
        }
    }

    /// The outline holds a circle of 0.18 m around the base, and is held by one of 0.322 m.
    @ParameterizedTest
    @CsvSource({
        "0, 0", // touches
        "0.2299, 0",
        "0.2301, 0.09", // fits, if it looks the right way: 0.15 of the highest speed
        "0.37, 0.09",
        "0.3731, 0.1005", // 0.1 m/s, and 0.5 m/s more for each meter beside the larger circle
        "0.5720, 0.2",
        "1.3720, 0.6",
        "9, 0.6"
    })
    void howFastItMayBeDependsOnTheRoom(double distance, double speed) {
        assertThat(mpc.speedAmidst(distance)).isCloseTo(speed, within(1e-3));
    }

    @Test
    void amidstThingsItIsNeverFasterThanItCreeps() {
        var fast = new Mpc(BOX, new DriveLimits(2, 2, 1, 1), SETTINGS, 0.2, 0.1);
        assertThat(fast.speedAmidst(0.3)).isCloseTo(0.15, within(1e-9));
        assertThat(fast.speedAmidst(9)).isEqualTo(2);
    }

    /// It plans 2.5 m around: half its view, less 1.5 m.
    @ParameterizedTest
    @CsvSource({
        "1, 0, 2, 0, 2, 0", // the way ends in view
        "1, 0, 2.5, -1, 2.5, -1",
        "0, 0, 5, 0, 2.5, 0",
        "0, 0, 0, -30, 0, -2.5",
        "0, 0, -4, 2, -2.5, 1.25",
        "1, 0.5, 4, 2, 2.5, 1.25",
        "3, 0, 6, 0, 3, 0" // it begins out of view
    })
    void headsForWhereTheWayLeavesTheView(double x1, double y1, double x2, double y2, double x, double y) {
        var way = List.of(new Point2d(x1, y1), new Point2d(x2, y2));
        Point2d goal = mpc.goal(new Target(new Point2d(9, 9), false, way));
        assertThat(goal.x()).isCloseTo(x, within(1e-9));
        assertThat(goal.y()).isCloseTo(y, within(1e-9));
        assertThat(mpc.goal(Target.at(new Point2d(9, 9), false))).isEqualTo(new Point2d(9, 9));
    }

    /// It arrives 0.15 m before the goal; what is left of the time is worth as much.
    @ParameterizedTest
    @CsvSource({
        "0.5, 0.5, 0.5, 12", // 0.03 m a step
        "0.5, 0.5, 0.32, 6",
        "0, 0.6, 0.4, 13", // as fast as 0.8 m/s² makes it: 0.00144 k (k + 1) m after k steps, up to the twelfth
        "0.6, 0, 0.3, 6", // braking: 0.036 k - 0.00144 k (k + 1)
        "-0.3, 0.5, 0.1, 1" // is there already, as it goes backward
    })
    void arrivingSoonerIsCheaper(double velocity, double command, double goal, int steps) {
        Motion motion = moving(THERE, velocity, 0);
        goTo(goal, 0, motion);
        assertThat(mpc.cost(even(command, 0), motion, INFINITY)).isCloseTo(steps * 0.06 - SECONDS, within(1e-9));
    }

    /// An arc of 0.5 m/s and 0.8 rad/s, to either side.
    @ParameterizedTest
    @ValueSource(ints = {1, -1})
    void arrivesOnAnArc(int side) {
        double time = 15.5 * 0.06;
        double x = 0.5 / 0.8 * Math.sin(0.8 * time);
        double y = side * 0.5 / 0.8 * (1 - Math.cos(0.8 * time));
        Motion motion = moving(THERE, 0.5, side * 0.8);
        goTo(x, y, motion);
        assertThat(mpc.cost(even(0.5, side * 0.8), motion, INFINITY))
                .as("0.15 m, which are five steps, before")
                .isCloseTo(11 * 0.06 - SECONDS, within(1e-9));
    }

    /// 0.3 for a change of the whole turn rate.
    @ParameterizedTest
    @CsvSource({"0.5, 1, 0.1", "0.5, 0.2, 0.06", "-0.5, 0.1, 0.12"})
    void aChangeOfTheTurnRateCosts(double omega, double command, double cost) {
        Motion motion = moving(THERE, 0.5, omega);
        goTo(0.32, 0, motion);
        double[] plan = {0.5, command, 0.5, 0, 0.5, 0, 0.5, 0};
        assertThat(mpc.cost(plan, motion, INFINITY)).isCloseTo(cost + 6 * 0.06 - SECONDS, within(1e-9));
    }

    /// A thousand for touching anything, and the more the sooner: a wall 0.15 m farther away is five steps
    /// later.
    @Test
    void touchingIsHopelessTheMoreTheSooner() {
        Motion motion = moving(Pose2d.ORIGIN, 0.5, 0);
        double before = 0;
        for (double wall : new double[] {0.4, 0.55, 0.7}) {
            mpc.reset();
            obstacles.clear();
            for (double y = -1; y <= 1; y += 0.04) {
                obstacles.add(wall + 0.01, y);
            }
            goTo(2, 0, motion);
            double cost = mpc.cost(even(0.5, 0), motion, INFINITY);
            double steps = (2 - cost / 1000) * 24;
            assertThat(steps).isCloseTo(Math.rint(steps), within(1e-9));
            double expected = (wall - 0.05 - 0.18) / 0.03;
            assertThat(steps).isCloseTo(expected, within(3.0)); // cells of 0.05 m
            if (before > 0) {
                assertThat(steps - before).isCloseTo(5, within(1.01));
            }
            before = steps;
        }
        assertThat(mpc.cost(even(0, 0), moving(Pose2d.ORIGIN, 0, 0), INFINITY)).isLessThan(1000);
    }

    /// Amidst a corridor with room for 0.28 m/s: too fast, at that speed and slower.
    @ParameterizedTest
    @ValueSource(doubles = {0.6, 0.4, 0.2, 0.05})
    void fasterThanTheRoomAllowsCostsAndSoDoesWhatIsLeft(double speed) {
        for (double x = -1; x <= 3.4; x += 0.04) {
            obstacles.add(x, 0.6);
            obstacles.add(x, -0.6);
        }
        Motion motion = moving(Pose2d.ORIGIN, speed, 0);
        var goal = new Point2d(3, 0);
        goTo(3, 0, motion);
        Around around = around(goal);
        double expected = 0;
        double room = 0;
        for (int step = 1; step <= 24; step++) {
            room = mpc.room(speed * step * 0.06, 0, 0);
            assertThat(room).isCloseTo(0.6 - 0.19 - 0.05, within(0.06));
            expected += 0.06 * 3 * Math.max(0, speed - 0.1 - 0.5 * room);
        }
        double end = speed * SECONDS;
        expected += around.field().at(end, 0);
        expected += 0.35 * Math.abs(around.field().direction(end, 0));
        expected += 0.35 * Math.max(0, Math.min(0.6, 0.1 + 0.5 * room) - speed) / 0.6;
        double cost = mpc.cost(even(speed, 0), motion, INFINITY);
        assertThat(cost).isCloseTo(expected, within(1e-6));
        assertThat(mpc.cost(even(speed, 0), motion, cost / 2))
                .as("enough is known")
                .isGreaterThan(cost / 2);
    }

    /// Turning in place, as fast as 3 rad/s² allow.
    @ParameterizedTest
    @ValueSource(doubles = {0.8, -0.8, 1.5})
    void notLookingAlongTheWayCosts(double omega) {
        Motion motion = moving(Pose2d.ORIGIN, 0, 0);
        goTo(1.2, 1.6, motion);
        Around around = around(new Point2d(1.2, 1.6));
        double theta = 0;
        double rate = 0;
        for (int step = 0; step < 24; step++) {
            rate = Math.copySign(Math.min(Math.abs(omega), Math.abs(rate) + 0.18), omega);
            theta += 0.06 * rate;
        }
        double way = around.field().direction(0, 0);
        assertThat(way).isCloseTo(Math.atan2(1.6, 1.2), within(0.1));
        double expected =
                0.3 * Math.abs(omega) / 1.5 + around.field().at(0, 0) + 0.35 * Math.abs(way - theta) + 0.35 * 0.6 / 0.6;
        assertThat(mpc.cost(even(0, omega), motion, INFINITY)).isCloseTo(expected, within(1e-6));
    }

    /// Between the outline and what is nearest, less the margin; of what is far away the outer circle is
    /// enough.
    @ParameterizedTest
    @ValueSource(longs = {1, 2, 3, 4, 5, 6})
    void roomIsThatBesideTheOutline(long seed) {
        var random = new SplittableRandom(seed);
        for (int i = 0; i < 4; i++) {
            double angle = random.nextDouble(2 * Math.PI);
            double range = random.nextDouble(0.5, 2.5);
            obstacles.add(range * Math.cos(angle), range * Math.sin(angle));
        }
        double margin = 0.2;
        var wide = new Mpc(BOX, LIMITS, new Mpc.Settings(8, margin, 0.1, 0.5), 0.2, 0.1);
        wide.drive(obstacles, Target.at(new Point2d(3, 0), true), moving(Pose2d.ORIGIN, 0, 0));
        double[][] outline = Mpc.samples(BOX);
        double cell = 0.05 * Math.sqrt(2); // by so much distances may differ
        int touched = 0;
        for (int draw = 0; draw < 300; draw++) {
            var pose = new Pose2d(random.nextDouble(-1.5, 1.5), random.nextDouble(-1.5, 1.5), random.nextDouble(-3, 3));
            double beside = INFINITY;
            double middle = INFINITY;
            for (int i = 0; i < obstacles.count(); i++) {
                middle = Math.min(middle, pose.position().distanceTo(obstacles.at(i)));
                for (int k = 0; k < outline[0].length; k++) {
                    Point2d corner = pose.transform(new Point2d(outline[0][k], outline[1][k]));
                    beside = Math.min(beside, corner.distanceTo(obstacles.at(i)));
                }
            }
            double room = wide.room(pose.x(), pose.y(), pose.theta());
            if (beside < margin - cell) {
                assertThat(room).isEqualTo(-1);
                touched++;
            } else if (middle - 0.322 - margin > 0.5 + cell) {
                assertThat(room).isCloseTo(middle - 0.322 - margin, within(cell));
            } else if (middle - 0.322 - margin < 0.5 - cell && beside > margin + cell) {
                assertThat(room).isCloseTo(beside - margin, within(cell));
            }
        }
        assertThat(touched).isPositive();
    }

    private void scatter(SplittableRandom random) {
        obstacles.clear();
        mpc.reset();
        for (int i = 0; i < 12; i++) {
            double angle = random.nextDouble(2 * Math.PI);
            double range = random.nextDouble(0.7, 2.5);
            obstacles.add(range * Math.cos(angle), range * Math.sin(angle));
        }
    }

    /// Of the samples that are the same each time none is cheaper, and drawing others around the best is worth
    /// it.
    @Test
    void doesTheCheapestOfWhatItTriesAndRefinesIt() {
        int refined = 0;
        for (long seed = 0; seed < 12; seed++) {
            var random = new SplittableRandom(seed);
            scatter(random);
            Motion motion = moving(Pose2d.ORIGIN, random.nextDouble(0, 0.5), random.nextDouble(-0.5, 0.5));
            goTo(random.nextDouble(-2, 3), random.nextDouble(-2, 2), motion);
            double same = INFINITY;
            for (double share : new double[] {1, 0.6, 0.3, 0.1, 0}) {
                for (double first : new double[] {-1, -0.6, -0.3, -0.12, 0, 0.12, 0.3, 0.6, 1}) {
                    for (double then : new double[] {-0.6, -0.2, 0, 0.2, 0.6}) {
                        double v = share * 0.6;
                        double w = then * 1.5;
                        double[] plan = {v, first * 1.5, v, w, v, w, v, w};
                        same = Math.min(same, mpc.cost(plan, motion, INFINITY));
                    }
                }
            }
            mpc.turn(obstacles, 0.1, motion); // forgets its plan
            double found = mpc.search(motion);
            assertThat(found).as("seed %d", seed).isLessThanOrEqualTo(same + 1e-9);
            refined += found < same - 0.02 ? 1 : 0;
        }
        assertThat(refined).isGreaterThanOrEqualTo(9);
    }

    /// What it planned a moment before is tried again, and what is found around it.
    @Test
    void thePlanGrowsBetterFromTimeToTime() {
        var quick = new Mpc(BOX, LIMITS, SETTINGS, 0.2, 1e-6);
        int better = 0;
        for (long seed = 0; seed < 12; seed++) {
            var random = new SplittableRandom(seed);
            scatter(random);
            quick.reset();
            Motion motion = moving(Pose2d.ORIGIN, 0.3, 0);
            Target target = Target.at(new Point2d(random.nextDouble(-2, 3), random.nextDouble(-2, 2)), true);
            quick.drive(obstacles, target, motion);
            quick.turn(obstacles, 0.1, motion); // forgets its plan
            double first = quick.search(motion);
            for (int again = 0; again < 3; again++) {
                quick.drive(obstacles, target, motion);
            }
            double later = quick.search(motion);
            assertThat(later).as("seed %d", seed).isLessThanOrEqualTo(first + 1e-3);
            better += later < first - 1e-3 ? 1 : 0;
        }
        assertThat(better).isGreaterThanOrEqualTo(8);
    }

    /// From rest as fast as it can: after k steps 0.00144 k (k + 1) m, up to the twelfth; then 0.036 m a step.
    @Test
    void aheadOfItNothingIsItDrivesStraightOnAndSaysSo() {
        Twist2d command = goTo(5, 0, moving(THERE, 0, 0));
        assertThat(command.vx()).isEqualTo(0.6);
        assertThat(command.omega()).isCloseTo(0, within(0.02));
        List<Point2d> way = mpc.predictedTrajectory();
        assertThat(way).hasSize(9);
        for (int point = 0; point < 9; point++) {
            int k = 3 * point;
            double x = k <= 12 ? 0.00144 * k * (k + 1) : 0.00144 * 12 * 13 + 0.036 * (k - 12);
            assertThat(way.get(point).x()).isCloseTo(x, within(0.02));
            assertThat(way.get(point).y()).isCloseTo(0, within(0.02));
        }
    }

    /// The first knot of what it says is what it commands, with the accelerations that it is able of.
    @ParameterizedTest
    @ValueSource(ints = {1, -1})
    void whatItSaysBeginsWithWhatItCommands(int side) {
        Twist2d command = goTo(0.8, side * 1.5, moving(THERE, 0.3, side * 0.2));
        Pose2d pose = Pose2d.ORIGIN;
        double v = 0.3;
        double w = side * 0.2;
        List<Point2d> way = mpc.predictedTrajectory();
        for (int step = 1; step <= 6; step++) {
            v += Math.clamp(command.vx() - v, -0.048, 0.048);
            w += Math.clamp(command.omega() - w, -0.18, 0.18);
            pose = pose.compose(new Pose2d(0, 0, w * 0.03))
                    .compose(new Pose2d(v * 0.06, 0, 0))
                    .compose(new Pose2d(0, 0, w * 0.03));
            if (step % 3 == 0) {
                assertThat(way.get(step / 3).distanceTo(pose.position())).isLessThan(1e-9);
            }
        }
        assertThat(side * command.omega()).isGreaterThan(0.5);
    }

    @Test
    void whatItSaysEndsWhereItArrives() {
        goTo(0.5, 0, moving(THERE, 0.3, 0));
        List<Point2d> way = mpc.predictedTrajectory();
        assertThat(way.getLast().distanceTo(new Point2d(0.5, 0))).isLessThan(0.15);
        assertThat(way.get(way.size() - 2).distanceTo(new Point2d(0.5, 0))).isGreaterThanOrEqualTo(0.15);
    }

    /// Something is nearer than the margin: it turns to where the way leads, or to the target where none does,
    /// as it is enclosed.
    @ParameterizedTest
    @CsvSource({"-1.5, 1.5, false", "-1.5, -1.5, false", "1, 2, false", "-1, 2, true"})
    void whereEachPlanIsHopelessItTurnsToTheWay(double x, double y, boolean enclosed) {
        obstacles.add(-0.27, 0.195); // a corner is there
        for (int degree = 0; enclosed && degree < 360; degree += 5) {
            obstacles.add(0.45 * Math.cos(Math.toRadians(degree)), 0.45 * Math.sin(Math.toRadians(degree)));
        }
        Motion motion = moving(Pose2d.ORIGIN, 0, 0);
        Twist2d command = goTo(x, y, motion);
        assertThat(mpc.search(motion)).isGreaterThanOrEqualTo(1000);
        double way = around(new Point2d(x, y)).field().direction(0, 0);
        assertThat(Double.isNaN(way)).isEqualTo(enclosed);
        double angle = enclosed ? Math.atan2(y, x) : turned(way, Pose2d.ORIGIN);
        var filter = new VelocityFilter(BOX, LIMITS, 0.2);
        assertThat(command).isEqualTo(filter.turn(angle, Twist2d.STOP, obstacles));
        assertThat(mpc.predictedTrajectory()).isEqualTo(filter.predictedTrajectory());
    }

    @Test
    void mirroredThingsAreDrivenMirrored() {
        for (long seed = 0; seed < 10; seed++) {
            var random = new SplittableRandom(seed);
            scatter(random);
            double y = random.nextDouble(0.3, 1.5);
            Twist2d one = goTo(1.5, y, moving(Pose2d.ORIGIN, 0.3, 0));
            var places = new ArrayList<Point2d>();
            for (int i = 0; i < obstacles.count(); i++) {
                places.add(obstacles.at(i));
            }
            obstacles.clear();
            mpc.reset();
            places.forEach(place -> obstacles.add(place.x(), -place.y()));
            Twist2d other = goTo(1.5, -y, moving(Pose2d.ORIGIN, 0.3, 0));
            assertThat(other.omega() * one.omega()).as("seed %d", seed).isLessThan(0.02);
        }
    }

    @Test
    void turnsAndCommandsOfOthersAreUpToTheFilter() {
        var filter = new VelocityFilter(BOX, LIMITS, 0.2);
        Motion motion = moving(Pose2d.ORIGIN, 0.1, 0.1);
        obstacles.add(0.24, 0.1);
        assertThat(mpc.turn(obstacles, -0.7, motion)).isEqualTo(filter.turn(-0.7, motion.velocity(), obstacles));
        Twist2d wanted = Twist2d.drive(0.6, 0.2);
        Twist2d safe = filter.guarded(wanted, motion.velocity(), obstacles);
        assertThat(mpc.guarded(obstacles, wanted, motion)).isEqualTo(safe).isNotEqualTo(wanted);
        assertThat(mpc.predictedTrajectory()).isEqualTo(filter.predictedTrajectory());
        obstacles.clear();
        goTo(3, 0, motion);
        assertThat(mpc.predictedTrajectory()).isNotEmpty();
        mpc.reset();
        assertThat(mpc.predictedTrajectory()).isEmpty();
    }
}
