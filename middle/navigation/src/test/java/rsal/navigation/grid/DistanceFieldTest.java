package rsal.navigation.grid;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.Arrays;
import java.util.SplittableRandom;
import java.util.function.IntPredicate;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import rsal.data.OccupancyGrid;
import rsal.data.Pose2d;
import rsal.testkit.DrawnMap;
import rsal.testkit.ObviousRays;

class DistanceFieldTest {
    @ParameterizedTest
    @ValueSource(longs = {1, 2, 3, 4, 5, 6, 7, 8})
    void agreesWithLookingAtEveryCell(long seed) {
        var random = new SplittableRandom(seed);
        int width = random.nextInt(1, 50);
        int height = random.nextInt(1, 50);
        OccupancyGrid map = RandomMaps.of(random, width, height, random.nextDouble());
        double deepest = random.nextDouble(0.2);
        var toOccupied = DistanceField.toOccupied(map);
        var toNotFree = DistanceField.toNotFree(map);
        var toFace = DistanceField.toFace(map, deepest);
        int[] occupied = cells(map, other -> isOccupied(map, other));
        int[] notFree = cells(map, other -> map.cells()[other] != OccupancyGrid.FREE);
        int[] faces = cells(map, other -> isOccupied(map, other) && !isAmidOccupied(map, other));
        for (int cell = 0; cell < width * height; cell++) {
            assertThat((double) toOccupied.at(cell))
                    .as("seed %d, cell %d", seed, cell)
                    .isCloseTo(nearest(map, cell, occupied), within(1e-5));
            assertThat((double) toNotFree.at(cell))
                    .as("seed %d, cell %d", seed, cell)
                    .isCloseTo(nearest(map, cell, notFree), within(1e-5));
            double face = nearest(map, cell, faces);
            assertThat((double) toFace.at(cell))
                    .as("seed %d, cell %d", seed, cell)
                    .isCloseTo(isOccupied(map, cell) ? Math.min(deepest, face) : face, within(1e-5));
        }
    }

    @ParameterizedTest
    @ValueSource(longs = {1, 2, 3, 4, 5, 6, 7, 8})
    void hitsInManyDirectionsAreThoseInEach(long seed) {
        var random = new SplittableRandom(seed);
        OccupancyGrid map = RandomMaps.of(random, random.nextInt(1, 80), random.nextInt(1, 80), 0.02);
        var field = DistanceField.toOccupied(map);
        int directions = 40;
        double[] cos = IntStream.range(0, directions)
                .mapToDouble(i -> Math.cos(2 * Math.PI * i / directions))
                .toArray();
        double[] sin = IntStream.range(0, directions)
                .mapToDouble(i -> Math.sin(2 * Math.PI * i / directions))
                .toArray();
        for (int place = 0; place < 200; place++) {
            double x = map.originX() + random.nextDouble(-0.1, 1.1) * map.width() * map.resolution();
            double y = map.originY() + random.nextDouble(-0.1, 1.1) * map.height() * map.resolution();
            double limit = random.nextDouble(0, 6);
            int from = random.nextInt(directions);
            double[] hits = new double[random.nextInt(directions - from)];
            field.firstHits(x, y, cos, sin, from, limit, hits);
            assertThat(field.nearestHit(x, y, cos, sin, from, hits.length, limit))
                    .as("seed %d, (%s, %s), from %d, limit %s", seed, x, y, from, limit)
                    .isEqualTo(Arrays.stream(hits).min().orElse(Double.POSITIVE_INFINITY));
            for (int i = 0; i < hits.length; i++) {
                assertThat(hits[i])
                        .as("seed %d, (%s, %s), direction %d, limit %s", seed, x, y, from + i, limit)
                        .isEqualTo(field.firstHit(x, y, cos[from + i], sin[from + i], limit));
            }
        }
    }

    @Test
    void nothingIsInfinitelyFar() {
        var empty = new OccupancyGrid(7, 5, 0.1, 0, 0, new byte[35]);
        assertThat(DistanceField.toOccupied(empty).at(17)).isEqualTo(Float.POSITIVE_INFINITY);
    }

    @ParameterizedTest
    @ValueSource(longs = {1, 2, 3, 4})
    void seesAsFarAsARayThatIsCutWithEveryWall(long seed) {
        var random = new SplittableRandom(seed);
        var map = DrawnMap.grid(0.1, """
                ##############################
                #............................#
                #...####.....................#
                #...####..........#..........#
                #.................#..........#
                #.........@.......#..........#
                #............................#
                #.......................###..#
                #............................#
                ##############################""");
        var field = DistanceField.toOccupied(map.grid());
        var rays = new ObviousRays(map.grid());
        int grazed = 0;
        for (int i = 0; i < 400; i++) {
            Pose2d from = map.pose('@', 360 * random.nextDouble());
            double seen = field.castRay(from.x(), from.y(), from.theta(), 10);
            double exact = rays.range(from);
            assertThat(seen).as("seed %d, direction %s", seed, from.theta()).isGreaterThan(exact - 0.05);
            grazed += seen > exact + 0.05 ? 1 : 0;
        }
        assertThat(grazed).as("corners overlooked, seed %d", seed).isLessThan(8);
    }

    @Test
    void seesNoFartherThanTheLimit() {
        var empty = new OccupancyGrid(100, 100, 0.1, 0, 0, new byte[10_000]);
        assertThat(DistanceField.toOccupied(empty).castRay(5, 5, 1, 2)).isEqualTo(2);
    }

    @Test
    void theEndOfTheMapIsNoWall() {
        var cells = new byte[10_000];
        cells[50 * 100 + 80] = OccupancyGrid.OCCUPIED;
        var field = DistanceField.toOccupied(new OccupancyGrid(100, 100, 0.1, 0, 0, cells));

        assertThat(field.castRay(5, 5.05, 0, 20)).isCloseTo(3, within(0.1));
        assertThat(field.firstHit(5, 5.05, 0, 20)).isCloseTo(3, within(0.1));
        assertThat(field.firstHit(5, 5.05, 0, 2)).isInfinite();
        assertThat(field.firstHit(5, 5.05, Math.PI, 20)).isInfinite();
        assertThat(field.firstHit(-1, 5, 0, 20)).isZero();
    }

    private static boolean isOccupied(OccupancyGrid map, int cell) {
        return map.cells()[cell] == OccupancyGrid.OCCUPIED;
    }

    private static boolean isAmidOccupied(OccupancyGrid map, int cell) {
        return IntStream.range(0, map.cells().length)
                .filter(other -> Math.abs(other % map.width() - cell % map.width()) <= 1
                        && Math.abs(other / map.width() - cell / map.width()) <= 1)
                .allMatch(other -> isOccupied(map, other));
    }

    private static int[] cells(OccupancyGrid map, IntPredicate which) {
        return IntStream.range(0, map.cells().length).filter(which).toArray();
    }

    private static double nearest(OccupancyGrid map, int cell, int[] targets) {
        double nearest = Double.POSITIVE_INFINITY;
        for (int other : targets) {
            int dx = other % map.width() - cell % map.width();
            int dy = other / map.width() - cell / map.width();
            nearest = Math.min(nearest, map.resolution() * Math.hypot(dx, dy));
        }
        return nearest;
    }
}
