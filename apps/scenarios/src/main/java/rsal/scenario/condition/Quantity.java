package rsal.scenario.condition;

/// A number that a run has at any instant.
public sealed interface Quantity {
    double of(Facts facts);

    /// `time` [s].
    record Time() implements Quantity {
        @Override
        public double of(Facts facts) {
            return facts.time();
        }
    }

    /// `collisions`.
    record Collisions() implements Quantity {
        @Override
        public double of(Facts facts) {
            return facts.collisions();
        }
    }

    /// `wallCollisions`.
    record WallCollisions() implements Quantity {
        @Override
        public double of(Facts facts) {
            return facts.wallCollisions();
        }
    }

    /// `caught(prey)`.
    record Caught(String role) implements Quantity {
        @Override
        public double of(Facts facts) {
            return facts.caught(role);
        }
    }
}
