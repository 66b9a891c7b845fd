package rsal.navigation.snd;

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
import rsal.navigation.avoid.Obstacles;
import rsal.navigation.nd.NearnessDiagram;
import rsal.navigation.nd.NearnessDiagram.Region;

/// The law of the paper, by numbers. A direction shows in the turn rate, which is the highest at a right angle.
class SndLawTest {
    private static final Footprint SQUARE = Footprint.box(0.3, 0.3, new Point2d(0, 0));
    private static final DriveLimits LIMITS = new DriveLimits(0.4, 1.2, 0.8, 3);
    private static final double RADIUS = 0.25; // m
    private static final double SAFETY = 0.6; // m
    private static final Snd.Settings SETTINGS = new Snd.Settings(RADIUS, 2 * RADIUS, SAFETY);

    private final Obstacles obstacles = new Obstacles(5);

    private Twist2d drive(double goalDegrees, double distance) {
        var snd = new Snd(SQUARE, LIMITS, SETTINGS, 0.2);
        var target =
                Target.at(Pose2d.polar(distance, Math.toRadians(goalDegrees)).position(), false);
        return snd.drive(obstacles, target, new Motion(Pose2d.ORIGIN, Twist2d.STOP));
    }

    /// @param degrees a multiple of 1.5, as directions are told apart
    private void post(double degrees, double distance) {
        Point2d place = Pose2d.polar(distance, Math.toRadians(degrees)).position();
        obstacles.add(place.x(), place.y());
    }

    private void arc(int from, int to, double distance) {
        for (int degrees = from; degrees < to; degrees++) {
            post(degrees, distance);
        }
    }

    private static void assertHeads(Twist2d command, double degrees, double share) {
        assertThat(command.omega() / LIMITS.turnRate() * 90).isCloseTo(degrees, within(1e-3));
        assertThat(command.vx()).isCloseTo(LIMITS.speed() * share * (1 - Math.abs(degrees) / 90), within(1e-4));
    }

    /// A post at a distance d is a threat of (0.6 + 0.25 - d) / 0.6, and turns the robot towards where the post is not
    /// by
    /// that share of the angle.
    @ParameterizedTest
    @CsvSource({"60, 0.6", "-60, 0.6", "90, 0.55", "-75, 0.7", "120, 0.5", "60, 0.84", "45, 1"})
    void onePostTurnsItAwayTheNearerTheMore(double degrees, double distance) {
        post(degrees, distance);
        double threat = Math.max(0, (SAFETY + RADIUS - distance) / SAFETY);
        double away = degrees - Math.signum(degrees) * 180;
        assertHeads(drive(0, 3), threat * away, 1 - threat);
    }

    /// The square of its threat is the weight of each.
    @Test
    void severalPostsTurnItByTheirWeightedMean() {
        post(60, 0.6);
        post(-75, 0.7);
        double first = 0.25 / 0.6;
        double second = 0.15 / 0.6;
        double turn = (Math.pow(first, 3) * -120 + Math.pow(second, 3) * 105) / (first * first + second * second);
        assertHeads(drive(0, 3), turn, 1 - first);
    }

    /// 0.06 m from its edge, it keeps 5 × 0.06 m.
    @Test
    void keepsLessWhereThereIsLessRoom() {
        post(90, 0.31);
        double threat = (0.3 + 0.25 - 0.31) / 0.3;
        assertThat(drive(0, 3).omega() / LIMITS.turnRate() * 90).isCloseTo(threat * -90, within(1e-3));
    }

    /// Past the corner at the safety distance; through the middle of what is narrower.
    @ParameterizedTest
    @ValueSource(ints = {1, -1})
    void goesToAHiddenGoalPastTheCorner(int side) {
        arc(-180, 180, 4);
        arc(side > 0 ? -60 : -30, side > 0 ? 30 : 60, 1.5);
        Region region = region(3);
        assertThat(region.side()).isEqualTo(side);
        double past = Math.asin((RADIUS + SAFETY) / region.cornerDistance());
        assertHeads(drive(0, 3), Math.toDegrees(region.corner() + side * past), 1);
        assertThat(region.width()).isGreaterThan(2 * past);
    }

    @Test
    void goesThroughTheMiddleOfANarrowGap() {
        arc(-180, 180, 4);
        arc(-180, -65, 1.5);
        arc(-35, 180, 1.5);
        Region region = region(3);
        assertHeads(drive(0, 3), Math.toDegrees(region.middle()), 1);
        assertThat(Math.toDegrees(region.middle())).isCloseTo(-50, within(3.0));
    }

    private Region region(double distance) {
        var diagram = new NearnessDiagram(RADIUS, 2 * RADIUS);
        diagram.fill(obstacles);
        return diagram.region(0, distance).orElseThrow();
    }

    @Test
    void turnsToTheGoalWhereNoRegionLeads() {
        arc(-180, 180, 2);
        Twist2d command = drive(40, 3);
        assertThat(command.vx()).isZero();
        assertThat(command.omega()).isPositive();
    }
}
