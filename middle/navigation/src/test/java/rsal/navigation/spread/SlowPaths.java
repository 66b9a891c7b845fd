package rsal.navigation.spread;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.Comparator;
import java.util.List;
import java.util.PriorityQueue;
import java.util.Random;
import java.util.random.RandomGenerator;
import rsal.data.OccupancyGrid;
import rsal.data.Point2d;

/// Ways between all cells of a small map in which a robot can be, slowly and obviously: by Dijkstra's algorithm from
/// each, steps along sides and diagonals, none past a corner.
final class SlowPaths {
    private final OccupancyGrid map;
    private final List<Integer> cells; // of the largest part
    private final double[][] ways;
    private final boolean[] open;

    SlowPaths(OccupancyGrid map, double clearance) {
        this.map = map;
        this.open = new boolean[map.cells().length];
        var left = new ArrayList<Integer>();
        for (int cell = 0; cell < map.cells().length; cell++) {
            open[cell] = isOpen(map, cell, clearance);
            if (open[cell]) {
                left.add(cell);
            }
        }
        List<Integer> largest = List.of();
        while (!left.isEmpty()) {
            double[] from = dijkstra(left.getFirst());
            List<Integer> part =
                    left.stream().filter(cell -> Double.isFinite(from[cell])).toList();
            left.removeAll(part);
            largest = part.size() > largest.size() ? part : largest;
        }
        this.cells = largest;
        this.ways = new double[cells.size()][];
        for (int i = 0; i < ways.length; i++) {
            double[] from = dijkstra(cells.get(i));
            ways[i] = cells.stream().mapToDouble(cell -> from[cell]).toArray();
        }
    }

    /// Looks at every other cell; those at the rim of the map are not free.
    private static boolean isOpen(OccupancyGrid map, int cell, double clearance) {
        for (int other = 0; other < map.cells().length; other++) {
            int column = other % map.width();
            int row = other / map.width();
            boolean rim = column == 0 || row == 0 || column == map.width() - 1 || row == map.height() - 1;
            double away = map.middle(cell).distanceTo(map.middle(other)) - map.resolution() / 2;
            if ((rim || map.cells()[other] != OccupancyGrid.FREE) && (other == cell || away < clearance - 1e-6)) {
                return false;
            }
        }
        return true;
    }

    private double[] dijkstra(int from) {
        record Reached(int cell, double distance) {}
        var ways = new double[map.cells().length];
        Arrays.fill(ways, Double.POSITIVE_INFINITY);
        ways[from] = 0;
        var queue = new PriorityQueue<>(Comparator.comparingDouble(Reached::distance));
        queue.add(new Reached(from, 0));
        while (!queue.isEmpty()) {
            Reached now = queue.remove();
            for (int dy = -1; dy <= 1; dy++) {
                for (int dx = -1; dx <= 1; dx++) {
                    int to = now.cell + dy * map.width() + dx;
                    boolean passable = open[to] && open[now.cell + dx] && open[now.cell + dy * map.width()];
                    double distance = now.distance + map.resolution() * Math.hypot(dx, dy);
                    if (passable && distance < ways[to] - 1e-9) {
                        ways[to] = distance;
                        queue.add(new Reached(to, distance));
                    }
                }
            }
        }
        return ways;
    }

    int count() {
        return cells.size();
    }

    Point2d place(int index) {
        return map.middle(cells.get(index));
    }

    int index(Point2d place) {
        return cells.indexOf(map.cell(place));
    }

    /// To the nearest of some places.
    Evenness measure(int... places) {
        double sum = 0;
        double squares = 0;
        double greatest = 0;
        for (int to = 0; to < count(); to++) {
            double least = Double.POSITIVE_INFINITY;
            for (int place : places) {
                least = Math.min(least, ways[place][to]);
            }
            sum += least;
            squares += least * least;
            greatest = Math.max(greatest, least);
        }
        return new Evenness(sum / count(), Math.sqrt(squares / count()), greatest);
    }

    /// The least root mean square that one of Lloyd's runs from random places comes to.
    double bestOfLloyd(int number, int runs, RandomGenerator random) {
        double best = Double.POSITIVE_INFINITY;
        for (int run = 0; run < runs; run++) {
            best = Math.min(best, measure(lloyd(number, random)).rms());
        }
        return best;
    }

    private int[] lloyd(int number, RandomGenerator random) {
        var shuffled = new ArrayList<Integer>();
        for (int i = 0; i < count(); i++) {
            shuffled.add(i);
        }
        Collections.shuffle(shuffled, Random.from(random));
        int[] places =
                shuffled.subList(0, number).stream().mapToInt(Integer::intValue).toArray();
        boolean moved = true;
        while (moved) {
            moved = false;
            int[] nearest = nearest(places);
            for (int k = 0; k < number; k++) {
                int best = places[k];
                double least = squares(k, nearest, best);
                for (int to = 0; to < count(); to++) {
                    double sum = nearest[to] == k ? squares(k, nearest, to) : least;
                    if (sum < least - 1e-9) {
                        least = sum;
                        best = to;
                        moved = true;
                    }
                }
                places[k] = best;
            }
        }
        return places;
    }

    private int[] nearest(int[] places) {
        var nearest = new int[count()];
        for (int to = 0; to < count(); to++) {
            for (int k = 1; k < places.length; k++) {
                nearest[to] = ways[places[k]][to] < ways[places[nearest[to]]][to] ? k : nearest[to];
            }
        }
        return nearest;
    }

    private double squares(int region, int[] nearest, int from) {
        double sum = 0;
        for (int to = 0; to < count(); to++) {
            sum += nearest[to] == region ? ways[from][to] * ways[from][to] : 0;
        }
        return sum;
    }
}
