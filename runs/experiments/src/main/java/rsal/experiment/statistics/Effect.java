package rsal.experiment.statistics;

import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;

/// What it does to change one thing and nothing else: the mean difference within blocks, in which all the
/// rest is the same. Runs with the same seed are a block: much of what differs between seeds does not matter
/// then. The blocks, not the pairs, are what the confidence interval counts as independent (a paired t-test,
/// blocks as in D. Montgomery, Design and Analysis of Experiments, 8th edition, chapters 2.5 and 4.1; the
/// main effect, an average over the levels of all that is varied besides, as there in 5.1).
///
/// @param blocks how many there are
/// @param difference the new value less the old; empty where no block is complete
public record Effect(int blocks, Optional<Mean> difference) {
    /// @param from the value before the change; empty when there is none
    /// @param to the value after it
    public record Pair(OptionalDouble from, OptionalDouble to) {
        /// Empty where one of both is missing.
        public OptionalDouble change() {
            return isComplete() ? OptionalDouble.of(difference()) : OptionalDouble.empty();
        }

        private boolean isComplete() {
            return from.isPresent() && to.isPresent();
        }

        private double difference() {
            return to.getAsDouble() - from.getAsDouble();
        }
    }

    /// Blocks that lack a value are left out, as their means would be of something else.
    ///
    /// @param blocks pairs of each, the same in all of them: one for each way to set what else is varied
    public static Effect of(List<List<Pair>> blocks) {
        double[] differences = blocks.stream()
                .filter(pairs -> !pairs.isEmpty() && pairs.stream().allMatch(Pair::isComplete))
                .mapToDouble(pairs ->
                        pairs.stream().mapToDouble(Pair::difference).average().getAsDouble())
                .toArray();
        return new Effect(
                blocks.size(), differences.length == 0 ? Optional.empty() : Optional.of(Mean.of(differences)));
    }

    /// How many blocks were complete.
    public int complete() {
        return difference.map(Mean::count).orElse(0);
    }

    /// How probable such a difference or a greater one is if changing it does nothing; empty for fewer than two
    /// complete blocks.
    public OptionalDouble pValue() {
        return difference.map(Mean::pValue).orElseGet(OptionalDouble::empty);
    }
}
