package rsal.navigation.wavefront;

import java.util.Arrays;
import java.util.PriorityQueue;
import org.openjdk.jmh.annotations.Benchmark;
import org.openjdk.jmh.annotations.Fork;
import org.openjdk.jmh.annotations.Measurement;
import org.openjdk.jmh.annotations.Scope;
import org.openjdk.jmh.annotations.Setup;
import org.openjdk.jmh.annotations.State;
import org.openjdk.jmh.annotations.Warmup;
import rsal.bench.place.Cave;
import rsal.data.OccupancyGrid;
import rsal.navigation.grid.DistanceField;
import rsal.navigation.wavefront.CostMap.Clearance;

/// Waves [1/s] over a cave of 2560 × 2560 cells, against E. Dijkstra's algorithm with a heap.
@State(Scope.Thread)
@Fork(1)
@Warmup(iterations = 3, time = 2)
@Measurement(iterations = 5, time = 2)
public class Waves2560 {
    private static final int[] DX = {1, 1, 0, -1, -1, -1, 0, 1};
    private static final int[] DY = {0, 1, 1, 1, 0, -1, -1, -1};

    private CostMap map;
    private Wave wave;
    private int source;

    private record Reached(int cost, int cell) implements Comparable<Reached> {
        @Override
        public int compareTo(Reached other) {
            return Integer.compare(cost, other.cost);
        }
    }

    @Setup
    public void draw() {
        OccupancyGrid cave = Cave.draw(128, 0.05, 1);
        map = CostMap.of(cave, DistanceField.toNotFree(cave), new Clearance(0.25, 0.6, 3));
        wave = new Wave(map);
        for (source = map.ground().length / 2; reached(kernel()) < map.ground().length / 3; source++) {}
    }

    @Benchmark
    public Wave kernel() {
        wave.clear();
        if (map.isOpen(source)) {
            wave.start(source);
            wave.spread(-1);
        }
        return wave;
    }

    @Benchmark
    public int[] slow() {
        int width = map.grid().width();
        int[] field = new int[map.ground().length];
        Arrays.fill(field, Wave.UNREACHED);
        field[source] = 0;
        var front = new PriorityQueue<Reached>();
        front.add(new Reached(0, source));
        while (!front.isEmpty()) {
            Reached next = front.poll();
            int cell = next.cell;
            for (int distance = 0; distance < 8 && next.cost == field[cell]; distance++) {
                int to = cell + DY[distance] * width + DX[distance];
                int cost = next.cost + map.step(cell, to, distance % 2 == 1);
                boolean isOpen =
                        map.isOpen(to) && map.isOpen(cell + DX[distance]) && map.isOpen(cell + DY[distance] * width);
                if (isOpen && cost < field[to]) {
                    field[to] = cost;
                    front.add(new Reached(cost, to));
                }
            }
        }
        return field;
    }

    private int reached(Wave spread) {
        int count = 0;
        for (int cell = 0; cell < map.ground().length; cell++) {
            count += spread.isOpen(cell) && spread.at(cell) != Wave.UNREACHED ? 1 : 0;
        }
        return count;
    }
}
