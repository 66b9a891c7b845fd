package rsal.scenario.condition;

import java.math.BigDecimal;
import java.util.Optional;
import java.util.stream.Stream;
import rsal.metric.SignalType;

/// What to measure over a whole run: `p95(poseError)`. As text it is as people write it.
public sealed interface MetricExpression {
    /// Of which robots it is; empty for all, or when it is of none.
    default Optional<String> role() {
        return Optional.empty();
    }

    /// All that it asks for.
    default Stream<Quantity> quantities() {
        return Stream.empty();
    }

    /// Whether each robot can have a value of its own.
    default boolean canBePerRobot() {
        return false;
    }

    /// `firstTime(allCaught(prey))`: when a condition held first [s]; nothing when it never did.
    record FirstTime(Condition condition) implements MetricExpression {
        @Override
        public Stream<Quantity> quantities() {
            return condition.quantities();
        }

        @Override
        public String toString() {
            return "firstTime(" + condition + ")";
        }
    }

    /// `count(collisions)`, `explored`: what a quantity is at the end; nothing when it is not known.
    record Count(Quantity quantity) implements MetricExpression {
        @Override
        public Stream<Quantity> quantities() {
            return Stream.of(quantity);
        }

        @Override
        public String toString() {
            return quantity.type().equals(RunQuantities.EXPLORED) ? quantity.toString() : "count(" + quantity + ")";
        }
    }

    /// `distance`, `distance(hunter)`: the way that robots really made, all together [m].
    ///
    /// @param role empty for all robots
    record Distance(Optional<String> role) implements MetricExpression {
        @Override
        public boolean canBePerRobot() {
            return true;
        }

        @Override
        public String toString() {
            return "distance" + inParentheses(role);
        }
    }

    /// `p95(poseError)`, `max(poseError(hunter))`: of all samples of a signal; nothing without samples.
    ///
    /// @param role empty for all robots
    record OfSignal(Aggregate aggregate, SignalType signal, Optional<String> role) implements MetricExpression {
        @Override
        public boolean canBePerRobot() {
            return signal.isOfRobots();
        }

        @Override
        public String toString() {
            return aggregate.of(signal.word() + inParentheses(role));
        }
    }

    /// `min(distance(prey, hunter))`, `quantile(0.9, metric(load))`: of what a quantity was after each step, or
    /// of each value that an agent published; nothing while it was not known.
    record OfQuantity(Aggregate aggregate, Quantity quantity) implements MetricExpression {
        /// Whether agents publish the values.
        public boolean isPublished() {
            return quantity.type().equals(RunQuantities.METRIC);
        }

        @Override
        public Stream<Quantity> quantities() {
            return Stream.of(quantity);
        }

        @Override
        public boolean canBePerRobot() {
            return isPublished();
        }

        @Override
        public String toString() {
            return aggregate.of(quantity.toString());
        }
    }

    private static String inParentheses(Optional<String> role) {
        return role.map(name -> "(" + name + ")").orElse("");
    }

    /// How many samples become one number. Percentiles and quantiles are by nearest rank: the least sample that
    /// at least such a share is not above.
    sealed interface Aggregate {
        /// As people write it.
        String of(String what);
    }

    /// Those that have a name of their own.
    enum Function implements Aggregate {
        LAST("last"),
        MIN("min"),
        MEAN("mean"),
        /// Each value counts as long as it was the newest, the last one until the end of the run.
        TIME_WEIGHTED_MEAN("timeWeightedMean"),
        /// Root of the mean square.
        RMS("rms"),
        P50("p50"),
        P95("p95"),
        P99("p99"),
        MAX("max");

        private final String word;

        Function(String word) {
            this.word = word;
        }

        public String word() {
            return word;
        }

        @Override
        public String of(String what) {
            return "%s(%s)".formatted(word, what);
        }
    }

    /// `quantile(0.9, …)`.
    ///
    /// @param share 0 to 1
    record Quantile(double share) implements Aggregate {
        static final String WORD = "quantile";

        @Override
        public String of(String what) {
            return "%s(%s, %s)"
                    .formatted(
                            WORD, BigDecimal.valueOf(share).stripTrailingZeros().toPlainString(), what);
        }
    }
}
