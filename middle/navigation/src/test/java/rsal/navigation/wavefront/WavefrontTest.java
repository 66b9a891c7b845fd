package rsal.navigation.wavefront;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatExceptionOfType;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Set;
import java.util.SplittableRandom;
import java.util.TreeSet;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import java.util.stream.IntStream;
import java.util.stream.Stream;
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
import rsal.testkit.LongTest;

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
    void reachesEverythingForWhatASlowSearchFinds(long seed) {
        var random = new SplittableRandom(seed);
        int weight = random.nextInt(6);
        reachesEverything(costs(RandomMaps.of(random, 40, 30, 0.2), new Clearance(0, 0.2, weight)), random, seed);
    }

    @ParameterizedTest
    @ValueSource(longs = {1, 2, 3, 4, 5, 6, 7, 8})
    void overPlainsItCostsWhatASlowSearchFinds(long seed) {
        var random = new SplittableRandom(seed);
        double comfort = random.nextInt(3) * 0.1;
        reachesEverything(
                costs(RandomMaps.of(random, 200, 40, 0.002 * (1 + seed)), new Clearance(0.06, 0.06 + comfort, 3)),
                random,
                seed);
    }

    private static void reachesEverything(CostMap map, SplittableRandom random, long seed) {
        var wave = new Wave(map);
        var guided = new Wave(map);
        for (int i = 0; i < 10; i++) {
            int source = passable(map, random);
            int[] slow = slowly(map, source, Set.of());
            wave.clear(); // however far it had spread
            assertThat(field(wave, map)).containsOnly(Wave.UNREACHED);
            wave.start(source);
            int targets = random.nextInt(10); // it may be asked to go on
            for (int j = 0; j < targets; j++) {
                int target = passable(map, random);
                boolean reached = wave.spread(target);
                assertThat(wave.at(target)).as("seed %d", seed).isEqualTo(slow[target]);
                assertThat(reached).isEqualTo(slow[target] != Wave.UNREACHED);
            }
            int hurried = passable(map, random);
            guided.clear();
            guided.start(source, octile(hurried, map.grid().width()));
            guided.spread(hurried);
            assertThat(guided.at(hurried)).as("seed %d", seed).isEqualTo(slow[hurried]);
            if (random.nextBoolean()) {
                wave.spread(-1);
                assertThat(field(wave, map)).as("seed %d", seed).isEqualTo(slow);
            }
        }
    }

    @Test
    @LongTest
    void refusesWaysThatAreTooLongToCount() {
        var wave = new Wave(meander(4400, 4203));
        wave.start(4401);
        assertThatExceptionOfType(Wave.TooFar.class)
                .isThrownBy(() -> wave.spread(-1))
                .withMessageContaining("(4400 × 4203) cells get too long");
    }

    /// No way to there is known, and why: whoever asked goes on.
    @Test
    @LongTest
    void aWayThatIsTooLongToCountIsNone() {
        CostMap map = meander(4400, 4203);
        var ways = new Wavefront(map);
        Point2d start = map.grid().middle(4401);
        Point2d near = map.grid().middle(4401 + 100);
        Point2d far = map.grid().middle(4201 * 4400 + 2200);

        assertThat(ways.plan(start, far, 0.1))
                .isInstanceOfSatisfying(
                        Plan.None.class, none -> assertThat(none.why()).contains("(4400 × 4203) cells get too long"));
        assertThat(ways.costs(start, List.of(far, near), 0.1))
                .satisfiesExactly(
                        toFar -> assertThat(toFar).isEqualTo(Double.POSITIVE_INFINITY),
                        toNear -> assertThat(toNear).isLessThan(100));
        NavigationFunction everywhere = ways.everywhere(start, 0.1).orElseThrow();
        assertThat(everywhere.cost(near)).isLessThan(100);
        assertThat(everywhere.cost(far)).isEqualTo(Double.POSITIVE_INFINITY);
    }

    /// One way to and fro, a cell wide, as dear as can be.
    private static CostMap meander(int width, int height) {
        var cells = new byte[width * height];
        Arrays.fill(cells, OccupancyGrid.OCCUPIED);
        for (int row = 1; row < height - 1; row++) {
            boolean right = row / 2 % 2 == 0;
            int first = row % 2 == 1 || !right ? 1 : width - 2;
            int last = row % 2 == 1 || right ? width - 2 : 1;
            Arrays.fill(cells, row * width + first, row * width + last + 1, OccupancyGrid.FREE);
        }
        return costs(new OccupancyGrid(width, height, 0.05, 0, 0, cells), new Clearance(0.02, 10, 5));
    }

    @Test
    void askingForWhatIsOutOfReachChangesNothing() {
        CostMap map = costs(ROOMS.grid(), NARROW);
        var wave = new Wave(map);
        wave.start(ROOMS.grid().cell(ROOMS.place('a')));
        int shutIn = ROOMS.grid().cell(ROOMS.place('x'));
        assertThat(wave.spread(shutIn)).isFalse();
        int known = wave.known();
        assertThat(wave.spread(shutIn)).isFalse();
        assertThat(wave.known()).isEqualTo(known);
    }

    @ParameterizedTest
    @ValueSource(longs = {1, 2, 3, 4, 5, 6, 7, 8})
    void plansTheSameWhateverWasPlannedBefore(long seed) {
        var random = new SplittableRandom(seed);
        CostMap map = costs(RandomMaps.of(random, 60, 50, 0.03), new Clearance(0.06, 0.2, 3));
        var experienced = new Wavefront(map);
        Point2d goal = place(map, random);
        int found = 0;
        for (int i = 0; i < 60; i++) {
            goal = random.nextInt(3) == 0 ? place(map, random) : goal;
            Point2d start = place(map, random);
            List<Point2d> obstacles =
                    random.nextBoolean() ? List.of() : List.of(place(map, random), place(map, random));
            Plan plan = experienced.plan(start, goal, 0.1, obstacles);
            assertThat(plan).as("seed %d, %d", seed, i).isEqualTo(new Wavefront(map).plan(start, goal, 0.1, obstacles));
            found += plan instanceof Plan.Found ? 1 : 0;
        }
        assertThat(found).isBetween(20, 60);
    }

    @ParameterizedTest
    @ValueSource(longs = {1, 2, 3, 4, 5, 6, 7, 8})
    void aroundObstaclesItCostsWhatASlowSearchFinds(long seed) {
        var random = new SplittableRandom(seed);
        CostMap map = costs(RandomMaps.of(random, 40, 30, 0.03), new Clearance(0.06, 0.2, 3));
        var wavefront = new Wavefront(map);
        int goal = passable(map, random);
        for (int i = 0; i < 20; i++) {
            int start = passable(map, random);
            var blocked = new TreeSet<Integer>();
            List<Point2d> obstacles = List.of(place(map, random), place(map, random));
            obstacles.forEach(obstacle -> map.around(obstacle, blocked::add));
            if (blocked.contains(start) || blocked.contains(goal)) {
                continue;
            }
            int slow = slowly(map, goal, blocked)[start];
            Plan plan = wavefront.plan(map.grid().middle(start), map.grid().middle(goal), 0, obstacles);
            assertThat(plan instanceof Plan.Found).isEqualTo(slow != Wave.UNREACHED);
            if (plan instanceof Plan.Found(Path2d path, double cost, double offGoal)) {
                assertThat(cost).as("seed %d", seed).isCloseTo(slow * 0.05 / CostMap.SIDE, within(1e-9));
                assertThat(offGoal).isZero();
                for (Point2d obstacle : obstacles) {
                    assertThat(path.points()).allMatch(point -> point.distanceTo(obstacle) > 0.03);
                }
            }
        }
    }

    @Test
    void severalMayAskAtOnce() throws Exception {
        CostMap map = costs(ROOMS.grid(), NARROW);
        var random = new SplittableRandom(5);
        var shared = new Wavefront(map);
        List<Point2d> places =
                Stream.generate(() -> place(map, random)).limit(12).toList();
        try (var threads = Executors.newFixedThreadPool(4)) {
            var asked = new ArrayList<Future<Plan>>();
            for (int i = 0; i < 400; i++) {
                Point2d start = places.get(i % 7);
                Point2d goal = places.get(7 + i % 5);
                List<Point2d> obstacles = i % 3 == 0 ? List.of(places.get(i % 12)) : List.of();
                asked.add(threads.submit(() -> shared.plan(start, goal, 0.3, obstacles)));
            }
            for (int i = 0; i < 400; i++) {
                List<Point2d> obstacles = i % 3 == 0 ? List.of(places.get(i % 12)) : List.of();
                assertThat(asked.get(i).get())
                        .isEqualTo(new Wavefront(map).plan(places.get(i % 7), places.get(7 + i % 5), 0.3, obstacles));
            }
        }
    }

    @Test
    void reportsWhatThePathCostsFromEverywhere() {
        var wavefront = new Wavefront(costs(ROOMS.grid(), NARROW));
        Point2d a = ROOMS.place('a');
        NavigationFunction toA = wavefront.everywhere(a, 0).orElseThrow();
        Plan.Found plan = (Plan.Found) wavefront.plan(ROOMS.place('b'), a, 0);
        assertThat(toA.cost(ROOMS.place('b'))).isCloseTo(plan.cost(), within(0.1));
        assertThat(toA.cost(ROOMS.place('x'))).isInfinite();
        assertThat(toA.cost(new Point2d(0.05, 0.05))).as("in a wall").isInfinite();
        assertThat(toA.cost(new Point2d(99, 0))).as("outside").isInfinite();
        assertThat(wavefront.everywhere(new Point2d(99, 0), 1)).isEmpty();
        assertThat(wavefront.everywhere(new Point2d(0.05, 0.05), 0.1)).isEmpty();
    }

    @Test
    void reportsWhatThePathToTheNearestOfSeveralGoalsCosts() {
        OccupancyGrid grid = ROOMS.grid();
        var wavefront = new Wavefront(costs(grid, NARROW));
        List<Point2d> goals = List.of(ROOMS.place('a'), new Point2d(99, 0), ROOMS.place('b'), ROOMS.place('a'));
        NavigationFunction toAny = wavefront.everywhere(goals, 0).orElseThrow();
        NavigationFunction toA = wavefront.everywhere(goals.getFirst(), 0).orElseThrow();
        NavigationFunction toB = wavefront.everywhere(goals.get(2), 0).orElseThrow();
        for (int cell = 0; cell < grid.cells().length; cell++) {
            Point2d place = grid.middle(cell);
            assertThat(toAny.cost(place)).as("%s", place).isEqualTo(Math.min(toA.cost(place), toB.cost(place)));
        }
        assertThat(wavefront.everywhere(List.of(), 1)).isEmpty();
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
    void aClearanceHasAnEnd() {
        assertThatIllegalArgumentException()
                .isThrownBy(() -> new Clearance(0.3, Double.POSITIVE_INFINITY, 3))
                .withMessageContaining("Infinity");
        assertThatIllegalArgumentException().isThrownBy(() -> new Clearance(0.3, Double.NaN, 3));
    }

    @Test
    void whatIsTooWideForTheDoorFindsNoWay() {
        CostMap map = costs(ROOMS.grid(), new Clearance(0.2, 0.4, 3));
        assertThat(why(new Wavefront(map).plan(ROOMS.place('a'), ROOMS.place('b'), 0.1)))
                .contains("wide enough");
    }

    @Test
    void saysWhyThereIsNoWay() {
        var wavefront = new Wavefront(costs(ROOMS.grid(), NARROW));
        Point2d a = ROOMS.place('a');
        assertThat(why(wavefront.plan(a, new Point2d(0.05, 0.05), 0.1)))
                .contains("in a wall; the nearest place for it is (0.25, 0.25)");
        assertThat(why(wavefront.plan(a, new Point2d(99, 0), 1))).contains("goal (99.00, 0.00) is outside");
        assertThat(why(wavefront.plan(new Point2d(-1, 0), a, 1))).contains("start (-1.00, 0.00) is outside");
        assertThat(why(wavefront.plan(a, ROOMS.place('x'), 0.1))).contains("wide enough");
        assertThat(why(wavefront.plan(a, ROOMS.place('w'), 0))).contains("too near");
    }

    @Test
    void aGoalTooNearToAWallIsReplacedByAPlaceBesideIt() {
        Path2d path = found(costs(ROOMS.grid(), NARROW), ROOMS.place('a'), ROOMS.place('w'))
                .path();
        assertThat(path.points().getLast().distanceTo(ROOMS.place('w'))).isBetween(0.05, 0.3);
    }

    @Test
    void aGoalToWhichNothingLeadsIsReplacedByOneToWhichSomethingDoes() {
        var drawn = DrawnMap.grid(0.1, """
                ####################
                #........#.........#
                #.......g#....a....#
                #........#.........#
                ####################
                """);
        CostMap map = costs(drawn.grid(), new Clearance(0.05, 0.1, 1));
        Point2d goal = drawn.place('g');
        var wavefront = new Wavefront(map);
        for (List<Point2d> obstacles : List.<List<Point2d>>of(List.of(), List.of(new Point2d(0.2, 0.2)))) {
            for (int asked = 0; asked < 3; asked++) {
                assertThat(wavefront.plan(drawn.place('a'), goal, 0.25, obstacles))
                        .isInstanceOfSatisfying(
                                Plan.Found.class,
                                found -> assertThat(found.offGoal()).isCloseTo(0.2, within(1e-9)));
                assertThat(wavefront.plan(drawn.place('a'), goal, 0.15, obstacles))
                        .isInstanceOf(Plan.None.class);
            }
        }
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
        var wavefront = new Wavefront(map);
        Point2d goal = new Point2d(1.0, 0.35);
        Plan around = wavefront.plan(ROOMS.place('a'), goal, 0.3, List.of(obstacle));
        assertThat(around).isInstanceOfSatisfying(Plan.Found.class, found -> {
            for (int i = 0; i <= 1000; i++) {
                assertThat(at(found.path(), i / 1000.0).distanceTo(obstacle)).isGreaterThan(0.1);
            }
        });
        assertThat(wavefront.plan(ROOMS.place('a'), goal, 0.3))
                .as("the map itself stays as it was")
                .isEqualTo(new Wavefront(map).plan(ROOMS.place('a'), goal, 0.3));
    }

    private static Point2d at(Path2d path, double share) {
        double left = share * path.length();
        for (int i = 1; i < path.points().size(); i++) {
            Point2d a = path.points().get(i - 1);
            Point2d b = path.points().get(i);
            double length = a.distanceTo(b);
            if (left <= length) {
                double part = length == 0 ? 0 : left / length;
                return new Point2d(a.x() + part * (b.x() - a.x()), a.y() + part * (b.y() - a.y()));
            }
            left -= length;
        }
        return path.points().getLast();
    }

    private static Wave.Guide octile(int target, int width) {
        return cell -> {
            int dx = Math.abs(cell % width - target % width);
            int dy = Math.abs(cell / width - target / width);
            return 20 * Math.max(dx, dy) + 8 * Math.min(dx, dy);
        };
    }

    private static int[] field(Wave wave, CostMap map) {
        return IntStream.range(0, map.ground().length)
                .map(cell -> wave.isOpen(cell) ? wave.at(cell) : Wave.UNREACHED)
                .toArray();
    }

    private static Point2d place(CostMap map, SplittableRandom random) {
        return map.grid().middle(passable(map, random));
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
            int cell = random.nextInt(map.ground().length);
            if (map.ground()[cell] != CostMap.BLOCKED) {
                return cell;
            }
        }
    }

    /// Bellman and Ford: all steps again and again, until nothing changes.
    private static int[] slowly(CostMap map, int goal, Set<Integer> blocked) {
        int width = map.grid().width();
        byte[] ground = map.ground().clone();
        blocked.forEach(cell -> ground[cell] = CostMap.BLOCKED);
        var field = new int[ground.length];
        Arrays.fill(field, Wave.UNREACHED);
        field[goal] = 0;
        boolean changed = true;
        while (changed) {
            changed = false;
            for (int cell = 0; cell < ground.length; cell++) {
                for (int distance = 0; distance < 9 && field[cell] != Wave.UNREACHED; distance++) {
                    int dx = distance % 3 - 1;
                    int dy = distance / 3 - 1;
                    int next = cell + dy * width + dx;
                    boolean diagonal = dx != 0 && dy != 0;
                    boolean open = ground[next] != CostMap.BLOCKED
                            && ground[cell + dx] != CostMap.BLOCKED
                            && ground[cell + dy * width] != CostMap.BLOCKED;
                    int step = CostMap.cost(ground[cell]) + CostMap.cost(ground[next]);
                    int reached = field[cell] + (diagonal ? step * 181 / 128 : step);
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
