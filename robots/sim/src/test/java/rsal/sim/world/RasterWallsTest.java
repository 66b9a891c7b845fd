package rsal.sim.world;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.BitSet;
import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import rsal.data.Footprint;
import rsal.data.OccupancyGrid;
import rsal.data.Point2d;
import rsal.data.Pose2d;
import rsal.scene.SolidRaster;
import rsal.scene.Surface;
import rsal.testkit.DrawnMap;
import rsal.testkit.ObviousRays;

class RasterWallsTest {
    @ParameterizedTest
    @ValueSource(doubles = {0.001, 0.01, 0.1, 0.4})
    void raysEndWhereTheSlowOnesDo(double density) {
        for (long seed = 0; seed < 60; seed++) {
            var world = new RandomWorld(seed, 0.05, density);
            var walls = RasterWalls.of(world.map);
            var slow = new ObviousRays(world.map);
            for (int i = 0; i < 50; i++) {
                Pose2d pose = world.anywhere();
                if (i % 5 == 0) { // along the axes
                    pose = new Pose2d(pose.x(), pose.y(), Math.rint(pose.theta() / (Math.PI / 2)) * Math.PI / 2);
                }
                double dx = Math.abs(Math.cos(pose.theta())) < 1e-9 ? 0 : Math.cos(pose.theta());
                double dy = Math.abs(Math.sin(pose.theta())) < 1e-9 ? 0 : Math.sin(pose.theta());
                assertThat(RandomWorld.ray(walls, pose.x(), pose.y(), dx, dy, 100))
                        .as("seed %d, ray %d from %s", seed, i, pose)
                        .isCloseTo(slow.range(pose), within(1e-9));
            }
        }
    }

    /// All rays of a sensor go in step, in bunches, and leave the others at different times. Each is to come out, to
    /// the last bit, as if it were alone.
    @ParameterizedTest
    @ValueSource(ints = {2, 7, 8, 9, 64, 65, 181})
    void raysEndAsIfTheyWereAlone(int count) {
        for (long seed = 0; seed < 40; seed++) {
            var random = new SplittableRandom(seed);
            var world = new RandomWorld(seed, 0.05, seed % 2 == 0 ? 0.01 : 0.1);
            List<RasterWalls> both =
                    List.of(RasterWalls.of(world.map), RasterWalls.of(new RandomWorld(seed + 1000, 0.1, 0.02).map));
            double reach = random.nextDouble(0.5, 6);
            double[][] wanted = new double[count][];
            Pose2d from = world.anywhere();
            for (int i = 0; i < count; i++) {
                if (random.nextInt(12) == 0) { // else one of a fan
                    from = random.nextInt(4) == 0 ? new Pose2d(random.nextDouble(-3, 12), -1, 0) : world.anywhere();
                }
                double angle = from.theta() + i * 0.02;
                double met = random.nextInt(5) == 0 ? random.nextDouble(3) : Double.POSITIVE_INFINITY;
                wanted[i] = new double[] {from.x(), from.y(), Math.cos(angle), Math.sin(angle), met};
            }
            double[] alone = new double[count];
            for (int i = 0; i < count; i++) {
                alone[i] = RandomWorld.ranges(both, reach, wanted[i])[0];
            }
            assertThat(RandomWorld.ranges(both, reach, wanted))
                    .as("seed %d", seed)
                    .containsExactly(alone);
        }
    }

    @Test
    void raysEndAtTheirReach() {
        var walls = RasterWalls.of(DrawnMap.grid(0.5, "......#").grid());
        assertThat(RandomWorld.ray(walls, 0.5, 0.25, 1, 0, 2.6)).isEqualTo(2.5);
        assertThat(RandomWorld.ray(walls, 0.5, 0.25, 1, 0, 2.4)).isEqualTo(Double.POSITIVE_INFINITY);
    }

    @Test
    void raysFromOutsideMeetTheFirstWallInside() {
        var walls = RasterWalls.of(DrawnMap.grid(0.5, "..####").grid());
        assertThat(RandomWorld.ray(walls, -5, 0.25, 1, 0, 100)).isEqualTo(6);
        assertThat(RandomWorld.ray(walls, -5, 0.25, 1, 0, 5.9)).isEqualTo(Double.POSITIVE_INFINITY);
        assertThat(RandomWorld.ray(walls, -5, 0.25, -1, 0, 100)).isEqualTo(Double.POSITIVE_INFINITY);
        assertThat(RandomWorld.ray(walls, -5, 0.75, 1, 0, 100)).isEqualTo(Double.POSITIVE_INFINITY);
        assertThat(RandomWorld.ray(walls, Double.NaN, 0.25, 1, 0, 100)).isEqualTo(Double.POSITIVE_INFINITY);
    }

