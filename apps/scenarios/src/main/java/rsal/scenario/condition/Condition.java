package rsal.scenario.condition;

/// What can be true of a run: `allCaught(prey) and not time < 10`.
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
                case OTHER -> value != right;
            };
        }
    }

    /// `allCaught(prey)`.
    record AllCaught(String role) implements Condition {
        @Override
        public boolean holds(Facts facts) {
            return facts.caught(role) >= facts.robots(role);
        }
    }

    record And(Condition left, Condition right) implements Condition {
        @Override
        public boolean holds(Facts facts) {
            return left.holds(facts) && right.holds(facts);
        }
    }

    record Or(Condition left, Condition right) implements Condition {
        @Override
        public boolean holds(Facts facts) {
            return left.holds(facts) || right.holds(facts);
        }
    }

    record Not(Condition inner) implements Condition {
        @Override
        public boolean holds(Facts facts) {
            return !inner.holds(facts);
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
