package rsal.navigation.slam;

import java.util.Arrays;
import java.util.BitSet;
import java.util.List;

/// A symmetric system of equations in blocks of 3 × 3, most of them zero, solved after Cholesky: T. Davis,
/// Direct Methods for Sparse Linear Systems (SIAM 2006), chapters 4 and 7. Unknowns are eliminated in the
/// order of least degree, found once for a graph, as its numbers change while its shape stays.
///
/// Own since a library for it would be larger than the rest of this package; the columns are pushed to the
/// right instead of gathered from the left.
final class Blocks {
    private final int count;
    private final int[] place; // of an unknown in the order of elimination
    private final int[][] below; // by column: rows of its blocks that are not zero, below its diagonal
    private final double[][] diagonal; // by column
    private final double[][] blocks; // by column, 9 for each of `below`
    private final double[] right; // in the order of elimination

    /// @param relations which unknowns have to do with each other, by pairs below `count`
    Blocks(int count, List<int[]> relations) {
        this.count = count;
        var neighbors = new BitSet[count];
        Arrays.setAll(neighbors, _ -> new BitSet(count));
        for (int[] pair : relations) {
            neighbors[pair[0]].set(pair[1]);
            neighbors[pair[1]].set(pair[0]);
        }
        place = new int[count];
        var columns = new BitSet[count];
        eliminate(neighbors, columns);
        below = new int[count][];
        for (int column = 0; column < count; column++) {
            below[column] = columns[column].stream()
                    .map(unknown -> place[unknown])
                    .sorted()
                    .toArray();
        }
        diagonal = new double[count][9];
        blocks = new double[count][];
        Arrays.setAll(blocks, column -> new double[9 * below[column].length]);
        right = new double[3 * count];
    }

    private void eliminate(BitSet[] neighbors, BitSet[] columns) {
        var degree = new int[count];
        var left = new BitSet(count);
        left.set(0, count);
        Arrays.setAll(degree, i -> neighbors[i].cardinality());
        for (int next = 0; next < count; next++) {
            int least = left.nextSetBit(0);
            for (int i = least; i >= 0 && degree[least] > 1; i = left.nextSetBit(i + 1)) {
                least = degree[i] < degree[least] ? i : least;
            }
            int chosen = least;
            place[chosen] = next;
            left.clear(chosen);
            BitSet around = neighbors[chosen];
            columns[next] = around;
            around.stream().forEach(i -> {
                neighbors[i].or(around);
                neighbors[i].clear(i);
                neighbors[i].clear(chosen);
                degree[i] = neighbors[i].cardinality();
            });
        }
    }

    void clear() {
        for (int column = 0; column < count; column++) {
            Arrays.fill(diagonal[column], 0);
            Arrays.fill(blocks[column], 0);
        }
        Arrays.fill(right, 0);
    }

    /// Adds to the block of two unknowns, row by row; for two different ones in one order only.
    void add(int one, int other, double[] block) {
        int row = place[one];
        int column = place[other];
        if (row == column) {
            for (int i = 0; i < 9; i++) {
                diagonal[row][i] += block[i];
            }
            return;
        }
        boolean flipped = row < column;
        int at = 9 * Arrays.binarySearch(below[flipped ? row : column], flipped ? column : row);
        double[] into = blocks[flipped ? row : column];
        for (int i = 0; i < 3; i++) {
            for (int k = 0; k < 3; k++) {
                into[at + 3 * i + k] += flipped ? block[3 * k + i] : block[3 * i + k];
            }
        }
    }

    /// Adds to what is before the diagonal.
    void addToDiagonal(double factor) {
        for (double[] block : diagonal) {
            for (int i = 0; i < 9; i += 4) {
                block[i] += factor * block[i] + 1e-9;
            }
        }
    }

    void addRight(int unknown, double x, double y, double theta) {
        int at = 3 * place[unknown];
        right[at] += x;
        right[at + 1] += y;
        right[at + 2] += theta;
    }

