package rsal.navigation.grid;

import org.openjdk.jmh.annotations.Benchmark;
import org.openjdk.jmh.annotations.Fork;
import org.openjdk.jmh.annotations.Measurement;
import org.openjdk.jmh.annotations.Param;
import org.openjdk.jmh.annotations.Scope;
import org.openjdk.jmh.annotations.Setup;
import org.openjdk.jmh.annotations.State;
import org.openjdk.jmh.annotations.Warmup;
import rsal.bench.place.Cave;
import rsal.data.OccupancyGrid;

/// Fields of distances [1/s] over caves, against measuring from each cell to each that is occupied.
@State(Scope.Thread)
@Fork(1)
@Warmup(iterations = 3, time = 2)
@Measurement(iterations = 5, time = 2)
public class Distances {
    private static final double RESOLUTION = 0.05; // m

    @Param({"128", "256"})
    int side;

    private OccupancyGrid cave;

    @Setup
    public void draw() {
        cave = Cave.draw(side * RESOLUTION, RESOLUTION, 1);
        DistanceField field = kernel();
        float[] exact = slow();
        for (int cell = 0; cell < exact.length; cell++) {
            if (!(Math.abs(field.at(cell) - exact[cell]) < 1e-5)) {
                throw new IllegalStateException(
                        "Cell %d: %s m is not %s m.".formatted(cell, field.at(cell), exact[cell]));
            }
        }
    }

    @Benchmark
    public DistanceField kernel() {
        return DistanceField.toOccupied(cave);
    }

    @Benchmark
    public float[] slow() {
        var meters = new float[cave.cells().length];
        for (int cell = 0; cell < meters.length; cell++) {
            int least = Integer.MAX_VALUE;
            for (int other = 0; other < meters.length; other++) {
                if (cave.cells()[other] == OccupancyGrid.OCCUPIED) {
                    int dx = other % cave.width() - cell % cave.width();
                    int dy = other / cave.width() - cell / cave.width();
                    least = Math.min(least, dx * dx + dy * dy);
                }
            }
            meters[cell] = (float) (cave.resolution() * Math.sqrt(least));
        }
        return meters;
    }
}
