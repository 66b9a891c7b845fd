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
            var path = jumps.plan(map.grid().middle(from), map.grid().middle(to));
            assertThat(path.isPresent()).isEqualTo(length >= 0);
            if (path.isPresent()) {
                found++;
                assertThat(path.get().length()).isLessThanOrEqualTo(1.02 * length * 0.05 / 10 + 1e-9);
                for (int leg = 1; leg < path.get().points().size(); leg++) {
                    assertThat(map.straightCost(
                                    path.get().points().get(leg - 1),
                                    path.get().points().get(leg)))
                            .isFinite();
                }
            }
        }
        assertThat(found).isGreaterThan(10);
    }

    @Test
    void goesThroughTheDoorAtAnyAngle() {
        Path2d path = new JumpPoints(costs(ROOMS.grid(), 0))
                .plan(ROOMS.place('a'), ROOMS.place('b'))
                .orElseThrow();
        assertThat(path.points().getFirst()).isEqualTo(ROOMS.place('a'));
        assertThat(path.points().getLast()).isEqualTo(ROOMS.place('b'));
        assertThat(path.length()).isCloseTo(ROOMS.place('a').distanceTo(ROOMS.place('b')), within(0.1));
    }

    @Test
    void findsNoWayWhereThereIsNone() {
        var jumps = new JumpPoints(costs(ROOMS.grid(), 0));
        assertThat(jumps.plan(ROOMS.place('a'), ROOMS.place('x'))).isEmpty();
        assertThat(jumps.plan(ROOMS.place('a'), new Point2d(0.05, 0.05))).isEmpty();
        assertThat(jumps.plan(new Point2d(-3, 0), ROOMS.place('a'))).isEmpty();
        assertThat(jumps.plan(ROOMS.place('a'), ROOMS.place('a')).orElseThrow().length())
                .isZero();
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
