package rsal.navigation.jumppoint;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.Arrays;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import rsal.data.OccupancyGrid;
import rsal.data.Path2d;
import rsal.data.Point2d;
import rsal.navigation.grid.DistanceField;
import rsal.navigation.grid.RandomMaps;
import rsal.navigation.wavefront.CostMap;
import rsal.navigation.wavefront.CostMap.Clearance;
import rsal.navigation.wavefront.Plan;
import rsal.testkit.DrawnMap;

class JumpPointsTest {
    private static final DrawnMap ROOMS = DrawnMap.grid(0.1, """
            ####################
            #a.......#.........#
            #........#.........#
            #........#.........#
            #..................#
            #..................#
            #........#.......b.#
            #........#..########
            #........#..#.....x#
            ####################""");

    @ParameterizedTest
    @ValueSource(doubles = {0, 0.05, 0.1, 0.2, 0.3})
    void waysAreAsLongAsThoseOfASlowSearch(double occupied) {
        var random = new SplittableRandom((long) (1000 * occupied));
        int reached = 0;
        for (int i = 0; i < 40; i++) {
            CostMap map = costs(RandomMaps.of(random, 1 + random.nextInt(150), 1 + random.nextInt(20), occupied), 0);
            var jumps = new JumpPoints(map);
            for (int start = 0; start < 4; start++) {
                int from = random.nextInt(cells(map));
                if (!map.isOpen(from)) {
                    continue;
                }
                int[] slow = slowly(map, from);
                for (int goal = 0; goal < 10; goal++) {
                    int to = random.nextInt(cells(map));
                    if (map.isOpen(to)) {
                        assertThat(jumps.search(from, to))
                                .as("map %d, %d to %d", i, from, to)
                                .isEqualTo(slow[to]);
                        reached += slow[to] > 0 ? 1 : 0;
                    }
                }
            }
        }
        assertThat(reached).isGreaterThan(50);
    }

    @ParameterizedTest
    @ValueSource(longs = {1, 2, 3, 4, 5})
    void noWayIsLongerThanOverNeighborsNorThroughAnything(long seed) {
        var random = new SplittableRandom(seed);
        CostMap map = costs(RandomMaps.of(random, 120, 90, 0.02), 0.06);
        var jumps = new JumpPoints(map);
        int found = 0;
        for (int i = 0; i < 40; i++) {
            int from = random.nextInt(cells(map));
            int to = random.nextInt(cells(map));
            if (!map.isOpen(from) || !map.isOpen(to)) {
                continue;
            }
            int length = jumps.search(from, to);
            Plan plan = jumps.plan(map.grid().middle(from), map.grid().middle(to), 0);
            assertThat(plan instanceof Plan.Found).isEqualTo(length >= 0);
            if (plan instanceof Plan.Found(Path2d path, double cost, double offGoal)) {
                found++;
                assertThat(cost).isEqualTo(path.length()).isLessThanOrEqualTo(1.02 * length * 0.05 / 10 + 1e-9);
                assertThat(offGoal).isZero();
                for (int leg = 1; leg < path.points().size(); leg++) {
                    assertThat(map.straightCost(
                                    path.points().get(leg - 1), path.points().get(leg)))
                            .isFinite();
                }
            }
        }
        assertThat(found).isGreaterThan(10);
    }

    @Test
    void goesThroughTheDoorAtAnyAngle() {
        Path2d path = way(ROOMS.place('a'), ROOMS.place('b'), 0).path();
        assertThat(path.points().getFirst()).isEqualTo(ROOMS.place('a'));
        assertThat(path.points().getLast()).isEqualTo(ROOMS.place('b'));
        assertThat(path.length()).isCloseTo(ROOMS.place('a').distanceTo(ROOMS.place('b')), within(0.1));
    }

    @Test
    void saysWhyItFindsNoWay() {
        assertThat(whyNot(ROOMS.place('a'), ROOMS.place('x'))).contains("No path that is wide enough");
        assertThat(whyNot(ROOMS.place('a'), new Point2d(0.05, 0.05))).contains("(0.05, 0.05) is in a wall");
        assertThat(whyNot(new Point2d(-3, 0), ROOMS.place('a'))).contains("The start (-3.00, 0.00) is outside");
        assertThat(whyNot(ROOMS.place('a'), new Point2d(-3, 0))).contains("The goal (-3.00, 0.00) is outside");
    }

    @Test
    void endsBesideAGoalThatNoWayLeadsTo() {
        Point2d shutIn = ROOMS.place('x');
        Plan.Found way = way(ROOMS.place('a'), shutIn, 0.7);
        assertThat(way.offGoal()).isCloseTo(0.2, within(1e-9)); // beyond the wall above it
        assertThat(way.path().points().getLast().y()).isGreaterThan(shutIn.y());
    }

    @Test
    void goesNowhereForAGoalThatIsHere() {
        assertThat(way(ROOMS.place('a'), ROOMS.place('a'), 0).path().length()).isZero();
    }

    @Test
    void leavesAWallAndEndsBesideOne() {
        var inWall = new Point2d(ROOMS.place('a').x(), 0.95);
        var start = new Point2d(0.05, ROOMS.place('a').y());
        Plan.Found way = way(start, inWall, 0.2);
        assertThat(way.path().points().getFirst()).isEqualTo(start);
        assertThat(way.path().points().getLast()).isEqualTo(ROOMS.place('a'));
        assertThat(way.offGoal()).isCloseTo(0.1, within(1e-9));
        assertThat(way.cost()).isEqualTo(way.path().length());
    }

    private static Plan.Found way(Point2d start, Point2d goal, double slack) {
        return (Plan.Found) new JumpPoints(costs(ROOMS.grid(), 0)).plan(start, goal, slack);
    }

    private static String whyNot(Point2d start, Point2d goal) {
        return ((Plan.None) new JumpPoints(costs(ROOMS.grid(), 0)).plan(start, goal, 0)).why();
    }

    private static CostMap costs(OccupancyGrid map, double radius) {
        return CostMap.of(map, DistanceField.toNotFree(map), new Clearance(radius, radius, 0));
    }

    private static int cells(CostMap map) {
        return map.grid().width() * map.grid().height();
    }

    /// Bellman and Ford: all steps again and again, until nothing changes; −1 where no way leads.
    private static int[] slowly(CostMap map, int start) {
        int width = map.grid().width();
        boolean[] open = new boolean[cells(map)];
        for (int cell = 0; cell < open.length; cell++) {
            open[cell] = map.isOpen(cell);
        }
        int[] lengths = new int[open.length];
        Arrays.fill(lengths, -1);
        lengths[start] = 0;
        boolean changed = true;
        while (changed) {
            changed = false;
            for (int cell = 0; cell < open.length; cell++) {
                for (int way = 0; way < 9 && lengths[cell] >= 0; way++) {
                    int dx = way % 3 - 1;
                    int dy = way / 3 - 1;
                    int next = cell + dy * width + dx;
                    if (!open[next] || !open[cell + dx] || !open[cell + dy * width]) {
                        continue;
                    }
                    int length = lengths[cell] + (dx != 0 && dy != 0 ? 14 : 10);
                    if (next != cell && (lengths[next] < 0 || length < lengths[next])) {
                        lengths[next] = length;
                        changed = true;
                    }
                }
            }
        }
        return lengths;
    }
}