    /// Cells of floor plans need not be square, and rays may come from outside.
    @ParameterizedTest
    @ValueSource(doubles = {0.01, 0.1, 0.5})
    void raysMeetOblongCellsWhereTheyMeetBoxes(double density) {
        int hits = 0;
        for (long seed = 0; seed < 40; seed++) {
            var random = new SplittableRandom(seed);
            int width = random.nextInt(1, 40);
            int height = random.nextInt(1, 40);
            double cellX = random.nextDouble(0.02, 0.2);
            double cellY = random.nextDouble(0.02, 0.2);
            var solid = new BitSet();
            for (int i = 0; i < width * height; i++) {
                solid.set(i, random.nextDouble() < density);
            }
            var walls = new RasterWalls(
                    new SolidRaster(width, height, solid, 1, 2, cellX, cellY, 0, 1, false, Surface.PLAIN));
            for (int i = 0; i < 50; i++) {
                double x = random.nextDouble(-2, 10);
                double y = random.nextDouble(-2, 10);
                double direction = random.nextDouble(-4, 4);
                double dx = Math.cos(direction);
                double dy = Math.sin(direction);
                double slow = Double.POSITIVE_INFINITY;
                for (int cell = solid.nextSetBit(0); cell >= 0; cell = solid.nextSetBit(cell + 1)) {
                    int column = cell % width;
                    int row = cell / width;
                    var middle = new Point2d(1 + (column + 0.5) * cellX, 2 + (row + 0.5) * cellY);
                    var box = Footprint.box(cellX, cellY, middle);
                    slow = Math.min(
                            slow,
                            new Polygon((CollisionShape.Prism)
                                            CollisionShape.of(box).getFirst())
                                    .ray(x, y, dx, dy));
                }
                double fast = RandomWorld.ray(walls, x, y, dx, dy, 100);
                if (slow < Double.POSITIVE_INFINITY) {
                    hits++;
                    assertThat(fast).as("seed %d, ray %d", seed, i).isCloseTo(slow, within(1e-9));
                } else {
                    assertThat(fast).as("seed %d, ray %d", seed, i).isEqualTo(slow);
                }
            }
        }
        assertThat(hits).isGreaterThan(20);
    }

    /// Nearly along a border between cells, so that for a long way the coordinate across it rounds to the border
    /// itself, whichever side the ray has got to.
    @Test
    @Timeout(value = 60, threadMode = Timeout.ThreadMode.SEPARATE_THREAD)
    void raysAlongBordersEndWhereThoseBesideThemDo() {
        for (long seed = 0; seed < 200; seed++) {
            var random = new SplittableRandom(seed);
            var cells = new byte[64 * 64];
            for (int i = 0; i < cells.length; i++) {
                cells[i] = random.nextInt(100) == 0 ? OccupancyGrid.OCCUPIED : OccupancyGrid.FREE;
            }
            var map = new OccupancyGrid(64, 64, 0.25, -8, -300, cells);
            var walls = RasterWalls.of(map);
            var slow = new ObviousRays(map);
            for (int i = 0; i < 100; i++) {
                double along = random.nextBoolean() ? 1 : -1;
                int side = random.nextInt(-1, 2);
                double across = side * Math.pow(10, -random.nextDouble(11, 20));
                double above = side < 0 && random.nextBoolean() ? 1e-13 : 0; // which it loses on its way, or doesn't
                double free = random.nextDouble(1, 15);
                double border = 0.25 * random.nextInt(4, 60) + above;
                boolean level = random.nextBoolean();
                double x = -8 + (level ? free : border);
                double y = -300 + (level ? border : free);
                double range = level
                        ? RandomWorld.ray(walls, x, y, along, across, 100)
                        : RandomWorld.ray(walls, x, y, across, along, 100);
                double[] beside = new double[2];
                for (int upper = 0; upper < 2; upper++) {
                    double aside = 2e-9 * (upper - 0.5);
                    beside[upper] = slow.range(
                            level
                                    ? new Pose2d(x, y + aside, along > 0 ? 0 : Math.PI)
                                    : new Pose2d(x + aside, y, along * Math.PI / 2));
                }
                String which = "seed %d, ray %d from (%s, %s), %s".formatted(seed, i, x, y, across);
                if (above > 0) {
                    assertThat(range).as(which).isGreaterThanOrEqualTo(Math.min(beside[0], beside[1]) - 1e-6);
                } else { // exactly along it is in the upper cell
                    assertThat(range).as(which).isCloseTo(beside[side < 0 ? 0 : 1], within(1e-6));
                }
            }
        }
    }

    @Test
    void unknownCellsAreNoWalls() {
        var walls = RasterWalls.of(DrawnMap.grid(0.5, ".???#").grid());
        assertThat(RandomWorld.ray(walls, 0.25, 0.25, 1, 0, 100)).isEqualTo(1.75);
    }

    @Test
    void whatIsSaidToBeEmptyIs() {
        for (long seed = 0; seed < 50; seed++) {
            var world = new RandomWorld(seed, 0.1, 0.01);
            var walls = RasterWalls.of(world.map);
            var slow = new ObviousRays(world.map);
            Pose2d place = world.anywhere();
            assertThat(walls.emptyAround(place.x(), place.y()))
                    .as("seed %d", seed)
                    .isLessThanOrEqualTo(slow.clearance(place.x(), place.y()));
        }
    }
}
