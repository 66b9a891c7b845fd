package rsal.navigation.rooms;

import java.util.ArrayList;
import java.util.Collections;
import java.util.Comparator;
import java.util.List;
import java.util.PriorityQueue;
import java.util.TreeMap;
import rsal.data.OccupancyGrid;

/// Which [Basins] are beside which, while small ones join their neighbors.
final class RegionGraph {
    private static final double LEAST_CLOSET = 1; // m²
    private static final double DOOR = 0.7; // of the width of a closet: wider ones lead to a niche

    private final RoomParameters parameters;
    private final Basins basins;
    private final int[] parents;
    private final double[] areas; // m²
    private final List<TreeMap<Integer, Float>> neighbors = new ArrayList<>(); // half the width on the way there [m]

    private record Small(int basin, double area) {}

    RegionGraph(OccupancyGrid map, Basins basins, RoomParameters parameters) {
        this.parameters = parameters;
        this.basins = basins;
        this.parents = new int[basins.numbers()];
        this.areas = new double[parents.length];
        for (int basin = 0; basin < parents.length; basin++) {
            parents[basin] = basin;
            neighbors.add(new TreeMap<>());
        }
        int[] basinOf = basins.basinOf();
        double cell = map.resolution() * map.resolution();
        for (int at = 0; at < basinOf.length; at++) {
            if (basinOf[at] != Basins.NONE) {
                areas[basinOf[at]] += map.cells()[at] == OccupancyGrid.FREE ? cell : 0;
                if ((at + 1) % map.width() != 0) {
                    note(at, at + 1);
                }
                if (at + map.width() < basinOf.length) {
                    note(at, at + map.width());
                }
            }
        }
        joinSmall();
    }

    private void note(int cell, int next) {
        int one = basins.basinOf()[cell];
        int other = basins.basinOf()[next];
        float half = Math.min(basins.halfWidths()[cell], basins.halfWidths()[next]);
        if (other != Basins.NONE && one != other) {
            neighbors.get(one).merge(other, half, Math::max);
            neighbors.get(other).merge(one, half, Math::max);
        }
    }

    /// The smallest first, each into the neighbor with the widest gate to it.
    private void joinSmall() {
        var queue =
                new PriorityQueue<Small>(Comparator.comparingDouble(Small::area).thenComparingInt(Small::basin));
        for (int basin = 0; basin < parents.length; basin++) {
            offer(basin, queue);
        }
        while (!queue.isEmpty()) {
            Small small = queue.remove();
            int basin = small.basin;
            if (parents[basin] == basin && areas[basin] == small.area && !isCloset(basin)) {
                neighbors.get(basin).entrySet().stream()
                        .max(TreeMap.Entry.comparingByValue())
                        .ifPresent(widest -> {
                            join(basin, widest.getKey());
                            offer(widest.getKey(), queue);
                        });
            }
        }
    }

    private void offer(int basin, PriorityQueue<Small> queue) {
        boolean mayJoin = passable(basin) > 0
                || (areas[basin] < LEAST_CLOSET && !neighbors.get(basin).isEmpty());
        if (areas[basin] < parameters.leastArea() && mayJoin) {
            queue.add(new Small(basin, areas[basin]));
        }
    }

    /// How many neighbors are not behind cracks.
    private long passable(int basin) {
        return neighbors.get(basin).values().stream()
                .filter(half -> 2 * half >= parameters.leastGate())
                .count();
    }

    /// A dead end behind a door.
    private boolean isCloset(int basin) {
        return passable(basin) == 1 && areas[basin] >= LEAST_CLOSET && isDoor(widest(basin), basins.peak(basin));
    }

    private boolean isDoor(float half, float peak) {
        return 2 * half <= parameters.gateWidth() && half <= DOOR * peak;
    }

    private float widest(int basin) {
        return Collections.max(neighbors.get(basin).values());
    }

    private void join(int basin, int into) {
        parents[basin] = into;
        areas[into] += areas[basin];
        neighbors.get(basin).forEach((neighbor, half) -> {
            neighbors.get(neighbor).remove(basin);
            if (neighbor != into) {
                neighbors.get(neighbor).merge(into, half, Math::max);
                neighbors.get(into).merge(neighbor, half, Math::max);
            }
        });
        neighbors.get(basin).clear();
    }

    /// The basin that one has joined in the end, or [Basins#NONE] for a hole in which nobody can be.
    int regionOf(int basin) {
        int at = basin;
        while (parents[at] != at) {
            at = parents[at];
        }
        return areas[at] >= LEAST_CLOSET || !neighbors.get(at).isEmpty() ? at : Basins.NONE;
    }
}
