package rsal.scenario.condition;

import java.util.List;
import java.util.Locale;

/// A number that a run has at any instant. As text it is as people write it: `time`, `caught(prey)`.
///
/// @param whose a role of robots or a group of things; empty where the kind is of the whole run
public record Quantity(Kind kind, String whose) {
    /// What there is to ask, in the order in which people are told.
    public enum Kind {
        /// [s]
        TIME("time", Of.RUN),
        COLLISIONS("collisions", Of.RUN),
        WALL_COLLISIONS("wallCollisions", Of.RUN),
        CAUGHT("caught", Of.ROLE),
        ARRIVED("arrived", Of.ROLE),
        GONE("gone", Of.ROLE),
        FAULTS("faults", Of.RUN),
        MESSAGES("messages", Of.RUN),
        HEARD_MESSAGES("heardMessages", Of.RUN),
        LOST_MESSAGES("lostMessages", Of.RUN),
        /// Share of the reachable floor, 0 to 1; NaN while no robot tells a map.
        EXPLORED("explored", Of.RUN),
        EXPLORING("exploring", Of.ROLE),
        /// [s]
        FORMING("forming", Of.RUN),
        COLLECTED("collected", Of.DEPOT),
        FOUND("found", Of.REACH),
        REACHED("reached", Of.REACH);

        /// What can be asked of all.
        static final List<Kind> OF_ALL = List.of(CAUGHT, ARRIVED, COLLECTED, FOUND, REACHED);

        private final String word;
        private final Of of;

        Kind(String word, Of of) {
            this.word = word;
            this.of = of;
        }

        public String word() {
            return word;
        }

        /// The word for the condition that it is so of all (`allCaught`), for those in [#OF_ALL].
        String all() {
            return "all" + word.substring(0, 1).toUpperCase(Locale.ROOT) + word.substring(1);
        }

        /// What has its own.
        public Of of() {
            return of;
        }
    }

    /// What has a quantity.
    public enum Of {
        RUN,
        ROLE,
        /// Things that are to be brought somewhere.
        DEPOT,
        /// Things to which robots are to get.
        REACH
    }

    public double of(Facts facts) {
        return switch (kind) {
            case TIME -> facts.time();
            case COLLISIONS -> facts.collisions();
            case WALL_COLLISIONS -> facts.wallCollisions();
            case CAUGHT -> facts.caught(whose);
            case ARRIVED -> facts.arrived(whose);
            case GONE -> facts.gone(whose);
            case FAULTS -> facts.faults();
            case MESSAGES -> facts.messages();
            case HEARD_MESSAGES -> facts.heardMessages();
            case LOST_MESSAGES -> facts.lostMessages();
            case EXPLORED -> facts.explored();
            case EXPLORING -> facts.exploring(whose);
            case FORMING -> facts.forming();
            case COLLECTED -> facts.collected(whose);
            case FOUND -> facts.found(whose);
            case REACHED -> facts.reached(whose);
        };
    }

    @Override
    public String toString() {
        return kind.of == Of.RUN ? kind.word : kind.word + "(" + whose + ")";
    }
}
