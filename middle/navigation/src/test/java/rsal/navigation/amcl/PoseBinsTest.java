package rsal.navigation.amcl;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.LinkedHashSet;
import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class PoseBinsTest {
    @ParameterizedTest
    @ValueSource(longs = {1, 2, 3})
    void countsAsASetOfRoundedPosesDoes(long seed) {
        var random = new SplittableRandom(seed);
        var bins = new PoseBins(0.5, 36);
        for (int round = 0; round < 3; round++) {
            bins.clear();
            var expected = new LinkedHashSet<List<Long>>();
            for (int i = 0; i < 2000; i++) {
                double x = random.nextDouble(-8, 8);
                double y = random.nextDouble(-3, 3);
                double theta = random.nextDouble(-Math.PI, Math.PI);
                bins.add(x, y, theta);
                expected.add(List.of((long) Math.floor(x / 0.5), (long) Math.floor(y / 0.5), (long)
                        Math.floor((theta + Math.PI) / (2 * Math.PI) * 36)));
            }
            assertThat(bins.count()).as("seed %d", seed).isEqualTo(expected.size());
        }
    }

    @ParameterizedTest
    @ValueSource(doubles = {-3.0, 0.2, 3.0})
    void headingsMeetBehind(double x) {
        var bins = new PoseBins(0.5, 36);
        int first = bins.add(x, -1, -Math.PI + 0.01);
        int second = bins.add(x + 0.5, -1, Math.PI - 0.01);
        assertThat(bins.neighbor(first, 1, 0, -1)).isEqualTo(second);
        assertThat(bins.neighbor(second, -1, 0, 1)).isEqualTo(first);
        assertThat(bins.neighbor(first, 0, 1, 0)).isEqualTo(PoseBins.NONE);
    }
}
