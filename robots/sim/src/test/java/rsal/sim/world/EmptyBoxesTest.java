package rsal.sim.world;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Arrays;
import java.util.BitSet;
import java.util.Collections;
import java.util.SplittableRandom;
import java.util.concurrent.Callable;
import java.util.concurrent.Executors;
import org.junit.jupiter.api.Test;
import rsal.data.Pose2d;
import rsal.scene.SolidRaster;
import rsal.scene.Surface;
import rsal.testkit.DrawnMap;
import rsal.testkit.Rounds;

class EmptyBoxesTest {
    private static final int BEAMS = 90;

    /// A floor with level and upright walls, rooms and things in them, or noise.
    private static RasterWalls floor(SplittableRandom random) {
        int width = random.nextInt(3, 120);
        int height = random.nextInt(3, 120);
        var solid = new BitSet();
        double noise = random.nextInt(3) == 0 ? random.nextDouble(0.2) : 0.002;
        for (int i = 0; i < width * height; i++) {
            solid.set(i, random.nextDouble() < noise);
        }
        for (int wall = random.nextInt(12); wall > 0; wall--) {
            int at = random.nextInt(width * height);
            int step = random.nextBoolean() ? 1 : width;
            for (int i = random.nextInt(60); i > 0 && at < width * height; i--, at += step) {
                solid.set(at);
            }
        }
        boolean square = random.nextBoolean();
        double cellX = square ? 0.05 : random.nextDouble(0.02, 0.2);
        double cellY = square ? 0.05 : random.nextDouble(0.02, 0.2);
        double left = 0.05 * random.nextInt(-500, 500);
        double bottom = square ? 0.05 * random.nextInt(-500, 500) : random.nextDouble(-9, 9);
        return new RasterWalls(new SolidRaster(
                width, height, solid, left, bottom, cellX, cellY, 0, 1, random.nextBoolean(), Surface.PLAIN));
    }

    /// From anywhere; often from a border or a corner of cells, or in a direction of a lattice.
    private static Pose2d from(SplittableRandom random, RasterWalls walls) {
        double column = random.nextDouble(-2, walls.width + 2);
        double row = random.nextDouble(-2, walls.height + 2);
        boolean lattice = random.nextInt(3) == 0;
        return new Pose2d(
                walls.left + walls.cellX * (lattice ? Math.rint(column * 2) / 2 : column),
                walls.bottom + walls.cellY * (lattice && random.nextBoolean() ? Math.rint(row * 2) / 2 : row),
                lattice ? Math.PI / 4 * random.nextInt(8) : random.nextDouble(-4, 4));
    }

    private static Rays fan(Pose2d from, double increment, SplittableRandom bodies) {
        Rays rays = Rays.ofThisThread(BEAMS);
        for (int i = 0; i < BEAMS; i++) {
            double angle = from.theta() + (i - BEAMS / 2) * increment;
            rays.x[i] = from.x();
            rays.y[i] = from.y();
            rays.dx[i] = StrictMath.cos(angle);
            rays.dy[i] = StrictMath.sin(angle);
            boolean metBefore = bodies.nextInt(8) == 0;
            rays.range[i] = metBefore ? bodies.nextDouble(3) : Double.POSITIVE_INFINITY;
            rays.met[i] = metBefore ? 0 : Rays.NOTHING;
        }
        return rays;
    }

    @Test
    void raysEndWhereMarchingOnesDoToTheLastBit() {
        for (long seed = 0; seed < Rounds.of(100, 40_000); seed++) {
            var random = new SplittableRandom(seed);
            RasterWalls walls = floor(random);
            var boxes = new EmptyBoxes(walls);
            for (int place = 0; place < 20; place++) {
                Pose2d from = from(random, walls);
                double increment = place % 4 == 0 ? Math.PI / 4 : random.nextDouble(0.001, 0.1);
                double reach = random.nextDouble(0.5, 12);
                long bodies = random.nextLong();
                Rays rays = fan(from, increment, new SplittableRandom(bodies));
                rays.march.end(walls, rays, reach);
                double[] ranges = rays.range.clone();
                int[] met = rays.met.clone();
                fan(from, increment, new SplittableRandom(bodies));
                boxes.end(rays, reach);
                int differs = Arrays.mismatch(rays.range, 0, BEAMS, ranges, 0, BEAMS);
                assertThat(differs)
                        .as("seed %d, place %d, from %s", seed, place, from)
                        .isNegative();
                assertThat(Arrays.equals(rays.met, 0, BEAMS, met, 0, BEAMS)).isTrue();
            }
        }
    }

    @Test
    void boxesComeWhenRaysAreWorthThemAndChangeNothing() throws Exception {
        RasterWalls walls = RasterWalls.of(DrawnMap.grid(0.1, """
                #########
                #.......#
                #...#...#
                #########""").grid());
        var worker = (Callable<Double>) () -> {
            double sum = 0;
            for (int i = 0; i < 20; i++) {
                var random = new SplittableRandom(i);
                Rays rays = fan(new Pose2d(0.15, 0.25, 0), 0.01, random);
                walls.end(rays, 8);
                sum += rays.range[BEAMS / 3];
            }
            return sum;
        };
        assertThat(walls.hasBoxes()).isFalse();
        double alone = worker.call();
        assertThat(walls.hasBoxes()).isTrue();
        try (var threads = Executors.newFixedThreadPool(2)) {
            for (var each : threads.invokeAll(Collections.nCopies(4, worker))) {
                assertThat(each.get()).isEqualTo(alone);
            }
        }
    }
}
