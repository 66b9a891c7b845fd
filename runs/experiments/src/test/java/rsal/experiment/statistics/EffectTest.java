package rsal.experiment.statistics;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.List;
import java.util.OptionalDouble;
import java.util.Random;
import org.junit.jupiter.api.Test;
import rsal.experiment.statistics.Effect.Pair;

class EffectTest {
    @Test
    void whatDiffersBetweenBlocksDoesNotMatter() {
        Effect effect = Effect.of(List.of(List.of(pair(1, 3)), List.of(pair(100, 103)), List.of(pair(-50, -46))));
        assertThat(effect.difference().orElseThrow().value()).isEqualTo(3);
        assertThat(effect.difference().orElseThrow().deviation()).isEqualTo(1);
        assertThat(effect.pValue().orElseThrow()).isLessThan(0.05); // 3 ± 2.48
    }

    @Test
    void blocksThatLackAValueAreLeftOutAndCounted() {
        var missing = new Pair(OptionalDouble.of(9), OptionalDouble.empty());
        Effect effect = Effect.of(List.of(List.of(pair(1, 2), missing), List.of(pair(1, 2), pair(4, 7))));
        assertThat(effect.blocks()).isEqualTo(2);
        assertThat(effect.complete()).isEqualTo(1);
        assertThat(effect.difference().orElseThrow().value()).isEqualTo(2);
        assertThat(effect.pValue()).isEmpty();
        assertThat(Effect.of(List.of(List.of(missing))).difference()).isEmpty();
    }

    /// The main effect by its definition: mean at one level less mean at the other.
    @Test
    void isTheDifferenceOfTheMeansOfItsLevels() {
        var random = new Random(3);
        for (int i = 0; i < 200; i++) {
            int others = 1 + random.nextInt(5);
            var blocks = new ArrayList<List<Pair>>();
            double from = 0;
            double to = 0;
            int count = 0;
            for (int block = 0; block < 1 + random.nextInt(8); block++) {
                var pairs = new ArrayList<Pair>();
                for (int k = 0; k < others; k++) {
                    Pair pair = pair(random.nextGaussian(), random.nextGaussian());
                    from += pair.from().orElseThrow();
                    to += pair.to().orElseThrow();
                    count++;
                    pairs.add(pair);
                }
                blocks.add(pairs);
            }
            assertThat(Effect.of(blocks).difference().orElseThrow().value())
                    .as("try %d", i)
                    .isEqualTo(to / count - from / count, within(1e-9));
        }
    }

    /// With seeds that matter to all runs of a block alike and to the change itself, 95 % of the intervals
    /// hold the truth; counting pairs instead of blocks as independent would make it far fewer.
    @Test
    void holdsTheTruthAsOftenAsItSays() {
        var random = new Random(11);
        int trials = 5_000;
        int held = 0;
        for (int i = 0; i < trials; i++) {
            var blocks = new ArrayList<List<Pair>>();
            for (int block = 0; block < 6; block++) {
                double seed = 10 * random.nextGaussian();
                double liking = 2 * random.nextGaussian();
                var pairs = new ArrayList<Pair>();
                for (int k = 0; k < 4; k++) {
                    pairs.add(pair(seed + random.nextGaussian(), seed + 1 + liking + random.nextGaussian()));
                }
                blocks.add(pairs);
            }
            held += Effect.of(blocks)
                            .difference()
                            .orElseThrow()
                            .interval()
                            .orElseThrow()
                            .holds(1)
                    ? 1
                    : 0;
        }
        assertThat((double) held / trials).isEqualTo(0.95, within(4 * Math.sqrt(0.95 * 0.05 / trials)));
    }

    private static Pair pair(double from, double to) {
        return new Pair(OptionalDouble.of(from), OptionalDouble.of(to));
    }
}
