package rsal.navigation.slam;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.SplittableRandom;
import org.assertj.core.data.Offset;
import org.junit.jupiter.api.RepeatedTest;
import org.junit.jupiter.api.RepetitionInfo;

class BlocksTest {
    @RepeatedTest(10)
    void whatItSolvesFulfillsTheEquations(RepetitionInfo repetition) {
        var random = new SplittableRandom(repetition.getCurrentRepetition());
        int count = 2 + random.nextInt(30);
        var pairs = new ArrayList<int[]>();
        for (int i = 1; i < count; i++) {
            pairs.add(new int[] {i - 1, i});
        }
        for (int i = 0; i < count / 2; i++) {
            int one = random.nextInt(count);
            int other = random.nextInt(count);
            if (one != other) {
                pairs.add(new int[] {one, other});
            }
        }
        var blocks = new Blocks(count, pairs);
        var dense = new double[3 * count][3 * count];
        for (int[] pair : pairs) {
            double[] block = random.doubles(9, -1, 1).toArray();
            blocks.add(pair[0], pair[1], block);
            put(dense, pair[0], pair[1], block);
            put(dense, pair[1], pair[0], transposed(block));
        }
        for (int i = 0; i < count; i++) {
            double[] block = {40, 1, 2, 1, 50, 3, 2, 3, 60};
            blocks.add(i, i, block);
            put(dense, i, i, block);
        }
        double[] right = random.doubles(3L * count, -5, 5).toArray();
        for (int i = 0; i < count; i++) {
            blocks.addRight(i, right[3 * i], right[3 * i + 1], right[3 * i + 2]);
        }

        double[] solution = blocks.solve();

        for (int row = 0; row < 3 * count; row++) {
            double sum = 0;
            for (int column = 0; column < 3 * count; column++) {
                sum += dense[row][column] * solution[column];
            }
            assertThat(sum)
                    .as("seed %d, row %d", repetition.getCurrentRepetition(), row)
                    .isCloseTo(right[row], Offset.offset(1e-9));
        }
    }

    private static void put(double[][] dense, int row, int column, double[] block) {
        for (int i = 0; i < 9; i++) {
            dense[3 * row + i / 3][3 * column + i % 3] += block[i];
        }
    }

    private static double[] transposed(double[] block) {
        return new double[] {block[0], block[3], block[6], block[1], block[4], block[7], block[2], block[5], block[8]};
    }
}
