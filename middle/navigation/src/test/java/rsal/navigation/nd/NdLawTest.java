package rsal.navigation.nd;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import rsal.data.Twist2d;
import rsal.navigation.avoid.Controller;
import rsal.navigation.avoid.FootprintOutline;
import rsal.navigation.nd.NearnessDiagram.Region;

/// The laws of the papers.
class NdLawTest extends NearnessLaws {
    private static final double MARGIN = 0.03; // that is part of the robot [m]
    private static final double RADIUS = FootprintOutline.radius(SQUARE) + MARGIN;
    private static final double AVOID = 0.5; // m

    NdLawTest() {
        super(RADIUS);
    }

    @Override
    protected Controller controller() {
        return new Nd(SQUARE, LIMITS, new Nd.Settings(AVOID, MARGIN), 0.2);
    }

    /// @param room 0 at the robot's edge, 1 at the security distance
    private void post(double degrees, double room) {
        postAt(degrees, RADIUS + room * AVOID);
    }

    /// A post takes up to 3° to each side, of which any may be that of the nearest obstacle.
    private static void assertTurnedAway(Twist2d command, double degrees, double share) {
        assertHeads(command, degrees, share, 2.3);
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
}
