package rsal.agents.pursuit.strategy;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.Arrays;
import java.util.BitSet;
import org.junit.jupiter.api.Test;
import rsal.data.OccupancyGrid;
import rsal.data.Point2d;
import rsal.data.Walls;
import rsal.testkit.LongTest;

class FloorGraphTest {
    private static final double CLEARANCE = 0.3;

    private static FloorGraph floor(OccupancyGrid map) {
        return FloorGraph.of(map, new Point2d(1.5, 1.5), CLEARANCE).orElseThrow();
    }

    @Test
    @LongTest
    void pathsAreAbout10PercentLongerThanInTheGrid() {
        FloorGraph floor = floor(Maps.ROOMS);
        double paths = 0;
        double exactPaths = 0;
        for (int from = 0; from < floor.size(); from += 7) {
            double[] exact = gridDistances(Maps.ROOMS, floor.place(from));
            for (int to = 0; to < floor.size(); to++) {
                double path = exact[Maps.ROOMS.cell(floor.place(to))];
                assertThat(path).isFinite();
                assertThat(floor.distances(from)[to]).isBetween(path - 1e-6, 1.4 * path + 0.4);
                paths += floor.distances(from)[to];
                exactPaths += path;
            }
        }
        assertThat(paths).isBetween(exactPaths, 1.15 * exactPaths);
    }

    /// Slow and obvious: relaxes all cells until nothing changes.
    private static double[] gridDistances(OccupancyGrid map, Point2d from) {
        boolean[] open = open(map);
        var far = new double[map.width() * map.height()];
        Arrays.fill(far, Double.POSITIVE_INFINITY);
        far[map.cell(from)] = 0;
        boolean changed = true;
        while (changed) {
            changed = false;
            for (int cell = 0; cell < far.length; cell++) {
                changed |= open[cell] && relax(map, far, cell);
            }
            for (int cell = far.length - 1; cell >= 0; cell--) {
                changed |= open[cell] && relax(map, far, cell);
            }
        }
        return far;
    }

    private static boolean[] open(OccupancyGrid map) {
        var open = new boolean[map.width() * map.height()];
        for (int cell = 0; cell < open.length; cell++) {
            open[cell] = true;
            for (int other = 0; other < open.length; other++) {
                boolean near = Math.abs(other % map.width() - cell % map.width()) <= 3
                        && map.middle(cell).distanceTo(map.middle(other)) < CLEARANCE - 1e-9;
                open[cell] &= !near || map.cells()[other] == OccupancyGrid.FREE;
            }
        }
        return open;
    }

    private static boolean relax(OccupancyGrid map, double[] far, int cell) {
        boolean changed = false;
        for (int dy = -1; dy <= 1; dy++) {
            for (int dx = -1; dx <= 1; dx++) {
                int other = cell + dy * map.width() + dx;
                double step = map.resolution() * (dx != 0 && dy != 0 ? 1.4 : 1.0);
                if (other >= 0 && other < far.length && far[other] + step < far[cell] - 1e-9) {
                    far[cell] = far[other] + step;
                    changed = true;
                }
            }
        }
        return changed;
    }

    @Test
    void neighborsAreMutualAndStepsLeadToTheGoal() {
        FloorGraph floor = floor(Maps.RING);
        for (int place = 0; place < floor.size(); place++) {
            for (int i = 0; i < floor.neighbors(place).length; i++) {
                int other = floor.neighbors(place)[i];
                assertThat(floor.distances(other)[place]).isCloseTo(floor.distances(place)[other], within(1e-9));
                assertThat(floor.neighbors(other)).contains(place);
            }
            int at = place;
            for (int steps = 0; at != 0; steps++) {
                assertThat(steps).isLessThan(floor.size());
                at = floor.next(at, 0);
            }
        }
    }

    @Test
    void aPlaceIsTheNearestOneOfItself() {
        FloorGraph floor = floor(Maps.ROOMS);
        for (int place = 0; place < floor.size(); place++) {
            assertThat(floor.nearest(floor.place(place))).isEqualTo(place);
        }
        assertThat(floor.nearest(new Point2d(-50, -50))).isBetween(0, floor.size() - 1);
    }

    @Test
    void robotsSeeInTheirRangeButNotThroughWalls() {
        FloorGraph floor = floor(Maps.ROOMS);
        var walls = new Walls(Maps.ROOMS);
        BitSet seen = floor.seen(0, 5);
        for (int place = 0; place < floor.size(); place++) {
            boolean near = floor.place(0).distanceTo(floor.place(place)) <= 5;
            assertThat(seen.get(place)).isEqualTo(near && !walls.standBetween(floor.place(0), floor.place(place)));
        }
    }

    @Test
    void thereIsNoFloorInAWall() {
        assertThat(FloorGraph.of(Maps.ROOMS, new Point2d(-5, -5), CLEARANCE)).isEmpty();
    }
}
