package rsal.data;

import java.util.Arrays;
import java.util.function.IntPredicate;

/// Exact Euclidean distances in a grid of cells, from middle to middle.
///
/// P. Felzenszwalb, D. Huttenlocher: Distance Transforms of Sampled Functions, Theory of Computing 8 (2012),
/// algorithm 1 along the rows. Differs in that the columns, which hold only zero and infinity, are done by
/// counting.
public final class DistanceTransform {
    private DistanceTransform() {}

    /// Takes one row of the answer.
    public interface Row {
        /// @param squares of the distance of each cell of the row to the nearest target [cells²], +∞ when there is
        /// no target; overwritten by the next row
        void row(int row, double[] squares);
    }

    /// Measures from every cell to the nearest target.
    ///
    /// @param target by index of the cell, row by row
    /// @param rows told of each row, from 0 on
    public static void measure(int width, int height, IntPredicate target, Row rows) {
        int none = width + height; // cells; farther than anything in the grid
        int[] inColumn = distancesInColumns(width, height, target, none);
        var squares = new double[width];
        var answer = new double[width];
        var parabolas = new int[width];
        var borders = new double[width + 1];
        for (int row = 0; row < height; row++) {
            int start = row * width;
            for (int column = 0; column < width; column++) {
                double cells = inColumn[start + column];
                squares[column] = cells * cells;
            }
            lowerEnvelope(squares, parabolas, borders);
            int k = 0;
            for (int column = 0; column < width; column++) {
                while (borders[k + 1] < column) {
                    k++;
                }
                double dx = column - parabolas[k];
                double square = dx * dx + squares[parabolas[k]];
                answer[column] = square >= (double) none * none ? Double.POSITIVE_INFINITY : square;
            }
            rows.row(row, answer);
        }
    }

    private static int[] distancesInColumns(int width, int height, IntPredicate target, int none) {
        var distances = new int[Math.multiplyExact(width, height)];
        for (int i = 0; i < distances.length; i++) {
            int below = i < width ? none : distances[i - width];
            distances[i] = target.test(i) ? 0 : Math.min(none, below + 1);
        }
        for (int i = distances.length - width - 1; i >= 0; i--) {
            distances[i] = Math.min(distances[i], distances[i + width] + 1);
        }
        return distances;
    }

    /// Which of the parabolas `(x − i)² + squares[i]` is lowest where: parabola `k` of the answer from
    /// `borders[k]` to `borders[k + 1]`.
    private static void lowerEnvelope(double[] squares, int[] parabolas, double[] borders) {
        Arrays.fill(borders, Double.POSITIVE_INFINITY);
        int k = 0;
        parabolas[0] = 0;
        borders[0] = Double.NEGATIVE_INFINITY;
        for (int q = 1; q < squares.length; q++) {
            double crossing = crossing(squares, q, parabolas[k]);
            while (crossing <= borders[k]) {
                k--;
                crossing = crossing(squares, q, parabolas[k]);
            }
            k++;
            parabolas[k] = q;
            borders[k] = crossing;
        }
        borders[k + 1] = Double.POSITIVE_INFINITY;
    }

    private static double crossing(double[] squares, int q, int v) {
        return (squares[q] + (double) q * q - squares[v] - (double) v * v) / (2.0 * (q - v));
    }
}
