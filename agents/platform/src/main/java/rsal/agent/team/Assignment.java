package rsal.agent.team;

import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.NavigableMap;
import java.util.SortedMap;
import rsal.data.Pose2d;

/// Who goes for whom: each hunter for one prey, as many for each prey as for any other, give or take one, with the
/// least sum of straight distances.
///
/// A prey that a hunter goes for already counts as [#LOYALTY] times its distance, so that two who are about
/// equally far do not change over again and again. Same reports, same answer, no matter who asks.
public final class Assignment {
    static final double LOYALTY = 0.8;

    static final double LONGER = 1.05;

    private static final double EVENNESS = 1e6; // m, longer than all ways together

    private Assignment() {}

    /// @param hunters where they are, by id
    /// @param prey where those who are free are, by id
    /// @param before which prey each hunter goes for so far
    /// @return prey by hunter; empty without prey
    public static Map<String, String> nearest(
            SortedMap<String, Pose2d> hunters, SortedMap<String, Pose2d> prey, Map<String, String> before) {
        var preyOf = new LinkedHashMap<String, String>();
        if (hunters.isEmpty() || prey.isEmpty()) {
            return preyOf;
        }
        var those = List.copyOf(hunters.entrySet());
        var candidates = List.copyOf(prey.entrySet());
        int fair = those.size() / candidates.size(); // so many for each prey; the rest are extra
        var cost = new double[those.size()][(fair + 1) * candidates.size()];
        for (int row = 0; row < cost.length; row++) {
            var hunter = those.get(row);
            for (int column = 0; column < cost[row].length; column++) {
                var candidate = candidates.get(column % candidates.size());
                double distance = hunter.getValue().distanceTo(candidate.getValue());
                boolean loyal = candidate.getKey().equals(before.get(hunter.getKey()));
                boolean extra = column >= fair * candidates.size();
                cost[row][column] = (loyal ? LOYALTY * distance : distance) + (extra ? EVENNESS : 0);
            }
        }
        int[] columnOf = pair(cost);
        for (int row = 0; row < columnOf.length; row++) {
            preyOf.put(
                    those.get(row).getKey(),
                    candidates.get(columnOf[row] % candidates.size()).getKey());
        }
        return preyOf;
    }

    /// One place of its own for each robot, or as many as there are places: of all that make the longest way at most
    /// [#LONGER] times as long as it must be, one with the least sum of ways.
    ///
    /// @param costs of all places for each robot; +∞ where no way leads
    /// @return place by robot; without robots that get none they can reach
    public static Map<String, Integer> even(NavigableMap<String, double[]> costs) {
        if (costs.isEmpty()) {
            return Map.of();
        }
        double[][] cost = costs.values().toArray(double[][]::new);
        boolean crowded = cost.length > cost[0].length;
        return paired(costs, LONGER * shortestLongest(crowded ? turned(cost) : cost));
    }

    /// One place of its own for each robot, or as many as there are places, with the least sum of ways.
    ///
    /// @param costs of all places for each robot; +∞ where no way leads
    /// @return place by robot; without robots that get none they can reach
    public static Map<String, Integer> cheapest(NavigableMap<String, double[]> costs) {
        return costs.isEmpty() ? Map.of() : paired(costs, Double.MAX_VALUE);
    }

    /// With the least sum of ways, after as few as possible that are longer than a bound.
    private static Map<String, Integer> paired(NavigableMap<String, double[]> costs, double bound) {
        List<String> robots = List.copyOf(costs.keySet());
        double[][] cost = robots.stream().map(costs::get).toArray(double[][]::new);
        boolean crowded = cost.length > cost[0].length;
        int[] columnOf = pair(discouraging(crowded ? turned(cost) : cost, bound));
        var placeOf = new LinkedHashMap<String, Integer>();
        for (int row = 0; row < columnOf.length; row++) {
            int robot = crowded ? columnOf[row] : row;
            int place = crowded ? row : columnOf[row];
            if (cost[robot][place] < Double.POSITIVE_INFINITY) {
                placeOf.put(robots.get(robot), place);
            }
        }
        return placeOf;
    }

