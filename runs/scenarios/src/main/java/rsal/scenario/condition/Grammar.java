package rsal.scenario.condition;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collection;
import java.util.List;
import java.util.Optional;
import java.util.function.Function;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import rsal.settings.Suggestion;

/// Reads conditions and measures by recursive descent.
///
/// ```
/// condition  = both {"or" both}
/// both       = single {"and" single}
/// single     = "not" single | "(" condition ")" | ("allCaught" | "allArrived") "(" role ")"
///            | ("allCollected" | "allFound" | "allReached") "(" things ")"
///            | quantity relation number
/// quantity   = "time" | "collisions" | "wallCollisions" | "faults" | "explored" | "forming"
///            | ("messages" | "heardMessages" | "lostMessages") ["(" topic ")"]
///            | ("caught" | "arrived" | "gone" | "exploring") "(" role ")"
///            | ("collected" | "found" | "reached") "(" things ")"
///            | "distance" "(" role "," role ")" | ("within" | "visits") "(" role "," place ")"
///            | "metric" "(" name ")"
/// relation   = "<" | "<=" | ">" | ">=" | "==" | "!="
/// measure    = "firstTime" "(" condition ")" | "count" "(" quantity ")" | "explored" | "distance" ["(" role ")"]
///            | function "(" sampled ")" | "quantile" "(" number "," sampled ")"
/// function   = "last" | "min" | "mean" | "timeWeightedMean" | "rms" | "p50" | "p95" | "p99" | "max"
/// sampled    = signal ["(" role ")"] | quantity
/// signal     = "poseError" | "captureDistance" | "batteryLevel" | "formationError" | "idleTime"
/// ```
///
/// Topics and names of metrics that are no words stand in quotes: `messages("fleet/tasks")`.
public final class Grammar {
    /// Characters of an expression; longer ones are refused.
    public static final int MAX_LENGTH = 1000;

    private static final int MAX_DEPTH = 50;
    private static final Pattern TOKEN = Pattern.compile("\\s*(?:(?<word>" + Quantity.WORD
            + ")|(?<quoted>\"[^\"]+\")|(?<number>-?\\d+(?:\\.\\d+)?)" + "|(?<sign>[<>=!]=?|[(),]))");
    private static final List<String> QUANTITIES =
            Arrays.stream(Quantity.Kind.values()).map(Quantity.Kind::word).toList();
    private static final List<String> PREDICATES = Stream.of(
                    Quantity.Kind.OF_ALL.stream().map(Quantity.Kind::all), QUANTITIES.stream(), Stream.of("not"))
            .flatMap(words -> words)
            .toList();
    private static final List<String> MEASURES = Stream.concat(
                    Stream.of("firstTime", "count", "explored", "distance", Measure.Quantile.WORD),
                    Arrays.stream(Measure.Function.values()).map(Measure.Function::word))
            .toList();
    private static final List<String> SAMPLED = Stream.concat(
                    Arrays.stream(Measure.Signal.values()).map(Measure.Signal::word), QUANTITIES.stream())
            .toList();

    private static final Quantity EXPLORED = new Quantity(Quantity.Kind.EXPLORED, List.of());

    private final String text;
    private final Names names;
    private final Matcher matcher;
    private Token token;
    private int depth;

    /// What an expression may name.
    ///
    /// @param roles of the scenario's robots
    /// @param depots groups of things that have a depot
    /// @param reaches groups of things to which robots are to get
    /// @param places parts of the floor
    public record Names(
            Collection<String> roles,
            Collection<String> depots,
            Collection<String> reaches,
            Collection<String> places) {
        /// Of a scenario without things and places.
        public static Names of(Collection<String> roles) {
            return new Names(roles, List.of(), List.of(), List.of());
        }
    }

    private Grammar(String text, Names names) {
        if (text.length() > MAX_LENGTH) {
            throw new InvalidExpression(
                    MAX_LENGTH, "An expression may have %d characters at most.".formatted(MAX_LENGTH), "");
        }
        this.text = text;
        this.names = names;
        this.matcher = TOKEN.matcher(text);
        this.token = read(0);
    }

