package rsal.scenario.condition;

/// A number that a run has at any instant. As text it is as people write it: `time`, `caught(prey)`.
///
/// @param role of robots; empty where the kind is of the whole run
public record Quantity(Kind kind, String role) {
    /// What there is to ask, in the order in which people are told.
    public enum Kind {
        /// [s]
        TIME("time", false),
        COLLISIONS("collisions", false),
        WALL_COLLISIONS("wallCollisions", false),
        CAUGHT("caught", true),
        ARRIVED("arrived", true),
        GONE("gone", true),
        FAULTS("faults", false),
        MESSAGES("messages", false),
        HEARD_MESSAGES("heardMessages", false),
        LOST_MESSAGES("lostMessages", false),
        /// Share of the reachable floor, 0 to 1; NaN while no robot tells a map.
        EXPLORED("explored", false),
        EXPLORING("exploring", true);

        private final String word;
        private final boolean ofRole;

        Kind(String word, boolean ofRole) {
            this.word = word;
            this.ofRole = ofRole;
        }

        public String word() {
            return word;
        }

        /// Whether each role has its own.
        public boolean isOfRole() {
            return ofRole;
        }
    }

    public double of(Facts facts) {
        return switch (kind) {
            case TIME -> facts.time();
            case COLLISIONS -> facts.collisions();
            case WALL_COLLISIONS -> facts.wallCollisions();
            case CAUGHT -> facts.caught(role);
            case ARRIVED -> facts.arrived(role);
            case GONE -> facts.gone(role);
            case FAULTS -> facts.faults();
            case MESSAGES -> facts.messages();
            case HEARD_MESSAGES -> facts.heardMessages();
            case LOST_MESSAGES -> facts.lostMessages();
            case EXPLORED -> facts.explored();
            case EXPLORING -> facts.exploring(role);
        };
    }

    @Override
    public String toString() {
        return kind.ofRole ? kind.word + "(" + role + ")" : kind.word;
    }
}
