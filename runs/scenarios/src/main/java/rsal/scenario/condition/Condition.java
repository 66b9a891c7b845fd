package rsal.scenario.condition;

import java.math.BigDecimal;
import java.util.stream.Stream;

/// What can be true of a run: `allCaught(prey) and not time < 10`. As text it is as people write it.
public sealed interface Condition {
    boolean holds(Facts facts);

    /// All that it asks for.
    Stream<Quantity> quantities();

    /// `time > 300`.
    record Compare(Quantity left, Relation relation, double right) implements Condition {
        @Override
        public boolean holds(Facts facts) {
            double value = facts.value(left);
            return switch (relation) {
                case LESS -> value < right;
                case AT_MOST -> value <= right;
                case GREATER -> value > right;
                case AT_LEAST -> value >= right;
                case EQUAL -> value == right;
                case OTHER -> value < right || value > right; // nothing holds of what is not known
            };
        }

        @Override
        public Stream<Quantity> quantities() {
            return Stream.of(left);
        }

        @Override
        public String toString() {
            return "%s %s %s"
                    .formatted(
                            left,
                            relation.sign(),
                            BigDecimal.valueOf(right).stripTrailingZeros().toPlainString());
        }
    }

    /// `allCaught(prey)`: all that there are and that are still to come. Of robots that are gone nobody expects
    /// that they arrive.
    record All(Quantity quantity) implements Condition {
        @Override
        public boolean holds(Facts facts) {
            return facts.holdsForAll(quantity);
        }

        @Override
        public Stream<Quantity> quantities() {
            return Stream.of(quantity);
        }

        @Override
        public String toString() {
            return quantity.type().wordForAll() + "(" + quantity.names().getFirst() + ")";
        }
    }

    record And(Condition left, Condition right) implements Condition {
        @Override
        public boolean holds(Facts facts) {
            return left.holds(facts) && right.holds(facts);
        }

        @Override
        public Stream<Quantity> quantities() {
            return Stream.concat(left.quantities(), right.quantities());
        }

        @Override
        public String toString() {
            return operand(left) + " and " + operand(right);
        }

        private static String operand(Condition condition) {
            return condition instanceof Or ? "(" + condition + ")" : condition.toString();
        }
    }

    record Or(Condition left, Condition right) implements Condition {
        @Override
        public boolean holds(Facts facts) {
            return left.holds(facts) || right.holds(facts);
        }

        @Override
        public Stream<Quantity> quantities() {
            return Stream.concat(left.quantities(), right.quantities());
        }

        @Override
        public String toString() {
            return left + " or " + right;
        }
    }

    record Not(Condition inner) implements Condition {
        @Override
        public boolean holds(Facts facts) {
            return !inner.holds(facts);
        }

        @Override
        public Stream<Quantity> quantities() {
            return inner.quantities();
        }

        @Override
        public String toString() {
            return "not " + operand(inner);
        }

        private static String operand(Condition condition) {
            return condition instanceof Or || condition instanceof And ? "(" + condition + ")" : condition.toString();
        }
    }

    enum Relation {
        LESS("<"),
        AT_MOST("<="),
        GREATER(">"),
        AT_LEAST(">="),
        EQUAL("=="),
        OTHER("!=");

        private final String sign;

        Relation(String sign) {
            this.sign = sign;
        }

        public String sign() {
            return sign;
        }
    }
}
