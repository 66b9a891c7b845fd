package rsal.navigation.slam;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import org.openjdk.jmh.annotations.Benchmark;
import org.openjdk.jmh.annotations.Fork;
import org.openjdk.jmh.annotations.Measurement;
import org.openjdk.jmh.annotations.Param;
import org.openjdk.jmh.annotations.Scope;
import org.openjdk.jmh.annotations.Setup;
import org.openjdk.jmh.annotations.State;
import org.openjdk.jmh.annotations.Warmup;

/// Equations of a step in fitting a graph of poses filled in and solved [1/s], block by block, against C. Gauss's
/// elimination of the whole matrix. Each pose has to do with the next, and every fifth with one a round before.
@State(Scope.Thread)
@Fork(1)
@Warmup(iterations = 3, time = 2)
@Measurement(iterations = 5, time = 2)
public class GraphSteps {
    private static final int ROUND = 40; // poses

    @Param({"100", "300"})
    int poses;

    private final List<Added> added = new ArrayList<>();
    private double[] right;
    private Blocks blocks;

    /// @param block of two poses, row by row
    private record Added(int one, int other, double[] block) {}

    @Setup
    public void relate() {
        var random = new SplittableRandom(1);
        var pairs = new ArrayList<int[]>();
        for (int pose = 1; pose < poses; pose++) {
            pairs.add(new int[] {pose - 1, pose});
            if (pose % 5 == 0 && pose >= ROUND) {
                pairs.add(new int[] {pose - ROUND, pose});
            }
        }
        added.add(new Added(0, 0, new double[] {1, 0, 0, 0, 1, 0, 0, 0, 1})); // the first is held
        for (int[] pair : pairs) {
            double[] a = numbers(random);
            double[] b = numbers(random);
            added.add(new Added(pair[0], pair[0], product(a, a)));
            added.add(new Added(pair[1], pair[1], product(b, b)));
            added.add(new Added(pair[0], pair[1], product(a, b)));
        }
        right = random.doubles(3L * poses).toArray();
        blocks = new Blocks(poses, pairs);
        double[] exact = slow();
        double[] found = kernel();
        for (int i = 0; i < exact.length; i++) {
            if (!(Math.abs(found[i] - exact[i]) < 1e-6 * Math.max(1, Math.abs(exact[i])))) {
                throw new IllegalStateException("Number %d: %s is not %s.".formatted(i, found[i], exact[i]));
            }
        }
    }

    @Benchmark
    public double[] kernel() {
        blocks.clear();
        for (Added a : added) {
            blocks.add(a.one, a.other, a.block);
        }
        for (int pose = 0; pose < poses; pose++) {
            blocks.addRight(pose, right[3 * pose], right[3 * pose + 1], right[3 * pose + 2]);
        }
        return blocks.solve();
    }

    @Benchmark
    public double[] slow() {
        int count = 3 * poses;
        var rows = new double[count][count + 1];
        for (Added a : added) {
            for (int i = 0; i < 9; i++) {
                rows[3 * a.one + i / 3][3 * a.other + i % 3] += a.block[i];
                if (a.one != a.other) {
                    rows[3 * a.other + i % 3][3 * a.one + i / 3] += a.block[i];
                }
            }
        }
        for (int i = 0; i < count; i++) {
            rows[i][count] = right[i];
        }
        for (int i = 0; i < count; i++) { // the matrix is positive definite, so that no row need be changed for another
            for (int below = i + 1; below < count; below++) {
                double times = rows[below][i] / rows[i][i];
                for (int k = i; k <= count; k++) {
                    rows[below][k] -= times * rows[i][k];
                }
            }
        }
        var solution = new double[count];
        for (int i = count - 1; i >= 0; i--) {
            double sum = rows[i][count];
            for (int k = i + 1; k < count; k++) {
                sum -= rows[i][k] * solution[k];
            }
            solution[i] = sum / rows[i][i];
        }
        return solution;
    }

    private static double[] numbers(SplittableRandom random) {
        var numbers = random.doubles(9, -0.3, 0.3).toArray();
        for (int i = 0; i < 9; i += 4) {
            numbers[i] += 1;
        }
        return numbers;
    }

    /// aᵀ b
    private static double[] product(double[] a, double[] b) {
        var product = new double[9];
        for (int i = 0; i < 9; i++) {
            for (int k = 0; k < 3; k++) {
                product[i] += a[3 * k + i / 3] * b[3 * k + i % 3];
            }
        }
        return product;
    }
}
