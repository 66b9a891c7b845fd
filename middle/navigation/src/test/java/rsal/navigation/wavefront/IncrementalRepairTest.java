package rsal.navigation.wavefront;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.SplittableRandom;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import rsal.data.OccupancyGrid;
import rsal.data.Point2d;
import rsal.navigation.grid.DistanceField;
import rsal.navigation.grid.RandomMaps;
import rsal.navigation.wavefront.CostMap.Clearance;

/// Waves over maps that change hold what new ones do.
class IncrementalRepairTest {
    @ParameterizedTest
    @ValueSource(longs = {1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12})
    void holdsWhatANewWaveDoes(long seed) {
        var random = new SplittableRandom(seed);
        var clearance = new Clearance(0.06, 0.06 + random.nextInt(3) * 0.1, random.nextInt(6));
        var grid = RandomMaps.of(random, 60 + random.nextInt(100), 50, random.nextDouble() * 0.04);
        CostMap map = costs(grid, clearance);
        var wave = new Wave(map);
        int source = open(map, random);
        wave.start(source);
        int count = 0;
        for (int i = 0; i < 40; i++) {
            spreadSome(wave, map, random);
            int from = source;
            OccupancyGrid next = RandomMaps.changed(map.grid(), random);
            CostMap nextMap = costs(next, clearance);
            Optional<CostChanges> few = CostChanges.between(map, nextMap);
            int moved = few.map(changes -> changes.overlay().moved(from)).orElse(-1);
            if (moved < 0 || !nextMap.isOpen(moved)) {
                continue;
            }
            CostChanges changes = few.get();
            Optional<Wave> mended = wave.over(changes);
            map = nextMap;
            source = moved;
            count += mended.isPresent() ? 1 : 0;
            if (mended.isEmpty()) {
                wave = new Wave(map);
                wave.start(source);
                continue;
            }
            wave = mended.get();
            check(wave, map, source, random, "seed %d, %d".formatted(seed, i));
            if (random.nextInt(5) == 0) {
                wave.clear(); // starts anew as well
                source = open(map, random);
                wave.start(source);
            }
        }
        assertThat(count).as("mended").isGreaterThan(5);
    }

    /// What it knows is right at once, and the rest once it has spread.
    private static void check(Wave wave, CostMap map, int source, SplittableRandom random, String what) {
        var fresh = new Wave(map);
        fresh.start(source);
        fresh.spread(-1);
        for (int cell = 0; cell < map.ground().length; cell++) {
            if (map.isOpen(cell) && Math.min(wave.at(cell), fresh.at(cell)) < wave.known()) {
                assertThat(wave.at(cell)).as("%s, cell %d", what, cell).isEqualTo(fresh.at(cell));
            }
        }
        int target = open(map, random);
        wave.spread(target);
        assertThat(wave.at(target)).as(what).isEqualTo(fresh.at(target));
        if (random.nextBoolean()) {
            wave.spread(-1);
            assertThat(field(wave, map)).as(what).isEqualTo(field(fresh, map));
        }
    }

    private static void spreadSome(Wave wave, CostMap map, SplittableRandom random) {
        switch (random.nextInt(3)) {
            case 0 -> wave.spread(open(map, random));
            case 1 -> wave.spread(-1);
            default -> {} // as far as it was
        }
    }

    /// Whoever plans over maps that change plans as one who has seen none of those before.
    @ParameterizedTest
    @ValueSource(longs = {1, 2, 3, 4, 5, 6, 7, 8})
    void plansAsIfTheMapHadAlwaysBeenSo(long seed) {
        var random = new SplittableRandom(seed);
        var clearance = new Clearance(0.06, 0.2, 3);
        CostMap map = costs(RandomMaps.of(random, 150, 120, 0.005), clearance);
        var wavefront = new Wavefront(map);
        Point2d goal = map.grid().middle(open(map, random));
        int handedOn = 0;
        int found = 0;
        for (int i = 0; i < 80; i++) {
            if (random.nextInt(4) == 0) {
                CostMap next = costs(RandomMaps.changed(map.grid(), random), clearance);
                wavefront = wavefront.over(next);
                handedOn += wavefront.kept();
                map = next;
                goal = map.isPassable(goal) ? goal : map.grid().middle(open(map, random));
            }
            Point2d start = map.grid().middle(open(map, random));
            Point2d asked = random.nextInt(3) == 0 ? near(goal, random) : goal;
            List<Point2d> obstacles = random.nextInt(3) == 0 ? List.of(near(start, random)) : List.of();
            Plan plan = wavefront.plan(start, asked, 0.1, obstacles);
            assertThat(plan)
                    .as("seed %d, %d", seed, i)
                    .isEqualTo(new Wavefront(map).plan(start, asked, 0.1, obstacles));
            found += plan instanceof Plan.Found ? 1 : 0;
        }
        assertThat(handedOn).isPositive();
        assertThat(found).isGreaterThan(10);
    }

