package rsal.navigation.wavefront;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.Arrays;
import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import rsal.data.OccupancyGrid;
import rsal.data.Path2d;
import rsal.data.Point2d;
import rsal.navigation.grid.DistanceField;
import rsal.navigation.grid.RandomMaps;
import rsal.navigation.wavefront.CostMap.Clearance;
import rsal.testkit.DrawnMap;

class WavefrontTest {
    private static final DrawnMap ROOMS = DrawnMap.grid(0.1, """
            ########################################
            #..................#...................#
            #..................#...................#
            #..a...............#...............b...#
            #..................#...................#
            #..................#...................#
            #......................................#
            #......................................#
            #......................................#
            #..................#...................#
            #..................#...................#
            #..................#...................#
            #..................#...........#########
            #..................#...........#.......#
            #..................#...........#...x...#
            #..................#..........w#.......#
            ########################################""");

    private static final Clearance NARROW = new Clearance(0.12, 0.4, 3);

    @ParameterizedTest
    @ValueSource(longs = {1, 2, 3, 4, 5, 6, 7, 8})
    void costsWhatASlowSearchFinds(long seed) {
        var random = new SplittableRandom(seed);
        CostMap map = costs(RandomMaps.of(random, 40, 30, 0.2), new Clearance(0, 0.2, 3));
        int goal = passable(map, random);
        int[] slow = slowly(map, goal);
        assertThat(new Wavefront(map).field(goal, -1)).as("seed %d", seed).isEqualTo(slow);
        for (int i = 0; i < 20; i++) {
            int start = passable(map, random);
            assertThat(new Wavefront(map).field(goal, start)[start])
                    .as("seed %d, from %d", seed, start)
                    .isEqualTo(slow[start]);
        }
    }

    @Test
    void leadsThroughTheDoorAndKeepsOffTheWalls() {
        CostMap map = costs(ROOMS.grid(), NARROW);
        Path2d path = found(map, ROOMS.place('a'), ROOMS.place('b')).path();
        assertThat(path.points().getFirst()).isEqualTo(ROOMS.place('a'));
        assertThat(path.points().getLast()).isEqualTo(ROOMS.place('b'));
        assertThat(leastDistance(path, ROOMS.grid())).isGreaterThan(0.1);
        assertThat(path.length()).isBetween(3.2, 3.8);
    }

    @Test
    void anEmptyFloorIsCrossedStraight() {
        var empty = new OccupancyGrid(100, 100, 0.1, 0, 0, new byte[10_000]);
        Plan.Found plan = found(costs(empty, new Clearance(0.2, 0.5, 3)), new Point2d(2, 2), new Point2d(8, 5));
        assertThat(plan.path().length()).isCloseTo(Math.hypot(6, 3), within(0.05));
    }

    @Test
    void nearnessToWallsMakesAWayDearer() {
        Point2d a = ROOMS.place('a');
        Point2d b = ROOMS.place('b');
        double cheap =
                found(costs(ROOMS.grid(), new Clearance(0.12, 0.4, 0)), a, b).cost();
        double dear =
                found(costs(ROOMS.grid(), new Clearance(0.12, 0.4, 5)), a, b).cost();
        assertThat(dear).isGreaterThan(cheap + 0.1);
    }

    @Test
    void whatIsTooWideForTheDoorFindsNoWay() {
        CostMap map = costs(ROOMS.grid(), new Clearance(0.2, 0.4, 3));
        assertThat(why(new Wavefront(map).plan(ROOMS.place('a'), ROOMS.place('b'), 0.1)))
                .contains("fits through");
    }

    @Test
    void saysWhyThereIsNoWay() {
        var wavefront = new Wavefront(costs(ROOMS.grid(), NARROW));
        Point2d a = ROOMS.place('a');
        assertThat(why(wavefront.plan(a, new Point2d(0.05, 0.05), 1))).contains("in a wall");
        assertThat(why(wavefront.plan(a, new Point2d(99, 0), 1))).contains("goal (99.00, 0.00) is outside");
        assertThat(why(wavefront.plan(new Point2d(-1, 0), a, 1))).contains("start (-1.00, 0.00) is outside");
        assertThat(why(wavefront.plan(a, ROOMS.place('x'), 0.1))).contains("fits through");
        assertThat(why(wavefront.plan(a, ROOMS.place('w'), 0))).contains("too near");
    }