    /// @throws InvalidExpression when the text is no condition or names another role or group
    public static Condition condition(String text, Names names) {
        var grammar = new Grammar(text, names);
        return grammar.whole(grammar.condition());
    }

    /// @throws InvalidExpression when the text is no measure or names another role or group
    public static Measure measure(String text, Names names) {
        var grammar = new Grammar(text, names);
        return grammar.whole(grammar.measure());
    }

    private <T> T whole(T tree) {
        if (token.kind != Kind.END) {
            throw expected("and, or, or the end");
        }
        return tree;
    }

    private Condition condition() {
        Condition left = both();
        while (takes("or")) {
            left = new Condition.Or(left, both());
        }
        return left;
    }

    private Condition both() {
        Condition left = single();
        while (takes("and")) {
            left = new Condition.And(left, single());
        }
        return left;
    }

    private Condition single() {
        if (++depth > MAX_DEPTH) {
            throw new InvalidExpression(token.start, "Parentheses are nested deeper than %d.".formatted(MAX_DEPTH), "");
        }
        try {
            if (takes("not")) {
                return new Condition.Not(single());
            }
            if (takes("(")) {
                Condition inner = condition();
                take(")");
                return inner;
            }
            Optional<Quantity.Kind> ofAll = word(Quantity.Kind.OF_ALL, Quantity.Kind::all);
            if (ofAll.isPresent()) {
                return new Condition.All(quantity(ofAll.get()));
            }
            return comparison();
        } finally {
            depth--;
        }
    }

    private Condition comparison() {
        Quantity left = quantity(PREDICATES);
        for (var relation : Condition.Relation.values()) {
            if (takes(relation.sign())) {
                return new Condition.Compare(left, relation, number());
            }
        }
        throw expected("<, <=, >, >=, == or !=");
    }

    /// @param known words that may stand here
    private Quantity quantity(List<String> known) {
        return quantity(word(List.of(Quantity.Kind.values()), Quantity.Kind::word)
                .orElseThrow(() -> unknown("a condition or quantity", known)));
    }

    private Quantity quantity(Quantity.Kind kind) {
        var of = kind.of();
        if (of.isEmpty() || (of.contains(Quantity.Of.MAYBE_TOPIC) && !token.text.equals("("))) {
            return new Quantity(kind, List.of());
        }
        var named = new ArrayList<String>();
        take("(");
        for (Quantity.Of one : of) {
            if (!named.isEmpty()) {
                take(",");
            }
            named.add(named(one));
        }
        take(")");
        return new Quantity(kind, named);
    }

    private String named(Quantity.Of of) {
        return switch (of) {
            case ROLE -> role();
            case DEPOT ->
                name("what things are called", names.depots(), "No things that have a depot are called (%s).");
            case REACH ->
                name("what things are called", names.reaches(), "No things that have a reach are called (%s).");
            case PLACE -> name("a place", names.places(), "No place is called (%s).");
            case MAYBE_TOPIC -> anyName("a topic of messages");
            case METRIC -> anyName("the name of a metric");
        };
    }

    private Measure measure() {
        if (takes("firstTime")) {
            take("(");
            var measure = new Measure.FirstTime(condition());
            take(")");
            return measure;
        }
        if (takes("count")) {
            take("(");
            var measure = new Measure.Count(quantity(QUANTITIES));
            take(")");
            return measure;
        }
        if (takes(EXPLORED.kind().word())) {
            return new Measure.Count(EXPLORED);
        }
        if (takes("distance")) {
            return new Measure.Distance(maybeRole());
        }
        if (takes(Measure.Quantile.WORD)) {
            take("(");
            int at = token.start;
            double share = number();
            if (!(share >= 0 && share <= 1)) {
                throw new InvalidExpression(at, "A quantile is from 0 to 1.", "Maybe 0.95.");
            }
            take(",");
            return sampled(new Measure.Quantile(share));
        }
        var function = word(List.of(Measure.Function.values()), Measure.Function::word)
                .orElseThrow(() -> unknown("a measure", MEASURES));
        take("(");
        return sampled(function);
    }

