package rsal.navigation.nd;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

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
import rsal.navigation.avoid.FootprintOutline;
import rsal.navigation.avoid.Obstacles;
import rsal.navigation.nd.NearnessDiagram.Region;

/// The laws of the papers, by numbers. A direction shows in the turn rate, which is the highest at a right angle.
class NdLawTest {
    private static final Footprint SQUARE = Footprint.box(0.3, 0.3, new Point2d(0, 0));
    private static final DriveLimits LIMITS = new DriveLimits(0.4, 1.2, 0.8, 3);
    private static final double MARGIN = 0.03; // that is part of the robot [m]
    private static final double RADIUS = FootprintOutline.radius(SQUARE) + MARGIN;
    private static final double AVOID = 0.5; // m

    private final Obstacles obstacles = new Obstacles(5);

    private Twist2d drive(double goalDegrees, double distance) {
        var nd = new Nd(SQUARE, LIMITS, new Nd.Settings(AVOID, MARGIN), 0.2);
        var target =
                Target.at(Pose2d.polar(distance, Math.toRadians(goalDegrees)).position(), false);
        return nd.drive(obstacles, target, new Motion(Pose2d.ORIGIN, Twist2d.STOP));
    }

    /// @param degrees a multiple of 1.5, as directions are told apart
    /// @param room 0 at the robot's edge, 1 at the security distance
    private void post(double degrees, double room) {
        Point2d place =
                Pose2d.polar(RADIUS + room * AVOID, Math.toRadians(degrees)).position();
        obstacles.add(place.x(), place.y());
    }

    private void arc(int from, int to, double distance) {
        for (int degrees = from; degrees < to; degrees++) {
            Point2d place = Pose2d.polar(distance, Math.toRadians(degrees)).position();
            obstacles.add(place.x(), place.y());
        }
    }

    private static void assertHeads(Twist2d command, double degrees, double share) {
        assertHeads(command, degrees, share, 1e-3);
    }

    /// A post takes up to 3° to each side, of which any may be that of the nearest obstacle.
    private static void assertTurnedAway(Twist2d command, double degrees, double share) {
        assertHeads(command, degrees, share, 2.3);
    }

    private static void assertHeads(Twist2d command, double degrees, double share, double tolerance) {
        double heading = command.omega() / LIMITS.turnRate() * 90;
        assertThat(heading).isCloseTo(degrees, within(tolerance));
        assertThat(command.vx()).isCloseTo(LIMITS.speed() * share * (1 - Math.abs(heading) / 90), within(1e-4));
    }

    /// HSGR
    @ParameterizedTest
    @ValueSource(doubles = {0, 20, -45})
    void goesToTheGoalWhereNothingIsNear(double degrees) {
        post(60, 1.5);
        assertHeads(drive(degrees, 3), degrees, 1);
    }

    /// LSGR: the share of what is missing to the security distance of the angle away from a post.
    @ParameterizedTest
    @CsvSource({"60, 0.4", "-60, 0.4", "90, 0.25", "-90, 0.6"})
    void turnsAwayFromWhatIsNearOnOneSide(double degrees, double room) {
        post(degrees, room);
        double away = degrees - Math.signum(degrees) * 180;
        assertTurnedAway(drive(0, 3), (1 - room) * away, Math.max(0.2, room));
    }

    @Test
    void turnsAwayFromTheDirectionOfTheGoal() {
        post(60, 0.6);
        double goal = 9;
        assertTurnedAway(drive(goal, 3), goal + 0.4 * (60 - 180 - goal), 0.6);
    }

    /// The farther one, on the same side, does not count.
    @Test
    void turnsAwayFromTheNearestOne() {
        post(120, 0.8);
        post(90, 0.5);
        post(60, 0.7);
        assertTurnedAway(drive(0, 3), 0.5 * -90, 0.5);
    }

    /// LS2: towards the side with more room, by the share of the difference in the sum.
    @ParameterizedTest
    @CsvSource({"0.3, 0.6, 0", "0.6, 0.3, 0", "0.5, 0.5, 0", "0.6, 0.3, 9", "0.3, 0.6, 9", "0.5, 0.9, -9"})
    void goesBetweenWhatIsNearOnBothSides(double left, double right, double goal) {
        post(90, left);
        post(-90, right);
        double share = (left - right) / (left + right);
        double turn = goal + share * (share < 0 ? goal + 90 : 90 - goal);
        assertHeads(drive(goal, 3), turn, Math.min(left, right));
    }

    /// HSWR: past the corner, with the radius and the security distance beside it.
    @ParameterizedTest
    @ValueSource(ints = {1, -1})
    void goesToAHiddenGoalPastTheCorner(int side) {
        arc(-180, 180, 4);
        arc(side > 0 ? -60 : -30, side > 0 ? 30 : 60, 1.5);
        Region region = region();
        assertThat(region.side()).isEqualTo(side);
        assertThat(region.width()).isGreaterThan(Math.PI / 2);
        double past = Math.atan2(RADIUS + AVOID, region.cornerDistance());
        assertHeads(drive(0, 3), Math.toDegrees(region.corner() + side * past), 1);
    }

    /// HSNR
    @Test
    void goesThroughTheMiddleOfANarrowGap() {
        arc(-180, 180, 4);
        arc(-180, -65, 1.5);
        arc(-35, 180, 1.5);
        assertHeads(drive(0, 3), Math.toDegrees(region().middle()), 1);
        assertThat(Math.toDegrees(region().middle())).isCloseTo(-50, within(3.0));
    }

    private Region region() {
        var diagram = new NearnessDiagram(RADIUS, 2 * RADIUS);
        diagram.fill(obstacles);
        return diagram.region(0, 3).orElseThrow();
    }

    @Test
    void turnsToTheGoalWhereNoRegionLeads() {
        arc(-180, 180, 2);
        Twist2d command = drive(40, 3);
        assertThat(command.vx()).isZero();
        assertThat(command.omega()).isPositive();
    }
}
