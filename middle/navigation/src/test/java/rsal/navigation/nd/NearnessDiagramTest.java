package rsal.navigation.nd;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import rsal.data.Point2d;
import rsal.data.Pose2d;
import rsal.navigation.avoid.Obstacles;
import rsal.navigation.nd.NearnessDiagram.Region;

class NearnessDiagramTest {
    private static final double RADIUS = 0.25;

    private final Obstacles obstacles = new Obstacles(5);
    private final NearnessDiagram diagram = new NearnessDiagram(RADIUS, 2 * RADIUS);

    @Test
    void aSeenGoalIsARegionEvenWhereNoGapIs() {
        arc(-180, 180, 2);
        assertThat(region(40, 1.5)).hasValueSatisfying(region -> {
            assertThat(region.goal()).isTrue();
            assertThat(region.direction()).isCloseTo(Math.toRadians(40), within(1e-9));
        });
        assertThat(region(40, 3)).isEmpty();
    }

    @Test
    void aHiddenGoalIsGoneToThroughTheNearestGap() {
        arc(-180, 180, 4);
        arc(-30, 50, 1);
        assertThat(region(0, 3)).hasValueSatisfying(region -> {
            assertThat(region.goal()).isFalse();
            assertThat(region.corner()).isCloseTo(Math.toRadians(-30), within(0.05));
            assertThat(region.side()).isEqualTo(-1);
            assertThat(region.cornerDistance()).isCloseTo(1, within(1e-3));
        });
    }

    @Test
    void aGapThatIsTooNarrowIsNone() {
        arc(-180, 180, 4);
        arc(-150, -5, 1);
        arc(15, 130, 1); // 20° at 1 m are 0.35 m
        assertThat(region(5, 3)).hasValueSatisfying(region -> {
            assertThat(region.goal()).isFalse();
            assertThat(region.corner()).isCloseTo(Math.toRadians(130), within(0.05));
        });
    }

    @Test
    void aDoorThatIsWideEnoughIsGoneThrough() {
        arc(-180, 180, 4);
        arc(-150, -20, 1);
        arc(20, 130, 1); // 0.7 m
        assertThat(region(5, 3))
                .hasValueSatisfying(region -> assertThat(region.goal()).isTrue());
    }

    /// Between two posts 1 m ahead, the robot has 0.5 m of width.
    @ParameterizedTest
    @CsvSource({"0.28, true", "0.22, false", "0.6, true"})
    void goesBetweenPostsThatItFitsBetween(double beside, boolean fits) {
        obstacles.add(1, beside);
        obstacles.add(1, -beside);
        assertThat(region(0, 2).map(Region::goal).orElse(false)).isEqualTo(fits);
    }

    /// It is a circle of 0.25 m, and what is beyond the goal or behind the robot is in nobody's way.
    @ParameterizedTest
    @CsvSource({
        "0.9, 0.2, false",
        "0.9, -0.2, false",
        "0.85, 0.32, true",
        "1.06, 0.2, true",
        "-0.3, 0.1, true",
        "-0.1, -0.3, true",
        "0.5, 0.3, true"
    })
    void needsRoomAtTheGoal(double x, double y, boolean fits) {
        obstacles.add(x, y);
        assertThat(region(0, 1).map(Region::goal).orElse(false)).isEqualTo(fits);
    }

    @Test
    void reportsWhereSomethingIs() {
        Point2d post = Pose2d.polar(0.6, Math.toRadians(-60)).position();
        obstacles.add(post.x(), post.y()); // a circle of 0.02 m, which is 1.9° to each side
        diagram.fill(obstacles);
        var reported = new ArrayList<Double>();
        diagram.forEach((direction, distance) -> {
            assertThat(distance).isCloseTo(0.6, within(1e-6));
            reported.add(Math.toDegrees(direction));
        });
        assertThat(reported).hasSize(3);
        assertThat(reported.stream().mapToDouble(Double::doubleValue).sum()).isCloseTo(-180, within(1e-6));
    }

    /// The robot's width is 0.5 m, and so is the least jump of nearness.
    @ParameterizedTest
    @CsvSource({"1.4, false", "1.6, true"})
    void aGapIsWhereNearnessJumpsByMoreThanTheRobotIsWide(double far, boolean gap) {
        arc(-180, 180, far);
        arc(-40, 40, 1);
        assertThat(region(0, 3).isPresent()).isEqualTo(gap);
    }

    @ParameterizedTest
    @CsvSource({"1, -1, 0.5, 0.75", "1, 1, 0.5, 1.25", "3.1, 1, 0.4, -2.9831853", "-3, -1, 1, 2.7831853"})
    void theMiddleOfARegionIsHalfItsWidthFromItsCorner(double corner, int side, double width, double middle) {
        assertThat(new Region(corner, false, corner, 1, side, width).middle()).isCloseTo(middle, within(1e-6));
    }

    private Optional<Region> region(double goalDegrees, double distance) {
        diagram.fill(obstacles);
        return diagram.region(Math.toRadians(goalDegrees), distance);
    }

    private void arc(int from, int to, double distance) {
        for (int degrees = from; degrees < to; degrees++) {
            var place = Pose2d.polar(distance, Math.toRadians(degrees)).position();
            obstacles.add(place.x(), place.y());
        }
    }

    /// What keeps more room is as much nearer.
    @ParameterizedTest
    @CsvSource({"0, 1.2", "0.3, 0.9", "1.5, 0"})
    void roomThatIsKeptMakesThingsNearer(double room, double nearness) {
        obstacles.add(0, -1.2);
        obstacles.keepRoom(0, room);
        diagram.fill(obstacles);
        var reported = new ArrayList<Double>();
        diagram.forEach((direction, distance) -> {
            assertThat(Math.toDegrees(direction)).isCloseTo(-90, within(2.0));
            reported.add(distance);
        });
        assertThat(reported)
                .isNotEmpty()
                .allSatisfy(distance -> assertThat(distance).isCloseTo(nearness, within(1e-6)));
    }

    /// Where nothing is seen there is a gap at each end of a wall; the region reaches around to its other end.
    @ParameterizedTest
    @CsvSource({"0, -30, -1", "20, 50, 1"})
    void aWallAloneHasAGapAtEachEnd(double goal, double corner, int side) {
        arc(-30, 50, 1);
        assertThat(region(goal, 3)).hasValueSatisfying(region -> {
            assertThat(region.goal()).isFalse();
            assertThat(Math.toDegrees(region.corner())).isCloseTo(corner, within(2.5));
            assertThat(region.direction()).isEqualTo(region.corner());
            assertThat(region.side()).isEqualTo(side);
            assertThat(region.cornerDistance()).isCloseTo(1, within(1e-3));
            assertThat(Math.toDegrees(region.width())).isCloseTo(280, within(5.0));
        });
    }
}
