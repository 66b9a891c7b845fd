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
import rsal.metric.NameKind;
import rsal.metric.QuantityType;
import rsal.metric.SignalType;
import rsal.settings.Suggestion;

/// Reads conditions and metrics by recursive descent.
///
/// ```
/// condition  = both {"or" both}
/// both       = single {"and" single}
/// single     = "not" single | "(" condition ")" | all "(" name ")" | quantity relation number
/// all        = "all" and the word of a quantity that counts all, as in "allArrived"
/// quantity   = word ["(" name {"," name} ")"]
/// relation   = "<" | "<=" | ">" | ">=" | "==" | "!="
/// metric     = "firstTime" "(" condition ")" | "count" "(" quantity ")" | "explored" | "distance" ["(" role ")"]
///            | function "(" sampled ")" | "quantile" "(" number "," sampled ")"
/// function   = "last" | "min" | "mean" | "timeWeightedMean" | "rms" | "p50" | "p95" | "p99" | "max"
/// sampled    = signal ["(" role ")"] | quantity
/// ```
///
/// Words of quantities and signals, and what stands in their parentheses, are those of [RunQuantities] and of
/// the scenario's metrics ([rsal.metric.MetricType]).
///
/// Topics and names of metrics that are no words stand in quotes: `messages("fleet/tasks")`.
public final class Grammar {
    /// Characters of an expression; longer ones are refused.
    public static final int MAX_LENGTH = 1000;

