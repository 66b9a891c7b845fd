package rsal.scenario.condition;

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
/// quantity   = "time" | "collisions" | "wallCollisions" | "faults"
///            | "messages" | "heardMessages" | "lostMessages" | "explored" | "forming"
///            | ("caught" | "arrived" | "gone" | "exploring") "(" role ")"
///            | ("collected" | "found" | "reached") "(" things ")"
/// relation   = "<" | "<=" | ">" | ">=" | "==" | "!="
/// measure    = "firstTime" "(" condition ")" | "count" "(" quantity ")" | "explored" | "distance" ["(" role ")"]
///            | function "(" signal ["(" role ")"] ")"
/// function   = "min" | "mean" | "rms" | "p50" | "p95" | "p99" | "max"
/// signal     = "poseError" | "captureDistance" | "batteryLevel" | "formationError" | "idleTime"
/// ```
public final class Grammar {
    /// Characters of an expression; longer ones are refused.
    public static final int MAX_LENGTH = 1000;

    private static final int MAX_DEPTH = 50;
    private static final Pattern TOKEN =
            Pattern.compile("\\s*(?:(?<word>\\p{Alpha}[\\w-]*)|(?<number>-?\\d+(?:\\.\\d+)?)|(?<sign>[<>=!]=?|[()]))");
    private static final List<String> QUANTITIES =
            Arrays.stream(Quantity.Kind.values()).map(Quantity.Kind::word).toList();
    private static final List<String> PREDICATES = Stream.of(
                    Quantity.Kind.OF_ALL.stream().map(Quantity.Kind::all), QUANTITIES.stream(), Stream.of("not"))
            .flatMap(words -> words)
            .toList();
    private static final List<String> MEASURES =
            List.of("firstTime", "count", "explored", "distance", "min", "mean", "rms", "p50", "p95", "p99", "max");

    private static final Quantity EXPLORED = new Quantity(Quantity.Kind.EXPLORED, "");

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
    public record Names(Collection<String> roles, Collection<String> depots, Collection<String> reaches) {
        /// Of a scenario without things.
        public static Names of(Collection<String> roles) {
            return new Names(roles, List.of(), List.of());
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
        return new Quantity(
                kind,
                switch (kind.of()) {
                    case RUN -> "";
                    case ROLE -> role();
                    case DEPOT -> depot();
                    case REACH -> reach();
                });
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
        var function = word(List.of(Measure.Function.values()), Measure.Function::word)
                .orElseThrow(() -> unknown("a measure", MEASURES));
        take("(");
        var signal = word(List.of(Measure.Signal.values()), Measure.Signal::word)
                .orElseThrow(() -> unknown(
                        "a signal",
                        Arrays.stream(Measure.Signal.values())
                                .map(Measure.Signal::word)
                                .toList()));
        Optional<String> role = signal.isOfRobots() ? maybeRole() : Optional.empty();
        take(")");
        return new Measure.Statistic(function, signal, role);
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
        return token.text.equals("(") ? Optional.of(role()) : Optional.empty();
    }

    private String role() {
        return name("a role of robots", names.roles(), "No robots have the role (%s).");
    }

    private String depot() {
        return name("what things are called", names.depots(), "No things that have a depot are called (%s).");
    }

    private String reach() {
        return name("what things are called", names.reaches(), "No things that have a reach are called (%s).");
    }

    /// @param unknown a sentence about a word that is none of these
    private String name(String what, Collection<String> known, String unknown) {
        take("(");
        if (token.kind != Kind.WORD) {
            throw expected(what);
        }
        if (!known.contains(token.text)) {
            throw new InvalidExpression(
                    token.start, unknown.formatted(token.text), Suggestion.among(token.text, known));
        }
        String name = token.text;
        token = read(token.end);
        take(")");
        return name;
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
            for (Kind kind : List.of(Kind.WORD, Kind.NUMBER, Kind.SIGN)) {
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
