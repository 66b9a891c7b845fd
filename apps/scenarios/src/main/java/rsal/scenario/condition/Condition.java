package rsal.scenario.condition;

import java.math.BigDecimal;

/// What can be true of a run: `allCaught(prey) and not time < 10`. As text it is as people write it.
public sealed interface Condition {
    boolean holds(Facts facts);

    /// `time > 300`.
    record Compare(Quantity left, Relation relation, double right) implements Condition {
        @Override
        public boolean holds(Facts facts) {
            double value = left.of(facts);
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
        public String toString() {
            return "%s %s %s"
                    .formatted(
                            left,
                            relation.sign(),
                            BigDecimal.valueOf(right).stripTrailingZeros().toPlainString());
        }
    }

    /// `allCaught(prey)`.
    record AllCaught(String role) implements Condition {
        @Override
        public boolean holds(Facts facts) {
            return facts.caught(role) >= facts.robots(role);
        }

        @Override
        public String toString() {
            return "allCaught(" + role + ")";
        }
    }

    /// `allArrived(robot)`: all that are not gone have reached the places where they were sent last.
    record AllArrived(String role) implements Condition {
        @Override
        public boolean holds(Facts facts) {
            int there = facts.robots(role) - facts.gone(role);
            return there > 0 && facts.arrived(role) >= there;
        }

        @Override
        public String toString() {
            return "allArrived(" + role + ")";
        }
    }

    /// `allCollected(object)`: all that there are and that are still to come lie in their depot.
    record AllCollected(String things) implements Condition {
        @Override
        public boolean holds(Facts facts) {
            return facts.collected(things) >= facts.things(things);
        }

        @Override
        public String toString() {
            return "allCollected(" + things + ")";
        }
    }

    /// `allFound(victim)`: of all that there are and that are still to come somebody has said where they are, and was
    /// right.
    record AllFound(String things) implements Condition {
        @Override
        public boolean holds(Facts facts) {
            return facts.found(things) >= facts.things(things);
        }

        @Override
        public String toString() {
            return "allFound(" + things + ")";
        }
    }

    /// `allReached(victim)`: a robot has got to each of all that there are and that are still to come.
    record AllReached(String things) implements Condition {
        @Override
        public boolean holds(Facts facts) {
            return facts.reached(things) >= facts.things(things);
        }

        @Override
        public String toString() {
            return "allReached(" + things + ")";
        }
    }

    record And(Condition left, Condition right) implements Condition {
        @Override
        public boolean holds(Facts facts) {
            return left.holds(facts) && right.holds(facts);
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
