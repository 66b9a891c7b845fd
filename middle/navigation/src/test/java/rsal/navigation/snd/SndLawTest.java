package rsal.navigation.snd;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import rsal.navigation.avoid.Controller;
import rsal.navigation.nd.NearnessDiagram.Region;
import rsal.navigation.nd.NearnessLaws;

/// The law of the paper.
class SndLawTest extends NearnessLaws {
    private static final double RADIUS = 0.25; // m
    private static final double SAFETY = 0.6; // m
    private static final Snd.Settings SETTINGS = new Snd.Settings(RADIUS, 2 * RADIUS, SAFETY);

    SndLawTest() {
        super(RADIUS);
    }

    @Override
    protected Controller controller() {
        return new Snd(SQUARE, LIMITS, SETTINGS, 0.2);
    }

    /// A post at a distance d is a threat of (0.6 + 0.25 - d) / 0.6, and turns the robot towards where the post is not
    /// by
    /// that share of the angle.
    @ParameterizedTest
    @CsvSource({"60, 0.6", "-60, 0.6", "90, 0.55", "-75, 0.7", "120, 0.5", "60, 0.84", "45, 1"})
    void onePostTurnsItAwayTheNearerTheMore(double degrees, double distance) {
        postAt(degrees, distance);
        double threat = Math.max(0, (SAFETY + RADIUS - distance) / SAFETY);
        double away = degrees - Math.signum(degrees) * 180;
        assertHeads(drive(0, 3), threat * away, 1 - threat);
    }

    /// The square of its threat is the weight of each.
    @Test
    void severalPostsTurnItByTheirWeightedMean() {
        postAt(60, 0.6);
        postAt(-75, 0.7);
        double first = 0.25 / 0.6;
        double second = 0.15 / 0.6;
        double turn = (Math.pow(first, 3) * -120 + Math.pow(second, 3) * 105) / (first * first + second * second);
        assertHeads(drive(0, 3), turn, 1 - first);
    }

    /// 0.06 m from its edge, it keeps 5 × 0.06 m.
    @Test
    void keepsLessWhereThereIsLessRoom() {
        postAt(90, 0.31);
        double threat = (0.3 + 0.25 - 0.31) / 0.3;
        assertThat(drive(0, 3).omega() / LIMITS.turnRate() * 90).isCloseTo(threat * -90, within(1e-3));
    }

    /// Past the corner at the safety distance; through the middle of what is narrower.
    @ParameterizedTest
    @ValueSource(ints = {1, -1})
    void goesToAHiddenGoalPastTheCorner(int side) {
        arc(-180, 180, 4);
        arc(side > 0 ? -60 : -30, side > 0 ? 30 : 60, 1.5);
        Region region = region();
        assertThat(region.side()).isEqualTo(side);
        double past = Math.asin((RADIUS + SAFETY) / region.cornerDistance());
        assertHeads(drive(0, 3), Math.toDegrees(region.corner() + side * past), 1);
        assertThat(region.width()).isGreaterThan(2 * past);
    }
}
