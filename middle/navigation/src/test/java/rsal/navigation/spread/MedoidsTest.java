package rsal.navigation.spread;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Arrays;
import java.util.SplittableRandom;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import rsal.navigation.grid.RandomMaps;

class MedoidsTest {
    @ParameterizedTest
    @ValueSource(longs = {1, 2, 3, 4, 5, 6, 7, 8})
    void noSwapBettersWhatIsChosen(long seed) {
        var random = new SplittableRandom(seed);
        var ground = ReachableSpace.largest(RandomMaps.of(random, 24, 20, 0.3 * random.nextDouble()), 0);
        var patches = new Patches(ground, 2);
        var distances = PatchDistances.between(patches);
        var may = new boolean[patches.count()];
        Arrays.fill(may, true);
        var medoids = new Medoids(distances);
        int[] chosen = medoids.seed(1 + random.nextInt(6), may, random);

        double sum = medoids.swap(chosen, may);

        assertThat(sum).as("seed %d", seed).isEqualTo(sum(distances, chosen));
        for (int k = 0; k < chosen.length; k++) {
            for (int other = 0; other < patches.count(); other++) {
                int[] swapped = chosen.clone();
                swapped[k] = other;
                assertThat(sum(distances, swapped))
                        .as("seed %d: %d in place of %d", seed, other, chosen[k])
                        .isGreaterThanOrEqualTo(sum * (1 - 1e-6));
            }
        }
    }

    private static double sum(PatchDistances distances, int[] chosen) {
        double sum = 0;
        for (int to = 0; to < distances.size(); to++) {
            double nearest = Double.POSITIVE_INFINITY;
            for (int from : chosen) {
                nearest = Math.min(nearest, distances.squares()[from * distances.size() + to]);
            }
            sum += distances.weights()[to] * nearest;
        }
        return sum;
    }
}
