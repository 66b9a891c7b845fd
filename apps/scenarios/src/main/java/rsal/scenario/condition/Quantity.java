package rsal.scenario.condition;

/// A number that a run has at any instant. As text it is as people write it.
public sealed interface Quantity {
    double of(Facts facts);

    /// `time` [s].
    record Time() implements Quantity {
        @Override
        public double of(Facts facts) {
            return facts.time();
        }

        @Override
        public String toString() {
            return "time";
        }
    }

    /// `collisions`.
    record Collisions() implements Quantity {
        @Override
        public double of(Facts facts) {
            return facts.collisions();
        }

        @Override
        public String toString() {
            return "collisions";
        }
    }

    /// `wallCollisions`.
    record WallCollisions() implements Quantity {
        @Override
        public double of(Facts facts) {
            return facts.wallCollisions();
        }

        @Override
        public String toString() {
            return "wallCollisions";
        }
    }

    /// `faults`.
    record Faults() implements Quantity {
        @Override
        public double of(Facts facts) {
            return facts.faults();
        }

        @Override
        public String toString() {
            return "faults";
        }
    }

    /// `lostMessages`.
    record LostMessages() implements Quantity {
        @Override
        public double of(Facts facts) {
            return facts.lostMessages();
        }

        @Override
        public String toString() {
            return "lostMessages";
        }
    }

    /// `gone(prey)`.
    record Gone(String role) implements Quantity {
        @Override
        public double of(Facts facts) {
            return facts.gone(role);
        }

        @Override
        public String toString() {
            return "gone(" + role + ")";
        }
    }

    /// `caught(prey)`.
    record Caught(String role) implements Quantity {
        @Override
        public double of(Facts facts) {
            return facts.caught(role);
        }

        @Override
        public String toString() {
            return "caught(" + role + ")";
        }
    }
}
