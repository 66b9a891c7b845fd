package rsal.navigation.amcl;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.SplittableRandom;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import rsal.data.OccupancyGrid;
import rsal.navigation.grid.DistanceField;

class StridedFieldTest {
    /// Compared with one cell looked up after the other: places a fixed number of cells apart or not quite, beams that
    /// end in the map, at the very border of a cell and outside.
    @ParameterizedTest
    @ValueSource(longs = {1, 2, 3, 4, 5, 6, 7, 8, 9, 10})
    void sumsAreThoseOfEachCellToTheLastBit(long seed) {
        var random = new SplittableRandom(seed);
        for (int round = 0; round < 20; round++) {
            int width = random.nextInt(1, 60);
            int height = random.nextInt(1, 40);
            int[] walls = random.ints(5, 0, width * height).toArray();
            var cells = new byte[width * height];
            for (int wall : walls) {
                cells[wall] = OccupancyGrid.OCCUPIED;
            }
            var map = new OccupancyGrid(width, height, 0.15, -1, 2, cells);
            var field = new LikelihoodField(map, DistanceField.toOccupied(map), 0.35, 0.05);
            int stride = random.nextInt(1, 4);
            boolean regular = random.nextInt(4) > 0;
            float[] placeX = places(Math.ceilDiv(width, stride), regular ? stride : stride * 0.93f, width, random);
            float[] placeY = places(Math.ceilDiv(height, stride), stride, height, random);
            int beams = random.nextInt(0, 40);
            StridedField.Scan scan = new StridedField(field, stride).new Scan(placeX, placeY, beams);
            var sums = new float[placeX.length];
            for (int heading = 0; heading < 3; heading++) {
                float[] turnedX = ends(beams, width, random);
                float[] turnedY = ends(beams, height, random);
                scan.turn(turnedX, turnedY);
                for (int row = 0; row < placeY.length; row++) {
                    int begin = random.nextInt(placeX.length + 1);
                    int end = random.nextInt(begin, placeX.length + 1);
                    scan.sum(row, begin, end, sums);
                    for (int i = begin; i < end; i++) {
                        float sum = 0;
                        for (int beam = 0; beam < beams; beam++) {
                            sum += field.logOf((int) (placeX[i] + turnedX[beam]), (int) (placeY[row] + turnedY[beam]));
                        }
                        assertThat(sums[i]).as("place %d, %d", i, row).isEqualTo(sum);
                    }
                }
            }
        }
    }

    private static float[] places(int count, float apart, int size, SplittableRandom random) {
        float first = random.nextFloat();
        var places = new float[count];
        for (int i = 0; i < count; i++) {
            places[i] = Math.min(first + i * apart, size - 0.5f); // the last may be nearer
        }
        return places;
    }

    private static float[] ends(int count, int size, SplittableRandom random) {
        var ends = new float[count];
        for (int i = 0; i < count; i++) {
            float end = random.nextFloat(-1.3f * size, 1.3f * size);
            ends[i] = random.nextInt(20) == 0 ? Math.round(end) : end;
        }
        if (count > 0) {
            ends[0] = random.nextBoolean() ? 1e30f : -1e30f;
        }
        return ends;
    }
}
