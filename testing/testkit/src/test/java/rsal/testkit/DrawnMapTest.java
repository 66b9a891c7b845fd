package rsal.testkit;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;
import static org.assertj.core.api.Assertions.within;
import static rsal.data.OccupancyGrid.FREE;
import static rsal.data.OccupancyGrid.OCCUPIED;
import static rsal.data.OccupancyGrid.UNKNOWN;

import java.util.Random;
import org.junit.jupiter.api.Test;
import rsal.data.Point2d;
import rsal.data.Pose2d;

class DrawnMapTest {
    @Test
    void isReadAsItIsSeen() {
        var map = DrawnMap.grid(0.5, """
                ###
                #.@
                ?#""");
        assertThat(map.grid().width()).isEqualTo(3);
        assertThat(map.grid().height()).isEqualTo(3);
        assertThat(map.grid().cells())
                .containsExactly(
                        UNKNOWN, OCCUPIED, FREE, //
                        OCCUPIED, FREE, FREE, //
                        OCCUPIED, OCCUPIED, OCCUPIED);
        assertThat(map.place('@')).isEqualTo(new Point2d(1.25, 0.75));
        assertThat(map.pose('@', 90)).isEqualTo(new Pose2d(1.25, 0.75, Math.PI / 2));
    }

    @Test
    void refusesDoubledAndMissingPlaces() {
        assertThatIllegalArgumentException().isThrownBy(() -> DrawnMap.grid(1, "a.a"));
        assertThatIllegalArgumentException()
                .isThrownBy(() -> DrawnMap.grid(1, "a..").place('b'))
                .withMessageContaining("[a]");
    }

    @Test
    void raysEndAtTheFirstWall() {
        var map = DrawnMap.grid(1, """
                #####
                #@..#
                #.#.#
                #####""");
        var rays = new ObviousRays(map.grid());
        assertThat(rays.range(map.pose('@', 0))).isCloseTo(2.5, within(1e-9));
        assertThat(rays.range(map.pose('@', 90))).isCloseTo(0.5, within(1e-9));
        assertThat(rays.range(map.pose('@', -45))).isCloseTo(0.5 * Math.sqrt(2), within(1e-9));
        assertThat(rays.clearance(1.5, 2.5)).isCloseTo(0.5, within(1e-9));
        assertThat(rays.clearance(1.5, 1.5)).isCloseTo(0.5, within(1e-9));
    }

    @Test
    void raysAgreeWithWalkingInSmallSteps() {
        var map = DrawnMap.grid(0.5, """
                ##########
                #....#...#
                #.##.....#
                #....#...#
                ##########""");
        var rays = new ObviousRays(map.grid());
        var random = new Random(3);
        for (int i = 0; i < 200; i++) {
            var pose = new Pose2d(5 * random.nextDouble(), 2.5 * random.nextDouble(), 6 * random.nextDouble());
            double walked = 0;
            while (walked < 10 && map.grid().at(column(map, pose, walked), row(map, pose, walked)) != OCCUPIED) {
                walked += 1e-4;
            }
            if (walked < 10) {
                assertThat(rays.range(pose)).as("from %s", pose).isCloseTo(walked, within(1e-2));
            }
        }
    }

    private static int column(DrawnMap map, Pose2d pose, double range) {
        return map.grid().column(pose.compose(new Pose2d(range, 0, 0)).x());
    }

    private static int row(DrawnMap map, Pose2d pose, double range) {
        return map.grid().row(pose.compose(new Pose2d(range, 0, 0)).y());
    }
}
