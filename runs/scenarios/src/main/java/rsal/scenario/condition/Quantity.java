package rsal.scenario.condition;

import java.util.List;
import java.util.Locale;
import java.util.Set;
import java.util.regex.Pattern;
import java.util.stream.Collectors;

/// A number that a run has at any instant. As text it is as people write it: `time`, `caught(prey)`,
/// `distance(prey, hunter)`.
///
/// @param names of what it is, as [Kind#of] says; empty where it is of the whole run
public record Quantity(Kind kind, List<String> names) {
    /// What a name is that needs no quotes.
    static final String WORD = "\\p{Alpha}[\\w-]*";

    private static final Pattern PLAIN = Pattern.compile(WORD);

    public Quantity {
        names = List.copyOf(names);
    }

    /// What there is to ask, in the order in which people are told.
    public enum Kind {
        /// [s]
        TIME("time"),
        COLLISIONS("collisions"),
        WALL_COLLISIONS("wallCollisions"),
        CAUGHT("caught", Of.ROLE),
        ARRIVED("arrived", Of.ROLE),
        GONE("gone", Of.ROLE),
        FAULTS("faults"),
        MESSAGES("messages", Of.MAYBE_TOPIC),
        HEARD_MESSAGES("heardMessages", Of.MAYBE_TOPIC),
        LOST_MESSAGES("lostMessages", Of.MAYBE_TOPIC),
        /// Share of the reachable floor, 0 to 1; NaN while no robot tells a map.
        EXPLORED("explored"),
        EXPLORING("exploring", Of.ROLE),
        /// [s]
        FORMING("forming"),
        COLLECTED("collected", Of.DEPOT),
        FOUND("found", Of.REACH),
        REACHED("reached", Of.REACH),
        /// Of the two nearest robots [m]; NaN while there are none.
        DISTANCE("distance", Of.ROLE, Of.ROLE),
        WITHIN("within", Of.ROLE, Of.PLACE),
        VISITS("visits", Of.ROLE, Of.PLACE),
        /// As an agent published it last; NaN before the first.
        METRIC("metric", Of.METRIC);

        /// What can be asked of all.
        static final List<Kind> OF_ALL = List.of(CAUGHT, ARRIVED, COLLECTED, FOUND, REACHED);

        /// Those for which somebody must note where robots are.
        public static final Set<Kind> OF_POSITIONS = Set.of(DISTANCE, WITHIN, VISITS);

        private final String word;

        @SuppressWarnings("ImmutableEnumChecker") // made by List.of
        private final List<Of> of;

        Kind(String word, Of... of) {
            this.word = word;
            this.of = List.of(of);
        }

        public String word() {
            return word;
        }

        /// The word for the condition that it is so of all (`allCaught`), for those in [#OF_ALL].
        String all() {
            return "all" + word.substring(0, 1).toUpperCase(Locale.ROOT) + word.substring(1);
        }

        /// What stands in its parentheses; empty where it is of the whole run.
        public List<Of> of() {
            return of;
        }
    }

    /// What a name in parentheses means.
    public enum Of {
        ROLE,
        /// Things that are to be brought somewhere.
        DEPOT,
        /// Things to which robots are to get.
        REACH,
        /// Of messages; all topics together without one.
        MAYBE_TOPIC,
        PLACE,
        METRIC
    }

    /// The first of its names; only for kinds that have one.
    String whose() {
        return names.getFirst();
    }

    public double of(Facts facts) {
        return switch (kind) {
            case TIME -> facts.time();
            case COLLISIONS -> facts.collisions();
            case WALL_COLLISIONS -> facts.wallCollisions();
            case CAUGHT -> facts.caught(whose());
            case ARRIVED -> facts.arrived(whose());
            case GONE -> facts.gone(whose());
            case FAULTS -> facts.faults();
            case MESSAGES -> names.isEmpty() ? facts.messages() : facts.messages(whose());
            case HEARD_MESSAGES -> names.isEmpty() ? facts.heardMessages() : facts.heardMessages(whose());
            case LOST_MESSAGES -> names.isEmpty() ? facts.lostMessages() : facts.lostMessages(whose());
            case EXPLORED -> facts.explored();
            case EXPLORING -> facts.exploring(whose());
            case FORMING -> facts.forming();
            case COLLECTED -> facts.collected(whose());
            case FOUND -> facts.found(whose());
            case REACHED -> facts.reached(whose());
            case DISTANCE -> facts.distance(whose(), names.get(1));
            case WITHIN -> facts.within(whose(), names.get(1));
            case VISITS -> facts.visits(whose(), names.get(1));
            case METRIC -> facts.metric(whose());
        };
    }

    @Override
    public String toString() {
        return names.isEmpty()
                ? kind.word
                : names.stream().map(Quantity::written).collect(Collectors.joining(", ", kind.word + "(", ")"));
    }

    private static String written(String name) {
        return PLAIN.matcher(name).matches() ? name : '"' + name + '"';
    }
}
