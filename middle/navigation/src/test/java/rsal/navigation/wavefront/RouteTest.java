package rsal.navigation.wavefront;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import org.junit.jupiter.api.Test;
import rsal.data.OccupancyGrid;
import rsal.data.Path2d;
import rsal.data.Point2d;
import rsal.navigation.grid.DistanceField;
import rsal.testkit.DrawnMap;

class RouteTest {
    private static final CostMap EMPTY = costs(new OccupancyGrid(60, 60, 0.1, -1, -1, new byte[3600]));

    /// Two meters on, then two to the left.
    private final Route route = new Route(new Path2d(List.of(new Point2d(0, 0), new Point2d(2, 0), new Point2d(2, 2))));

    @Test
    void knowsHowFarItIsAndHowFarOff() {
        route.advance(new Point2d(0.5, 0.2));
        assertThat(route.remaining()).isCloseTo(3.5, within(1e-9));
        assertThat(route.offset()).isCloseTo(0.2, within(1e-9));
        route.advance(new Point2d(2.1, 1.5));
        assertThat(route.remaining()).isCloseTo(0.5, within(1e-9));
        assertThat(route.offset()).isCloseTo(0.1, within(1e-9));
    }

    @Test
    void neverGoesBack() {
        route.advance(new Point2d(1.5, 0));
        route.advance(new Point2d(0.5, 0));
        assertThat(route.remaining()).isCloseTo(2.5, within(1e-9));
        assertThat(route.offset()).isCloseTo(1, within(1e-9));
    }

    @Test
    void aimsAheadOnTheWay() {
        route.advance(new Point2d(1.5, 0));
        Point2d target = route.target(new Point2d(1.5, 0), EMPTY, 1);
        assertThat(target.distanceTo(new Point2d(2, 0.5))).isLessThan(1e-9);
    }

    @Test
    void aimsNoFartherThanItsEnd() {
        route.advance(new Point2d(2, 1.8));
        assertThat(route.target(new Point2d(2, 1.8), EMPTY, 1)).isEqualTo(new Point2d(2, 2));
    }

    @Test
    void aimsNotThroughWalls() {
        var map = DrawnMap.grid(0.1, """
                #########
                #.......#
                #.#####.#
                #.#####.#
                #.#####.#
                #.......#
                #########""");
        var corner = new Route(
                new Path2d(List.of(new Point2d(0.15, 0.15), new Point2d(0.75, 0.15), new Point2d(0.75, 0.55))));
        Point2d start = new Point2d(0.15, 0.15);
        corner.advance(start);
        Point2d target = corner.target(start, costs(map.grid()), 1);
        assertThat(costs(map.grid()).straightCost(start, target)).isFinite();
        assertThat(target.x()).isGreaterThan(0.5);
    }

    @Test
    void theWayLeftStartsWhereTheRobotIs() {
        route.advance(new Point2d(1, 0.1));
        assertThat(route.left(new Point2d(1, 0.1)).points())
                .containsExactly(new Point2d(1, 0.1), new Point2d(2, 0), new Point2d(2, 2));
        assertThat(route.extended(new Point2d(1, 0.1), new Point2d(1, 3)).points())
                .endsWith(new Point2d(2, 2), new Point2d(1, 3));
    }

    private static CostMap costs(OccupancyGrid map) {
        return CostMap.of(map, DistanceField.toNotFree(map), new CostMap.Clearance(0, 0, 0));
    }
}
