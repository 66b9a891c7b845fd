package rsal.navigation.vfh;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import rsal.data.Footprint;
import rsal.data.Point2d;
import rsal.data.Pose2d;
import rsal.data.Twist2d;
import rsal.navigation.avoid.Controller.Motion;
import rsal.navigation.avoid.Controller.Target;
import rsal.navigation.avoid.DriveLimits;
import rsal.navigation.avoid.Obstacles;
import rsal.navigation.avoid.VelocityFilter;

class VfhTest {
    private static final Footprint BOX = Footprint.box(0.44, 0.38, new Point2d(-0.04, 0));
    /// Its largest circle has a radius of 0.18 m.
    private static final Footprint SQUARE = Footprint.box(0.36, 0.36, new Point2d(0, 0));

    private static final DriveLimits LIMITS = new DriveLimits(0.4, 1.2, 0.8, 3);

    private final Vfh vfh = new Vfh(BOX, LIMITS, Vfh.Settings.of(1.4, 0.1, 0.3), 0.2);
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

    /// A direction that was closed opens only where an obstacle is 15 % farther away than where it closes
    /// (section 2.2).
    @Test
    void whatWasClosedOpensLater() {
        double closes = 0;
        for (double distance = 2.2; distance > 0.8 && closes == 0; distance -= 0.01) {
            obstacles.clear();
            vfh.reset();
            obstacles.add(distance, 0);
            closes = drive(obstacles, 0, 3, false, 0).omega() != 0 ? distance : 0;
        }
        assertThat(closes).isGreaterThan(1);
        double opens = 0;
        for (double distance = closes; distance < 2.4 && opens == 0; distance += 0.01) {
            obstacles.clear();
            obstacles.add(distance, 0);
            opens = drive(obstacles, 0, 3, false, 0).omega() == 0 ? distance : 0;
        }
        double radius = closes - 1.4; // of the circle; it looks 1.4 m beyond that
        assertThat(opens - radius).isCloseTo(1.15 * 1.4, within(0.03));
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

    /// Its largest circle has a radius of 0.18 m, its rear is 0.6 m wide.
    @Test
    void goesOnlyThroughWhatAllOfItsBodyFitsThrough() {
        var wedge = new Footprint(List.of(new Point2d(0.45, 0), new Point2d(-0.25, 0.3), new Point2d(-0.25, -0.3)));
        for (double half : new double[] {0.31, 0.4}) {
            var planner = new Vfh(wedge, LIMITS, Vfh.Settings.of(1.4, 0.1, 0.3), 0.2);
            var door = new Obstacles(3);
            for (double y = half; y <= 2; y += 0.05) {
                door.add(1, y);
                door.add(1, -y);
            }
            var ahead = Target.at(new Point2d(2, 0), false);
            Twist2d command = planner.drive(door, ahead, new Motion(Pose2d.ORIGIN, Twist2d.STOP));
            assertThat(command.vx() > 0).as("%s", half).isEqualTo(half == 0.4);
        }
    }

    private void enclose() {
        for (int i = 0; i < 360; i += 3) {
            obstacles.add(0.6 * Math.cos(Math.toRadians(i)), 0.6 * Math.sin(Math.toRadians(i)));
        }
    }

    @Test
    void stopsWhereNoDirectionIsOpen() {
        enclose();
        assertThat(drive(obstacles, 0, 3, false, 0)).isEqualTo(Twist2d.STOP);
    }

    @Test
    void keepsToTheSpeedsOfOpeningsAndTurns() {
        var slow = new Vfh(
                BOX,
                LIMITS,
                new Vfh.Settings(
                        1.4,
                        0.1,
                        0.3,
                        Math.toRadians(10),
                        new Vfh.Openings(0.1, 0.3),
                        new Vfh.Turning(0.5, 0.2, 1),
                        new Vfh.Weights(5, 2, 2)),
                0.2);
        var ahead = Target.at(new Point2d(2, 0), false);
        assertThat(slow.drive(obstacles, ahead, new Motion(Pose2d.ORIGIN, Twist2d.STOP)))
                .isEqualTo(Twist2d.drive(0.3, 0));
        var left = Target.at(new Point2d(0, 2), false);
        assertThat(slow.drive(obstacles, left, new Motion(Pose2d.ORIGIN, Twist2d.STOP))
                        .omega())
                .isCloseTo(0.5, within(1e-9));
        assertThat(slow.drive(obstacles, left, new Motion(Pose2d.ORIGIN, Twist2d.drive(1, 0)))
                        .omega())
                .isCloseTo(0.2, within(1e-9));
        wall(1.2, 0.6, 2);
        wall(1.2, -2, -0.6);
        assertThat(slow.drive(obstacles, ahead, new Motion(Pose2d.ORIGIN, Twist2d.STOP))
                        .vx())
                .isBetween(0.05, 0.1);
    }

    @Test
    void forgetsWhatWasClosedWhenItIsReset() {
        obstacles.add(1.5, 0); // which closes what is ahead
        assertThat(drive(obstacles, 0, 3, false, 0).omega()).isNotZero();
        obstacles.clear();
        obstacles.add(1.7, 0); // which keeps it closed, and would not close it
        assertThat(drive(obstacles, 0, 3, false, 0).omega()).isNotZero();
        vfh.reset();
        assertThat(drive(obstacles, 0, 3, false, 0).omega()).isZero();
    }

    /// No driving while 60° are missing, linear before.
    @ParameterizedTest
    @CsvSource({"15, 0.3", "-30, 0.2", "45, 0.1", "-60, 0", "70, 0"})
    void drivesSlowerTheMoreItHasToTurn(double degrees, double speed) {
        assertThat(drive(obstacles, Math.toRadians(degrees), 3, false, 0.2).vx())
                .isCloseTo(speed, within(1e-9));
    }

    /// Both sides are as far from the target.
    @ParameterizedTest
    @ValueSource(doubles = {0.6, -0.6})
    void ofTwoSidesTakesTheOneThatItHasToTurnLessFor(double bearing) {
        Point2d post = Pose2d.polar(0.8, bearing).position();
        obstacles.add(post.x(), post.y());
        double turn = turnOf(agile(Vfh.Turning.ANY_RATE, 1.4), bearing, 0);
        assertThat(Math.abs(turn)).isLessThan(0.6);
    }

    /// Rays of posts leave a narrow opening from 20° to 110°, of which asin(grown / 1 m) is closed at each
    /// side.
    @ParameterizedTest
    @ValueSource(ints = {1, -1})
    void takesTheMiddleOfANarrowOpening(int side) {
        for (int degrees = 110; degrees <= 360 + 20; degrees += 2) {
            Point2d post = Pose2d.polar(1, side * Math.toRadians(degrees)).position();
            obstacles.add(post.x(), post.y());
        }
        assertThat(turnOf(agile(Vfh.Turning.ANY_RATE, 1.4), 0, 0))
                .isCloseTo(side * Math.toRadians(65), within(Math.toRadians(2.6)));
    }

    /// Section 2.3: at 0.4 m/s it drives circles of 1 m at least, around (0, 1) and (0, -1). What is within
    /// such a circle, grown by the radius and the safety distance, bars all directions beyond it on that side.
    @ParameterizedTest
    @CsvSource({
        "0.5, 0.5, true",
        "0.9, 0.9, true",
        "1.2, 1, true",
        "1.35, 1, false",
        "0.2, 2.2, true",
        "0.2, 2.4, false",
        "-0.5, 0.6, false"
    })
    void cannotTurnThroughWhatItsCircleMeets(double x, double y, boolean barred) {
        Vfh fast = agile(new Vfh.Turning(6, 6, 15), 0.1);
        for (int side = -1; side <= 1; side += 2) {
            obstacles.clear();
            fast.reset();
            obstacles.add(x, side * y);
            double beyond = Math.min(Math.PI - 0.1, Math.atan2(y, x) + 0.4);
            double turn = side * turnOf(fast, side * beyond, 0.4);
            if (barred) {
                assertThat(turn).as("to side %d", side).isBetween(Math.atan2(y, x) - 0.8, Math.atan2(y, x));
            } else {
                assertThat(turn).as("to side %d", side).isCloseTo(beyond, within(1e-9));
            }
            fast.reset();
            assertThat(side * turnOf(fast, side * beyond, 0)).as("standing").isCloseTo(beyond, within(1e-9));
            fast.reset();
            assertThat(side * turnOf(fast, -side * beyond, 0.4))
                    .as("to the other side")
                    .isCloseTo(-beyond, within(1e-9));
        }
    }

    /// As fast as the room beside the way allows: (room / safetyDistancePerSpeed)² + acceleration × what is
    /// ahead, its square root.
    @ParameterizedTest
    @CsvSource({"0.3, 0.4", "0.3, -0.4", "0.25, 0.45", "0.35, -0.38", "0.32, 0.5"})
    void theRoomBesideTheWayLimitsTheSpeed(double ahead, double beside) {
        double perSpeed = 2;
        for (double bearing : new double[] {0, 0.2, -0.2}) {
            var careful = new Vfh(SQUARE, LIMITS, Vfh.Settings.of(0.1, 0.1, perSpeed), 0.2);
            obstacles.clear();
            Point2d post = Pose2d.polar(Math.hypot(ahead, beside), bearing + Math.atan2(beside, ahead))
                    .position();
            obstacles.add(post.x(), post.y());
            double room = Math.abs(beside) - 0.18 - 0.1 - obstacles.room(0);
            double allowed = Math.max(0.08, room / perSpeed);
            double speed = Math.sqrt(allowed * allowed + 0.8 * Math.max(0, ahead - 0.18));
            var target = Target.at(Pose2d.polar(3, bearing).position(), false);
            Twist2d command = careful.drive(obstacles, target, new Motion(Pose2d.ORIGIN, Twist2d.STOP));
            assertThat(command.vx())
                    .as("to %s", bearing)
                    .isCloseTo(speed * (1 - Math.abs(bearing) / Math.toRadians(60)), within(1e-6));
        }
    }

    @Test
    void whatIsBehindOrFarBesideLimitsNoSpeed() {
        var careful = new Vfh(SQUARE, LIMITS, Vfh.Settings.of(0.1, 0.1, 2), 0.2);
        obstacles.add(-0.3, 0.35);
        obstacles.add(0.4, 1.1);
        obstacles.add(0.4, -1.1);
        var ahead = Target.at(new Point2d(3, 0), false);
        assertThat(careful.drive(obstacles, ahead, new Motion(Pose2d.ORIGIN, Twist2d.STOP)))
                .isEqualTo(Twist2d.drive(0.4, 0));
    }

    @Test
    void onlyTheTargetHasToWeigh() {
        assertThat(new Vfh.Weights(0.1, 0, 0).heading()).isZero();
        assertThatIllegalArgumentException()
                .isThrownBy(() -> new Vfh.Weights(4, 2, 2))
                .withMessageContaining("'4.0'");
        assertThatIllegalArgumentException().isThrownBy(() -> new Vfh.Weights(4, -0.1, 2));
    }

    /// One that turns so fast that its turn rate shows where it is heading for.
    private static Vfh agile(Vfh.Turning turning, double lookahead) {
        return agile(turning, lookahead, 0.1);
    }

    private static Vfh agile(Vfh.Turning turning, double lookahead, double safetyDistance) {
        return new Vfh(
                SQUARE,
                new DriveLimits(0.4, 6.3, 0.8, 100),
                new Vfh.Settings(
                        lookahead,
                        safetyDistance,
                        0.3,
                        Math.toRadians(5),
                        Vfh.Openings.ANY_SPEED,
                        turning,
                        new Vfh.Weights(5, 2, 2)),
                0.2);
    }

    /// How far it is heading from where it is [rad]; it turns by twice that a second.
    private double turnOf(Vfh planner, double bearing, double speed) {
        var target = Target.at(Pose2d.polar(3, bearing).position(), false);
        Twist2d command = planner.drive(obstacles, target, new Motion(Pose2d.ORIGIN, Twist2d.drive(speed, 0)));
        return command.omega() / 2;
    }

    @Test
    void comesToRestAtTheTarget() {
        assertThat(drive(obstacles, 0, 0.05, true, 0).vx()).isBetween(0.05, 0.25);
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

    /// Of a post 1 m ahead asin((0.18 + 0.1) / 1) = 16° are closed to each side, by sectors of 5°; an opening
    /// begins at 20°, or at 25° where 0.1 m more room is kept. In what is wider than 80° it keeps 40° from the
    /// edge.
    @ParameterizedTest
    @CsvSource({"1, 0, 60", "1, 0.1, 65", "0.7, 0, 65"})
    void inAWideOpeningItKeepsToTheEdge(double distance, double room, double degrees) {
        for (int side = -1; side <= 1; side += 2) {
            obstacles.clear();
            obstacles.add(distance, 0);
            obstacles.keepRoom(0, room);
            assertThat(turnOf(agile(Vfh.Turning.ANY_RATE, 1.4), side * 0.01, 0))
                    .isCloseTo(side * Math.toRadians(degrees), within(1e-6));
        }
    }

    /// With 0.48 m kept from its middle: what is nearer, or hardly farther away, closes 75° to each side.
    @ParameterizedTest
    @CsvSource({"0.31, 120", "0.47, 120", "0.49, 120", "0.6, 95"})
    void whatIsTooNearClosesAllThatIsAhead(double distance, double degrees) {
        for (int side = -1; side <= 1; side += 2) {
            obstacles.clear();
            obstacles.add(distance, 0);
            Vfh planner = agile(Vfh.Turning.ANY_RATE, 1.4, 0.3);
            assertThat(turnOf(planner, side * 0.01, 0)).isCloseTo(side * Math.toRadians(degrees), within(1e-6));
        }
    }

    /// The same in a frame of odometry that is turned by sectors.
    @ParameterizedTest
    @ValueSource(ints = {0, 5, 35, -90, 175, 180})
    void sectorsAreThoseOfTheFrameOfOdometry(int heading) {
        obstacles.add(1, 0);
        Vfh planner = agile(Vfh.Turning.ANY_RATE, 1.4);
        var target = Target.at(Pose2d.polar(3, 0.01).position(), false);
        var motion = new Motion(new Pose2d(4, -5, Math.toRadians(heading + 1e-6)), Twist2d.STOP);
        Twist2d command = planner.drive(obstacles, target, motion);
        assertThat(command.omega() / 2).isCloseTo(Math.toRadians(60), within(1e-4));
    }

    /// Linear from standing to 1 m/s, and no more beyond that.
    @ParameterizedTest
    @CsvSource({"0, 0.5", "0.5, 0.35", "-0.5, 0.35", "1, 0.2", "3, 0.2"})
    void turnsSlowerTheFasterItIs(double speed, double rate) {
        assertThat(new Vfh.Turning(0.5, 0.2, 1).most(speed)).isCloseTo(rate, within(1e-12));
        assertThat(Vfh.Turning.ANY_RATE.most(speed)).isInfinite();
    }

    /// Turning away from what was chosen before costs: of two sides that are as good, the last is taken again,
    /// and so is one that is a little worse.
    @ParameterizedTest
    @ValueSource(doubles = {0.01, 0.05, 0.1})
    void whatWasChosenBeforeIsCheaper(double bearing) {
        obstacles.add(1, 0);
        Vfh planner = agile(Vfh.Turning.ANY_RATE, 1.4);
        assertThat(turnOf(planner, 0.01, 0)).isPositive();
        // 5 x 2 bearing more to the target on that side, and 2 x 120° less from the choice before
        assertThat(turnOf(planner, -bearing, 0)).isPositive();
        planner.reset();
        assertThat(turnOf(planner, -bearing, 0)).isNegative();
    }

    @Test
    void fromWhatMayMoveItKeepsMoreRoomBesideTheWay() {
        var careful = new Vfh(SQUARE, LIMITS, Vfh.Settings.of(0.1, 0.1, 2), 0.2);
        obstacles.add(0.3, 0.5);
        obstacles.keepRoom(0, 0.05);
        double allowed = (0.5 - 0.18 - 0.1 - 0.05) / 2;
        var target = Target.at(new Point2d(3, 0), false);
        assertThat(careful.drive(obstacles, target, new Motion(Pose2d.ORIGIN, Twist2d.STOP))
                        .vx())
                .isCloseTo(Math.sqrt(allowed * allowed + 0.8 * 0.12), within(1e-6));
    }

    @Test
    void turnsAndCommandsOfOthersAreUpToTheFilter() {
        var filter = new VelocityFilter(BOX, LIMITS, 0.2);
        var motion = new Motion(Pose2d.ORIGIN, Twist2d.drive(0.1, 0.1));
        obstacles.add(0.24, 0.1);
        assertThat(vfh.turn(obstacles, -0.7, motion)).isEqualTo(filter.turn(-0.7, motion.velocity(), obstacles));
        Twist2d wanted = Twist2d.drive(0.4, 0.2);
        Twist2d safe = filter.guarded(wanted, motion.velocity(), obstacles);
        assertThat(vfh.guarded(obstacles, wanted, motion)).isEqualTo(safe).isNotEqualTo(wanted);
        assertThat(vfh.predictedTrajectory()).isEqualTo(filter.predictedTrajectory());
        vfh.guarded(new Obstacles(3), wanted, motion);
        assertThat(vfh.predictedTrajectory()).isNotEmpty();
        vfh.reset();
        assertThat(vfh.predictedTrajectory()).isEmpty();
    }

    /// What it says of its way ends at a target where it comes to rest, and is nothing where it stands.
    @Test
    void saysWhereItGoes() {
        drive(obstacles, 0, 0.3, true, 0);
        assertThat(vfh.predictedTrajectory().getLast().x()).isCloseTo(0.3, within(1e-6));
        drive(obstacles, 0, 0.3, false, 0);
        assertThat(vfh.predictedTrajectory().getLast().x()).isCloseTo(0.8, within(1e-6)); // 0.4 m/s for 2 s
        enclose();
        drive(obstacles, 0, 3, false, 0);
        assertThat(vfh.predictedTrajectory()).isEmpty();
    }
}
