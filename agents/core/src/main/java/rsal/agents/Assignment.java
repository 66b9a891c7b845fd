package rsal.agents;

import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.SortedMap;
import rsal.data.Pose2d;

/// Who goes for whom: each hunter for one prey, as many for each prey as for any other, give or take one, with the
/// least sum of straight distances.
///
/// A prey that a hunter goes for already counts as [#LOYALTY] times its distance, so that two who are about
/// equally far do not change over again and again. Same reports, same answer, whoever asks.
final class Assignment {
    static final double LOYALTY = 0.8;

    private static final double EVENNESS = 1e6; // m, longer than all ways together

    private Assignment() {}

    /// @param hunters where they are, by id
    /// @param prey where those who are free are, by id
    /// @param before which prey each hunter goes for so far
    /// @return prey by hunter; empty without prey
    static Map<String, String> nearest(
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

    /// The column of its own for each row that makes the sum of costs least: shortest augmenting paths (Kuhn, "The
    /// Hungarian method for the assignment problem", 1955, in the O(n³) form of Jonker and Volgenant, 1987).
    ///
    /// Adds one row after another, each by the cheapest chain of changes among those before it. Prices of rows and
    /// columns keep every reduced cost at 0 or more, so that the chain is a shortest path. Index 0 stands for "not
    /// yet": inside, rows and columns count from 1.
    ///
    /// @param cost no fewer columns than rows
    static int[] pair(double[][] cost) {
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