    private static Point2d near(Point2d place, SplittableRandom random) {
        return new Point2d(place.x() + random.nextDouble(-0.5, 0.5), place.y() + random.nextDouble(-0.5, 0.5));
    }

    /// Whoever still has the map before may ask while others ask of the next one.
    @Test
    void severalMayAskOfBothMapsAtOnce() throws Exception {
        var random = new SplittableRandom(3);
        var clearance = new Clearance(0.06, 0.2, 3);
        CostMap before = costs(RandomMaps.of(random, 150, 120, 0.005), clearance);
        CostMap after = costs(RandomMaps.changed(before.grid(), random), clearance);
        Point2d goal = before.grid().middle(open(before, random));
        List<Point2d> starts = Stream.generate(() -> before.grid().middle(open(before, random)))
                .limit(10)
                .toList();
        var old = new Wavefront(before);
        old.plan(starts.getFirst(), goal, 0.1);
        old.plan(starts.getFirst(), goal, 0.1);
        assertThat(old.kept()).isEqualTo(1);
        try (var threads = Executors.newFixedThreadPool(4)) {
            Wavefront next = old.over(after);
            var asked = new ArrayList<Future<Plan>>();
            for (int i = 0; i < 200; i++) {
                Wavefront wavefront = i % 3 == 0 ? old : next;
                Point2d start = starts.get(i % 10);
                asked.add(threads.submit(() -> wavefront.plan(start, goal, 0.1)));
            }
            for (int i = 0; i < 200; i++) {
                CostMap map = i % 3 == 0 ? before : after;
                assertThat(asked.get(i).get()).isEqualTo(new Wavefront(map).plan(starts.get(i % 10), goal, 0.1));
            }
        }
    }

    @Test
    void mapsOnOtherLatticesOrThatAreQuiteDifferentHandNothingOn() {
        assertThat(keptBy(new OccupancyGrid(40, 40, 0.1, 0.05, 0, new byte[1600])))
                .as("half a cell aside")
                .isZero();
        assertThat(keptBy(new OccupancyGrid(40, 40, 0.2, 0, 0, new byte[1600])))
                .as("larger cells")
                .isZero();
        assertThat(keptBy(new OccupancyGrid(40, 40, 0.1, 1e9, 0, new byte[1600])))
                .as("elsewhere")
                .isZero();
        assertThat(keptBy(new OccupancyGrid(40, 40, 0.1, 2, 0, new byte[1600])))
                .as("half of it new")
                .isZero();
        assertThat(keptBy(new OccupancyGrid(41, 40, 0.1, 0, 0, new byte[1640])))
                .as("a column more")
                .isEqualTo(1);
    }

    /// How many of one wave over a room of 40 × 40 cells are kept over another map.
    private static int keptBy(OccupancyGrid next) {
        var clearance = new Clearance(0, 0, 0);
        var wavefront = new Wavefront(costs(new OccupancyGrid(40, 40, 0.1, 0, 0, new byte[1600]), clearance));
        wavefront.plan(new Point2d(1, 1), new Point2d(3, 3), 0);
        wavefront.plan(new Point2d(1, 1), new Point2d(3, 3), 0);
        assertThat(wavefront.kept()).isEqualTo(1);
        return wavefront.over(costs(next, clearance)).kept();
    }

    @Test
    void whatNobodyAskedForOnTwoMapsIsNotHandedOn() {
        var clearance = new Clearance(0, 0, 0);
        CostMap map = costs(new OccupancyGrid(40, 40, 0.1, 0, 0, new byte[1600]), clearance);
        CostMap same = costs(new OccupancyGrid(40, 40, 0.1, 0, 0, new byte[1600]), clearance);
        Point2d start = new Point2d(1, 1);
        Point2d goal = new Point2d(3, 3);
        var wavefront = new Wavefront(map);
        wavefront.plan(start, goal, 0);
        wavefront.plan(start, goal, 0);
        wavefront = wavefront.over(same).over(map);
        assertThat(wavefront.kept()).as("asked for two maps ago").isEqualTo(1);
        wavefront.plan(start, goal, 0);
        wavefront = wavefront.over(same).over(map);
        assertThat(wavefront.kept()).as("the same after being mended").isEqualTo(1);
        assertThat(wavefront.over(same).kept()).isZero();
    }

    private static int[] field(Wave wave, CostMap map) {
        return IntStream.range(0, map.ground().length)
                .map(cell -> wave.isOpen(cell) ? wave.at(cell) : Wave.UNREACHED)
                .toArray();
    }

    private static int open(CostMap map, SplittableRandom random) {
        int cell = random.nextInt(map.ground().length);
        while (!map.isOpen(cell)) {
            cell = random.nextInt(map.ground().length);
        }
        return cell;
    }

    private static CostMap costs(OccupancyGrid map, Clearance clearance) {
        return CostMap.of(map, DistanceField.toNotFree(map), clearance);
    }
}