    @Test
    void aGoalTooNearToAWallIsReplacedByAPlaceBesideIt() {
        Path2d path = found(costs(ROOMS.grid(), NARROW), ROOMS.place('a'), ROOMS.place('w'))
                .path();
        assertThat(path.points().getLast().distanceTo(ROOMS.place('w'))).isBetween(0.05, 0.3);
    }

    @Test
    void aStartTooNearToAWallIsLeft() {
        CostMap map = costs(ROOMS.grid(), NARROW);
        Path2d path = found(map, ROOMS.place('w'), ROOMS.place('a')).path();
        assertThat(path.points().getFirst()).isEqualTo(ROOMS.place('w'));
        assertThat(map.isPassable(path.points().get(1))).isTrue();
    }

    @Test
    void obstaclesThatAreNotOnTheMapAreAvoided() {
        CostMap map = costs(ROOMS.grid(), NARROW);
        Point2d obstacle = new Point2d(1.0, 0.8);
        CostMap changed = map.with(List.of(obstacle));
        Path2d path = found(changed, ROOMS.place('a'), new Point2d(1.0, 0.35)).path();
        for (int i = 1; i < path.points().size(); i++) {
            assertThat(changed.straightCost(
                            path.points().get(i - 1), path.points().get(i)))
                    .isFinite();
        }
        assertThat(changed.isPassable(obstacle)).isFalse();
        assertThat(map.isPassable(obstacle))
                .as("the map itself stays as it was")
                .isTrue();
    }

    private static CostMap costs(OccupancyGrid map, Clearance clearance) {
        return CostMap.of(map, DistanceField.toNotFree(map), clearance);
    }

    private static Plan.Found found(CostMap map, Point2d start, Point2d goal) {
        Plan plan = new Wavefront(map).plan(start, goal, 0.3);
        assertThat(plan).isInstanceOf(Plan.Found.class);
        return (Plan.Found) plan;
    }

    private static String why(Plan plan) {
        assertThat(plan).isInstanceOf(Plan.None.class);
        return ((Plan.None) plan).why();
    }

    private static double leastDistance(Path2d path, OccupancyGrid grid) {
        var field = DistanceField.toNotFree(grid);
        double least = Double.POSITIVE_INFINITY;
        for (int i = 1; i < path.points().size(); i++) {
            Point2d a = path.points().get(i - 1);
            Point2d b = path.points().get(i);
            for (double share = 0; share <= 1; share += 0.02) {
                double x = a.x() + share * (b.x() - a.x());
                double y = a.y() + share * (b.y() - a.y());
                least = Math.min(least, field.at(x, y));
            }
        }
        return least;
    }

    private static int passable(CostMap map, SplittableRandom random) {
        while (true) {
            int cell = random.nextInt(map.costs().length);
            if (map.costs()[cell] != CostMap.BLOCKED) {
                return cell;
            }
        }
    }

    /// Bellman and Ford: all steps again and again, until nothing changes.
    private static int[] slowly(CostMap map, int goal) {
        int width = map.grid().width();
        byte[] costs = map.costs();
        var field = new int[costs.length];
        Arrays.fill(field, Wavefront.UNREACHED);
        field[goal] = 0;
        boolean changed = true;
        while (changed) {
            changed = false;
            for (int cell = 0; cell < costs.length; cell++) {
                for (int way = 0; way < 9 && field[cell] != Wavefront.UNREACHED; way++) {
                    int dx = way % 3 - 1;
                    int dy = way / 3 - 1;
                    int next = cell + dy * width + dx;
                    boolean diagonal = dx != 0 && dy != 0;
                    boolean open = costs[next] != CostMap.BLOCKED
                            && costs[cell + dx] != CostMap.BLOCKED
                            && costs[cell + dy * width] != CostMap.BLOCKED;
                    int reached = field[cell] + (diagonal ? costs[next] * 14 / 10 : costs[next]);
                    if (open && next != cell && reached < field[next]) {
                        field[next] = reached;
                        changed = true;
                    }
                }
            }
        }
        return field;
    }
}