    /// What the samples are of, and the end of the measure.
    private Measure sampled(Measure.Aggregate aggregate) {
        var signal = word(List.of(Measure.Signal.values()), Measure.Signal::word);
        Measure measure;
        if (signal.isPresent()) {
            Optional<String> role = signal.get().isOfRobots() ? maybeRole() : Optional.empty();
            measure = new Measure.OfSignal(aggregate, signal.get(), role);
        } else {
            var kind = word(List.of(Quantity.Kind.values()), Quantity.Kind::word)
                    .orElseThrow(() -> unknown("a signal or quantity", SAMPLED));
            measure = new Measure.OfQuantity(aggregate, quantity(kind));
        }
        take(")");
        return measure;
    }

    private <E> Optional<E> word(List<E> known, Function<E, String> word) {
        for (E each : known) {
            if (takes(word.apply(each))) {
                return Optional.of(each);
            }
        }
        return Optional.empty();
    }

    private Optional<String> maybeRole() {
        if (!takes("(")) {
            return Optional.empty();
        }
        String role = role();
        if (token.text.equals(",")) {
            throw new InvalidExpression(
                    token.start, "A distance between two roles changes all the time.", "Maybe min(distance(…, …)).");
        }
        take(")");
        return Optional.of(role);
    }

    private String role() {
        return name("a role of robots", names.roles(), "No robots have the role (%s).");
    }

    /// @param unknown a sentence about a word that is none of these
    private String name(String what, Collection<String> known, String unknown) {
        if (token.kind != Kind.WORD) {
            throw expected(what);
        }
        if (!known.contains(token.text)) {
            throw new InvalidExpression(
                    token.start, unknown.formatted(token.text), Suggestion.among(token.text, known));
        }
        return next();
    }

    /// One that only agents know.
    private String anyName(String what) {
        if (token.kind == Kind.QUOTED) {
            String quoted = next();
            return quoted.substring(1, quoted.length() - 1);
        }
        if (token.kind != Kind.WORD) {
            throw expected(what);
        }
        return next();
    }

    private String next() {
        String text = token.text;
        token = read(token.end);
        return text;
    }

    private double number() {
        if (token.kind != Kind.NUMBER) {
            throw expected("a number");
        }
        double number = Double.parseDouble(token.text);
        if (!Double.isFinite(number)) {
            throw new InvalidExpression(token.start, "This number is too large.", "");
        }
        token = read(token.end);
        return number;
    }

    private boolean takes(String expected) {
        if (!token.text.equals(expected)) {
            return false;
        }
        token = read(token.end);
        return true;
    }

    private void take(String expected) {
        if (!takes(expected)) {
            throw expected("(" + expected + ")");
        }
    }

    private InvalidExpression expected(String what) {
        return new InvalidExpression(token.start, "%s must stand here, not %s.".formatted(what, token.describe()), "");
    }

    private InvalidExpression unknown(String what, List<String> known) {
        return token.kind == Kind.WORD
                ? new InvalidExpression(
                        token.start, "(%s) is not %s.".formatted(token.text, what), Suggestion.among(token.text, known))
                : expected(what);
    }

    private Token read(int from) {
        matcher.region(from, text.length());
        if (matcher.lookingAt()) {
            for (Kind kind : List.of(Kind.WORD, Kind.QUOTED, Kind.NUMBER, Kind.SIGN)) {
                String found = matcher.group(kind.group);
                if (found != null) {
                    return new Token(kind, found, matcher.start(kind.group), matcher.end());
                }
            }
        }
        String rest = text.substring(from).stripLeading();
        int start = text.length() - rest.length();
        if (rest.isEmpty()) {
            return new Token(Kind.END, "", start, start);
        }
        throw new InvalidExpression(
                start, "(%s) can't stand here.".formatted(Character.toString(rest.codePointAt(0))), "");
    }

    private enum Kind {
        WORD("word"),
        QUOTED("quoted"),
        NUMBER("number"),
        SIGN("sign"),
        END("");

        private final String group;

        Kind(String group) {
            this.group = group;
        }
    }

    private record Token(Kind kind, String text, int start, int end) {
        String describe() {
            return kind == Kind.END ? "the end" : "(" + text + ")";
        }
    }
}
