package rsal.navigation.jumppoint;

import java.util.Arrays;
import java.util.PriorityQueue;
import java.util.SplittableRandom;
import org.openjdk.jmh.annotations.Benchmark;
import org.openjdk.jmh.annotations.Fork;
import org.openjdk.jmh.annotations.Measurement;
import org.openjdk.jmh.annotations.OperationsPerInvocation;
import org.openjdk.jmh.annotations.Param;
import org.openjdk.jmh.annotations.Scope;
import org.openjdk.jmh.annotations.Setup;
import org.openjdk.jmh.annotations.State;
import org.openjdk.jmh.annotations.Warmup;
import rsal.bench.place.Cave;
import rsal.data.OccupancyGrid;
import rsal.navigation.grid.DistanceField;
import rsal.navigation.wavefront.CostMap;
import rsal.navigation.wavefront.CostMap.Clearance;

/// Shortest ways [1/s] between random places in a cave, against A* with a heap over all eight neighbors (P. Hart, N.
/// Nilsson, B. Raphael, 1968).
@State(Scope.Thread)
@Fork(1)
@Warmup(iterations = 3, time = 2)
@Measurement(iterations = 5, time = 2)
public class ShortestPaths {
    private static final int WAYS = 20;
    private static final double RESOLUTION = 0.05; // m
    private static final int SIDE = 10; // as jump points count
    private static final int DIAGONAL = 14;
    private static final int[] DX = {1, 1, 0, -1, -1, -1, 0, 1};
    private static final int[] DY = {0, 1, 1, 1, 0, -1, -1, -1};

    @Param({"256", "1024"})
    int side;

    private final int[] starts = new int[WAYS];
    private final int[] goals = new int[WAYS];
    private CostMap map;
    private JumpPoints jumps;

    private record Reached(int estimate, int cost, int cell) implements Comparable<Reached> {
        @Override
        public int compareTo(Reached other) {
            return Integer.compare(estimate, other.estimate);
        }
    }

    @Setup
    public void draw() {
        OccupancyGrid cave = Cave.draw(side * RESOLUTION, RESOLUTION, 1);
        map = CostMap.of(cave, DistanceField.toNotFree(cave), new Clearance(0.25, 0.25, 0));
        jumps = new JumpPoints(map);
        var random = new SplittableRandom(1);
        for (int distance = 0; distance < WAYS; distance++) {
            do {
                starts[distance] = random.nextInt(cave.cells().length);
                goals[distance] = random.nextInt(cave.cells().length);
            } while (!map.isOpen(starts[distance])
                    || !map.isOpen(goals[distance])
                    || jumps.search(starts[distance], goals[distance]) <= 0);
        }
        if (kernel() != slow()) {
            throw new IllegalStateException("Ways of %d are not as long as %d.".formatted(kernel(), slow()));
        }
    }

    @Benchmark
    @OperationsPerInvocation(WAYS)
    public long kernel() {
        long sum = 0;
        for (int distance = 0; distance < WAYS; distance++) {
            sum += jumps.search(starts[distance], goals[distance]);
        }
        return sum;
    }

    @Benchmark
    @OperationsPerInvocation(WAYS)
    public long slow() {
        long sum = 0;
        for (int distance = 0; distance < WAYS; distance++) {
            sum += search(starts[distance], goals[distance]);
        }
        return sum;
    }

    private int search(int start, int goal) {
        var costs = new int[map.grid().cells().length];
        Arrays.fill(costs, Integer.MAX_VALUE);
        costs[start] = 0;
        var front = new PriorityQueue<Reached>();
        front.add(new Reached(estimate(start, goal), 0, start));
        while (!front.isEmpty()) {
            Reached next = front.poll();
            if (next.cell == goal) {
                return next.cost;
            }
            for (int distance = 0; distance < 8 && next.cost == costs[next.cell]; distance++) {
                int row = DY[distance] * map.grid().width();
                int to = next.cell + row + DX[distance];
                int cost = next.cost + (distance % 2 == 1 ? DIAGONAL : SIDE);
                boolean isOpen = map.isOpen(to) && map.isOpen(next.cell + DX[distance]) && map.isOpen(next.cell + row);
                if (isOpen && cost < costs[to]) {
                    costs[to] = cost;
                    front.add(new Reached(cost + estimate(to, goal), cost, to));
                }
            }
        }
        return -1;
    }

    private int estimate(int cell, int goal) {
        int width = map.grid().width();
        int dx = Math.abs(cell % width - goal % width);
        int dy = Math.abs(cell / width - goal / width);
        return SIDE * Math.max(dx, dy) + (DIAGONAL - SIDE) * Math.min(dx, dy);
    }
}