    private static final int MAX_DEPTH = 50;
    private static final Pattern UNKNOWN_ALL = Pattern.compile("all\\p{Upper}[\\w-]*");
    private static final Pattern TOKEN = Pattern.compile("\\s*(?:(?<word>" + QuantityType.WORD.pattern()
            + ")|(?<quoted>\"[^\"]+\")|(?<number>-?\\d+(?:\\.\\d+)?)" + "|(?<sign>[<>=!]=?|[(),]))");
    private static final List<String> METRICS = Stream.concat(
                    Stream.of("firstTime", "count", "explored", "distance", MetricExpression.Quantile.WORD),
                    Arrays.stream(MetricExpression.Function.values()).map(MetricExpression.Function::word))
            .toList();
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
    /// @param metrics what can be asked of the run
    public record Names(
            Collection<String> roles,
            Collection<String> depots,
            Collection<String> reaches,
            Collection<String> places,
            MetricWords metrics) {
        /// Of a scenario without things, places and metrics of its own.
        public static Names of(Collection<String> roles) {
            return new Names(roles, List.of(), List.of(), List.of(), MetricWords.OF_RUNS);
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

    /// @throws InvalidExpression when the text is no metric or names another role or group
    public static MetricExpression metric(String text, Names names) {
        var grammar = new Grammar(text, names);
        return grammar.whole(grammar.metric());
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
            Optional<QuantityType> ofAll = word(names.metrics().countingAll(), QuantityType::wordForAll);
            if (ofAll.isPresent()) {
                return new Condition.All(quantity(ofAll.get()));
            }
            if (names.metrics().isOpen() && UNKNOWN_ALL.matcher(token.text).matches()) {
                return unknownAll();
            }
            return comparison();
        } finally {
            depth--;
        }
    }

    private Condition comparison() {
        Quantity left = quantity(names.metrics().predicates());
        for (var relation : Condition.Relation.values()) {
            if (takes(relation.sign())) {
                return new Condition.Compare(left, relation, number());
            }
        }
        throw expected("<, <=, >, >=, == or !=");
    }

    private Quantity quantity(List<String> known) {
        return quantity("a condition or quantity", known);
    }

    /// @param known words that may stand here
    private Quantity quantity(String what, List<String> known) {
        Optional<QuantityType> type = word(names.metrics().quantities(), QuantityType::word);
        if (type.isEmpty() && mayBeOfAnUnreadMetric()) {
            return unknownQuantity();
        }
        return quantity(type.orElseThrow(() -> unknown(what, known)));
    }

    private boolean mayBeOfAnUnreadMetric() {
        return names.metrics().isOpen()
                && token.kind == Kind.WORD
                && names.metrics().quantities().stream()
                        .noneMatch(type -> type.word().equals(token.text));
    }

    /// One of a metric that is not read.
    private Quantity unknownQuantity() {
        String word = next();
        var named = new ArrayList<String>();
        if (takes("(")) {
            do {
                named.add(anyName("a name"));
            } while (takes(","));
            take(")");
        }
        return new Quantity(QuantityType.of(word, "", ""), named);
    }

    /// `allFed(cat)`, where a metric that is not read counts what is `fed`.
    private Condition unknownAll() {
        Quantity all = unknownQuantity();
        String word = all.type().word();
        var type = QuantityType.of(Character.toLowerCase(word.charAt(3)) + word.substring(4), "", "", NameKind.ROLE)
                .countingAll();
        return new Condition.All(new Quantity(type, all.names()));
    }

    /// Of a metric that is not read; maybe each robot has samples of its own.
    private MetricExpression unknownSampled(MetricExpression.Aggregate aggregate) {
        Quantity sampled = unknownQuantity();
        return sampled.names().size() > 1
                ? new MetricExpression.OfQuantity(aggregate, sampled)
                : new MetricExpression.OfSignal(
                        aggregate,
                        SignalType.ofRobots(sampled.type().word(), "", ""),
                        sampled.names().stream().findFirst());
    }

    private Quantity quantity(QuantityType type) {
        if (type.names().isEmpty() || (type.namesAreOptional() && !token.text.equals("("))) {
            return Quantity.of(type);
        }
        var named = new ArrayList<String>();
        take("(");
        for (NameKind kind : type.names()) {
            if (!named.isEmpty()) {
                take(",");
            }
            named.add(named(kind));
        }
        take(")");
        return new Quantity(type, named);
    }

    private String named(NameKind kind) {
        return switch (kind) {
            case ROLE -> role();
            case THINGS_TO_COLLECT ->
                name("what things are called", names.depots(), "No things that have a depot are called '%s'.");
            case THINGS_TO_REACH ->
                name("what things are called", names.reaches(), "No things that have a reach are called '%s'.");
            case PLACE -> name("a place", names.places(), "No place is called '%s'.");
            case TOPIC -> anyName("a topic of messages");
            case PUBLISHED -> anyName("the name of a metric");
        };
    }

    private MetricExpression metric() {
        if (takes("firstTime")) {
            take("(");
            var metric = new MetricExpression.FirstTime(condition());
            take(")");
            return metric;
        }
        if (takes("count")) {
            take("(");
            var metric = new MetricExpression.Count(quantity(names.metrics().quantityWords()));
            take(")");
            return metric;
        }
        if (takes(RunQuantities.EXPLORED.word())) {
            return new MetricExpression.Count(Quantity.of(RunQuantities.EXPLORED));
        }
        if (takes("distance")) {
            return new MetricExpression.Distance(maybeRole());
        }
        if (takes(MetricExpression.Quantile.WORD)) {
            take("(");
            int at = token.start;
            double share = number();
            if (!(share >= 0 && share <= 1)) {
                throw new InvalidExpression(at, "A quantile is from 0 to 1.", "Maybe 0.95.");
            }
            take(",");
            return sampled(new MetricExpression.Quantile(share));
        }
        var function = word(List.of(MetricExpression.Function.values()), MetricExpression.Function::word)
                .orElseThrow(() -> unknown("a metric", METRICS));
        take("(");
        return sampled(function);
    }

    /// What the samples are of, and the end of the metric.
    private MetricExpression sampled(MetricExpression.Aggregate aggregate) {
        var signal = word(names.metrics().signals(), SignalType::word);
        MetricExpression metric;
        if (signal.isPresent()) {
            Optional<String> role = signal.get().isOfRobots() ? maybeRole() : Optional.empty();
            metric = new MetricExpression.OfSignal(aggregate, signal.get(), role);
        } else if (mayBeOfAnUnreadMetric()) {
            metric = unknownSampled(aggregate);
        } else {
            metric = new MetricExpression.OfQuantity(
                    aggregate, quantity("a signal or quantity", names.metrics().sampled()));
        }
        take(")");
        return metric;
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
        return name("a role of robots", names.roles(), "No robots have the role '%s'.");
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
            throw expected("'" + expected + "'");
        }
    }

    private InvalidExpression expected(String what) {
        return new InvalidExpression(token.start, "%s must stand here, not %s.".formatted(what, token.describe()), "");
    }

    private InvalidExpression unknown(String what, List<String> known) {
        return token.kind == Kind.WORD
                ? new InvalidExpression(
                        token.start, "'%s' is not %s.".formatted(token.text, what), Suggestion.among(token.text, known))
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
                start, "'%s' can't stand here.".formatted(Character.toString(rest.codePointAt(0))), "");
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
            return kind == Kind.END ? "the end" : "'" + text + "'";
        }
    }
}