    /// Solves and forgets the equations.
    ///
    /// @return three numbers for each unknown; not finite where the equations don't tell
    double[] solve() {
        factor();
        for (int column = 0; column < count; column++) { // L y = right
            lowerSolve(diagonal[column], right, 3 * column);
            for (int i = 0; i < below[column].length; i++) {
                int row = 3 * below[column][i];
                for (int k = 0; k < 3; k++) {
                    int at = 9 * i + 3 * k;
                    right[row + k] -= blocks[column][at] * right[3 * column]
                            + blocks[column][at + 1] * right[3 * column + 1]
                            + blocks[column][at + 2] * right[3 * column + 2];
                }
            }
        }
        for (int column = count - 1; column >= 0; column--) { // transposed L
            for (int i = 0; i < below[column].length; i++) {
                int row = 3 * below[column][i];
                for (int k = 0; k < 3; k++) {
                    right[3 * column + k] -= blocks[column][9 * i + k] * right[row]
                            + blocks[column][9 * i + 3 + k] * right[row + 1]
                            + blocks[column][9 * i + 6 + k] * right[row + 2];
                }
            }
            upperSolve(diagonal[column], right, 3 * column);
        }
        var solution = new double[3 * count];
        for (int unknown = 0; unknown < count; unknown++) {
            System.arraycopy(right, 3 * place[unknown], solution, 3 * unknown, 3);
        }
        return solution;
    }

    private void factor() {
        var position = new int[count];
        for (int column = 0; column < count; column++) {
            root(diagonal[column]);
            double[] own = blocks[column];
            int[] rows = below[column];
            for (int i = 0; i < rows.length; i++) {
                for (int k = 0; k < 3; k++) {
                    lowerSolve(diagonal[column], own, 9 * i + 3 * k);
                }
            }
            for (int i = 0; i < rows.length; i++) {
                int target = rows[i];
                subtract(own, 9 * i, own, 9 * i, diagonal[target], 0);
                for (int k = 0; k < below[target].length; k++) {
                    position[below[target][k]] = 9 * k;
                }
                for (int k = i + 1; k < rows.length; k++) {
                    subtract(own, 9 * k, own, 9 * i, blocks[target], position[rows[k]]);
                }
            }
        }
    }

    /// Of a block of its own: L with L Lᵀ = block.
    private static void root(double[] block) {
        block[0] = Math.sqrt(block[0]);
        block[3] /= block[0];
        block[6] /= block[0];
        block[4] = Math.sqrt(block[4] - block[3] * block[3]);
        block[7] = (block[7] - block[6] * block[3]) / block[4];
        block[8] = Math.sqrt(block[8] - block[6] * block[6] - block[7] * block[7]);
    }

    private static void lowerSolve(double[] root, double[] values, int at) {
        values[at] /= root[0];
        values[at + 1] = (values[at + 1] - root[3] * values[at]) / root[4];
        values[at + 2] = (values[at + 2] - root[6] * values[at] - root[7] * values[at + 1]) / root[8];
    }

    private static void upperSolve(double[] root, double[] values, int at) {
        values[at + 2] /= root[8];
        values[at + 1] = (values[at + 1] - root[7] * values[at + 2]) / root[4];
        values[at] = (values[at] - root[3] * values[at + 1] - root[6] * values[at + 2]) / root[0];
    }

    private static void subtract(double[] a, int atA, double[] b, int atB, double[] from, int at) {
        for (int i = 0; i < 3; i++) {
            for (int k = 0; k < 3; k++) {
                from[at + 3 * i + k] -= a[atA + 3 * i] * b[atB + 3 * k]
                        + a[atA + 3 * i + 1] * b[atB + 3 * k + 1]
                        + a[atA + 3 * i + 2] * b[atB + 3 * k + 2];
            }
        }
    }
}