    private static double[][] turned(double[][] cost) {
        var turned = new double[cost[0].length][cost.length];
        for (int row = 0; row < cost.length; row++) {
            for (int column = 0; column < cost[row].length; column++) {
                turned[column][row] = cost[row][column];
            }
        }
        return turned;
    }

    /// The least that the longest way of an assignment can be, where all that can get something do.
    private static double shortestLongest(double[][] cost) {
        double[] distances = Arrays.stream(cost)
                .flatMapToDouble(Arrays::stream)
                .filter(Double::isFinite)
                .sorted()
                .distinct()
                .toArray();
        if (distances.length == 0) {
            return 0;
        }
        int most = tooLong(cost, distances[distances.length - 1]);
        int least = 0;
        int enough = distances.length - 1;
        while (least < enough) {
            int middle = (least + enough) / 2;
            if (tooLong(cost, distances[middle]) <= most) {
                enough = middle;
            } else {
                least = middle + 1;
            }
        }
        return distances[enough];
    }

    /// How many ways are longer than a bound in the assignment that has fewest of them.
    private static int tooLong(double[][] cost, double bound) {
        var longer = new double[cost.length][];
        for (int row = 0; row < cost.length; row++) {
            longer[row] =
                    Arrays.stream(cost[row]).map(way -> way > bound ? 1 : 0).toArray();
        }
        int[] columnOf = pair(longer);
        int count = 0;
        for (int row = 0; row < columnOf.length; row++) {
            count += longer[row][columnOf[row]] > 0 ? 1 : 0;
        }
        return count;
    }

    /// The same costs, where ways over a bound cost more than all others together.
    private static double[][] discouraging(double[][] cost, double bound) {
        var discouraging = new double[cost.length][];
        for (int row = 0; row < cost.length; row++) {
            discouraging[row] = Arrays.stream(cost[row])
                    .map(way -> way == Double.POSITIVE_INFINITY ? 1e3 * EVENNESS : way > bound ? way + EVENNESS : way)
                    .toArray();
        }
        return discouraging;
    }

    /// The column of its own for each row that makes the sum of costs least: shortest augmenting paths (Kuhn, "The
    /// Hungarian method for the assignment problem", 1955, in the O(n³) form of Jonker and Volgenant, 1987).
    ///
    /// Adds one row after another, each by the cheapest chain of changes among those before it. Prices of rows and
    /// columns keep every reduced cost at 0 or more, so that the chain is a shortest path. Index 0 stands for "not
    /// yet": inside, rows and columns count from 1.
    ///
    /// @param cost no fewer columns than rows
    public static int[] pair(double[][] cost) {
        int rows = cost.length;
        int columns = cost[0].length;
        var rowPrice = new double[rows + 1];
        var columnPrice = new double[columns + 1];
        var rowOf = new int[columns + 1];
        for (int row = 1; row <= rows; row++) {
            var cheapest = new double[columns + 1];
            var cameFrom = new int[columns + 1];
            var done = new boolean[columns + 1];
            Arrays.fill(cheapest, Double.POSITIVE_INFINITY);
            rowOf[0] = row;
            int column = 0;
            do {
                done[column] = true;
                int next = 0;
                for (int c = 1; c <= columns; c++) {
                    if (done[c]) {
                        continue;
                    }
                    double reduced = cost[rowOf[column] - 1][c - 1] - rowPrice[rowOf[column]] - columnPrice[c];
                    if (reduced < cheapest[c]) {
                        cheapest[c] = reduced;
                        cameFrom[c] = column;
                    }
                    if (next == 0 || cheapest[c] < cheapest[next]) {
                        next = c;
                    }
                }
                double step = cheapest[next];
                for (int c = 0; c <= columns; c++) {
                    if (done[c]) {
                        rowPrice[rowOf[c]] += step;
                        columnPrice[c] -= step;
                    } else {
                        cheapest[c] -= step;
                    }
                }
                column = next;
            } while (rowOf[column] != 0);
            while (column != 0) {
                rowOf[column] = rowOf[cameFrom[column]];
                column = cameFrom[column];
            }
        }
        var columnOf = new int[rows];
        for (int c = 1; c <= columns; c++) {
            if (rowOf[c] > 0) {
                columnOf[rowOf[c] - 1] = c - 1;
            }
        }
        return columnOf;
    }
}
