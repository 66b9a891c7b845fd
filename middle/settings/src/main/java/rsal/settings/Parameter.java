package rsal.settings;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Collectors;
import rsal.data.Point2d;

/// Something that may be set: an argument of a scenario or an agent, an option of a driver. Declared once, it
/// serves validation, help, the JSON Schema, command line flags and the page's form; and code that reads its
/// value gets it with its type.
///
/// @param <T> type of the value, as [Arguments#get] gives it; follows from the kind
/// @param fallback the value when none is given; empty when one must be
/// @param min least value of a number or integer; −∞ when there is none
/// @param max greatest value; +∞ when there is none
/// @param options allowed values of a text, empty when any will do; of robots, words that are allowed besides
///         their names
/// @param unit `m`, `s`, `deg`; empty when it has none
/// @param description a sentence for people
/// @param plugins which plugins there are; of [Kind#PLUGIN] and [Kind#PLUGINS] only
public record Parameter<T>(
        String name,
        Kind kind,
        Optional<Object> fallback,
        double min,
        double max,
        List<String> options,
        String unit,
        String description,
        Optional<PluginKind> plugins) {

    public enum Kind {
        NUMBER,
        INTEGER,
        TEXT,
        FLAG,
        /// A text that names robots of the scenario, by their role or one by its id.
        ROBOTS,
        /// A text that names places in the map [m] where robots are to go, as [Places] reads it.
        PLACES,
        /// The same, of places where no robot has to go.
        POINTS,
        /// A plugin by its name, or a group with its name or file as `type` and values for its own parameters.
        PLUGIN,
        /// Several plugins in an order, each as [#PLUGIN] has it; one alone needs no list.
        PLUGINS,
        /// Texts by name.
        TEXTS
    }

    public Parameter {
        options = List.copyOf(options);
    }

    /// One that chooses no plugin.
    public Parameter(
            String name,
            Kind kind,
            Optional<Object> fallback,
            double min,
            double max,
            List<String> options,
            String unit,
            String description) {
        this(name, kind, fallback, min, max, options, unit, description, Optional.empty());
    }

    public static Parameter<Double> number(
            String name, double fallback, double min, double max, String unit, String description) {
        return new Parameter<>(name, Kind.NUMBER, Optional.of(fallback), min, max, List.of(), unit, description);
    }

    public static Parameter<Integer> integer(
            String name, long fallback, long min, long max, String unit, String description) {
        return new Parameter<>(name, Kind.INTEGER, Optional.of(fallback), min, max, List.of(), unit, description);
    }

    public static Parameter<String> text(String name, String fallback, String description) {
        return new Parameter<>(name, Kind.TEXT, Optional.of(fallback), -inf(), inf(), List.of(), "", description);
    }

    /// A text that must be given.
    public static Parameter<String> text(String name, String description) {
        return new Parameter<>(name, Kind.TEXT, Optional.empty(), -inf(), inf(), List.of(), "", description);
    }

    public static Parameter<String> choice(String name, String fallback, List<String> options, String description) {
        return new Parameter<>(name, Kind.TEXT, Optional.of(fallback), -inf(), inf(), options, "", description);
    }

    /// Those that know the robots refuse what names none of them, the fallback too.
    ///
    /// @param others words that mean something else, as `all`
    public static Parameter<String> robots(String name, String fallback, List<String> others, String description) {
        return new Parameter<>(name, Kind.ROBOTS, Optional.of(fallback), -inf(), inf(), others, "", description);
    }

    /// Places where robots are to go; none when nothing is given.
    public static Parameter<List<Point2d>> places(String name, String description) {
        return new Parameter<>(name, Kind.PLACES, Optional.of(""), -inf(), inf(), List.of(), "", description);
    }

    /// Places where no robot has to go; none when nothing is given.
    public static Parameter<List<Point2d>> points(String name, String description) {
        return new Parameter<>(name, Kind.POINTS, Optional.of(""), -inf(), inf(), List.of(), "", description);
    }

    /// A plugin.
    ///
    /// @param fallback key of the one that is installed and used when none is chosen, with its defaults
    public static Parameter<PluginChoice> plugin(String name, String fallback, PluginKind plugins, String description) {
        return new Parameter<>(
                name,
                Kind.PLUGIN,
                Optional.of(plugins.choose(fallback)),
                -inf(),
                inf(),
                plugins.keys(),
                "",
                description,
                Optional.of(plugins));
    }

    /// Plugins in an order.
    ///
    /// @param fallback keys of those that are used when none is chosen, with their defaults
    public static Parameter<List<PluginChoice>> plugins(
            String name, List<String> fallback, PluginKind plugins, String description) {
        return new Parameter<>(
                name,
                Kind.PLUGINS,
                Optional.of(fallback.stream().map(plugins::choose).toList()),
                -inf(),
                inf(),
                plugins.keys(),
                "",
                description,
                Optional.of(plugins));
    }

    /// The same without a value to fall back on: one must be given.
    public Parameter<T> required() {
        return new Parameter<>(name, kind, Optional.empty(), min, max, options, unit, description, plugins);
    }

    /// The value as people write it when it is short: keys of plugins, anything else as it is.
    public static Object shown(Object value) {
        return switch (value) {
            case PluginChoice chosen -> chosen.toString();
            case List<?> several -> several.stream().map(String::valueOf).collect(Collectors.joining(", "));
            default -> value;
        };
    }

    /// Texts by name; none when nothing is given.
    public static Parameter<Map<String, String>> texts(String name, String description) {
        return new Parameter<>(name, Kind.TEXTS, Optional.of(Map.of()), -inf(), inf(), List.of(), "", description);
    }

    public static Parameter<Boolean> flag(String name, boolean fallback, String description) {
        return new Parameter<>(name, Kind.FLAG, Optional.of(fallback), -inf(), inf(), List.of(), "", description);
    }

    private static double inf() {
        return Double.POSITIVE_INFINITY;
    }

    /// The value as this parameter's kind: Double, Long, String, Boolean, [PluginChoice] or a list of these.
    /// Integers pass for numbers; a key, or a map with a `type` besides values, for a plugin.
    ///
    /// @throws IllegalArgumentException with a sentence about what is wrong with it
    public Object accept(Object value) {
        if (kind == Kind.PLUGIN) {
            return plugin(value);
        }
        if (kind == Kind.PLUGINS) {
            return (value instanceof List<?> several ? several : List.of(value))
                    .stream().map(this::plugin).toList();
        }
        Object converted = switch (kind) {
            case NUMBER -> value instanceof Number n ? (Object) n.doubleValue() : value;
            case INTEGER ->
                value instanceof Integer || value instanceof Long ? (Object) ((Number) value).longValue() : value;
            case TEXT, FLAG, ROBOTS, PLACES, POINTS, PLUGIN, PLUGINS, TEXTS -> value;
        };
        boolean right = switch (kind) {
            case NUMBER -> converted instanceof Double d && Double.isFinite(d);
            case INTEGER -> converted instanceof Long;
            case TEXT, ROBOTS -> converted instanceof String;
            case PLACES, POINTS ->
                converted instanceof String s && Places.read(s).isPresent();
            case FLAG -> converted instanceof Boolean;
            case TEXTS -> isTexts(converted);
            case PLUGIN, PLUGINS -> true; // taken above
        };
        if (!right) {
            throw new IllegalArgumentException("'%s' must be %s, not '%s'.".formatted(name, expected(), value));
        }
        if (converted instanceof Number n && !(n.doubleValue() >= min && n.doubleValue() <= max)) {
            throw new IllegalArgumentException("'%s' must be %s, not '%s'.".formatted(name, expected(), value));
        }
        if (kind == Kind.TEXT && converted instanceof String s && !options.isEmpty() && !options.contains(s)) {
            throw new IllegalArgumentException(
                    "'%s' must be %s, not '%s'. %s".formatted(name, expected(), value, Suggestion.among(s, options)));
        }
        return converted;
    }

    private PluginChoice plugin(Object value) {
        PluginKind known = plugins.orElseThrow();
        return switch (value) {
            case PluginChoice chosen when known.type().isInstance(chosen.plugin()) -> chosen;
            case String key -> known.choose(key);
            case Map<?, ?> group -> {
                var values = new LinkedHashMap<String, Object>();
                group.forEach((name, each) -> values.put(String.valueOf(name), each));
                yield known.choose(String.valueOf(values.remove("type")), values);
            }
            default ->
                throw new IllegalArgumentException("'%s' must be %s, not '%s'.".formatted(name, expected(), value));
        };
    }

    /// Reads a value as typed on a command line or in a form.
    ///
    /// @throws IllegalArgumentException with a sentence about what is wrong with it
    public Object parse(String typed) {
        Object value = typed;
        try {
            switch (kind) {
                case NUMBER -> value = Double.parseDouble(typed);
                case INTEGER -> value = Long.parseLong(typed);
                case FLAG ->
                    value = typed.equals("true") ? (Object) true : typed.equals("false") ? (Object) false : typed;
                case PLUGINS -> value = List.of(typed.split("\\s*,\\s*", -1));
                case TEXTS -> value = texts(typed);
                case TEXT, ROBOTS, PLACES, POINTS, PLUGIN -> {}
            }
        } catch (NumberFormatException _) {
            // stays a text, which accept refuses with the right words
        }
        return accept(value);
    }

    private static boolean isTexts(Object value) {
        return value instanceof Map<?, ?> all
                && all.entrySet().stream()
                        .allMatch(each -> each.getKey() instanceof String && each.getValue() instanceof String);
    }

    /// `a=1, b=2` by name; what is no such list stays a text, which [#accept] refuses with the right words.
    private static Object texts(String typed) {
        var all = new LinkedHashMap<String, String>();
        for (String each : typed.split("\\s*,\\s*", -1)) {
            int equals = each.indexOf('=');
            if (equals < 1) {
                return typed;
            }
            all.put(each.substring(0, equals), each.substring(equals + 1));
        }
        return all;
    }

    /// What helps somebody who chose what can't be chosen, as a sentence; empty where there is no choice.
    public String advice() {
        return options.isEmpty() || description.isEmpty()
                ? ""
                : "'%s': %s.".formatted(name, description.replaceAll("\\.$", ""));
    }

    /// This one, when its value names robots.
    @SuppressWarnings("unchecked") // follows from the kind
    public Optional<Parameter<String>> ofRobots() {
        return kind == Kind.ROBOTS ? Optional.of((Parameter<String>) this) : Optional.empty();
    }

    /// This one, when its value is places, whether robots are to go there or not.
    @SuppressWarnings("unchecked") // follows from the kind
    public Optional<Parameter<List<Point2d>>> ofPlaces() {
        return kind == Kind.PLACES || kind == Kind.POINTS
                ? Optional.of((Parameter<List<Point2d>>) this)
                : Optional.empty();
    }

    /// A value that [#accept] has taken, with its type.
    @SuppressWarnings("unchecked") // the factories above give each kind its type
    T read(Object accepted) {
        return (T)
                switch (kind) {
                    case INTEGER -> (Object) Math.toIntExact((Long) accepted);
                    case PLACES, POINTS -> Places.read((String) accepted).orElseThrow(); // taken as such
                    case NUMBER, TEXT, FLAG, ROBOTS, PLUGIN, PLUGINS, TEXTS -> accepted;
                };
    }

    /// "a number from 0.3 to 3 [m]"
    public String expected() {
        String what = switch (kind) {
            case NUMBER -> "a number";
            case INTEGER -> "a whole number";
            case TEXT -> options.isEmpty() ? "a text" : "one of " + String.join(", ", options);
            case FLAG -> "true or false";
            case PLUGIN -> "one of %s, or your own file".formatted(String.join(", ", options));
            case PLUGINS -> "one or several of %s, or your own files".formatted(String.join(", ", options));
            case PLACES, POINTS -> "places as x y; x y [m]";
            case TEXTS -> "texts by name as NAME=TEXT, NAME=TEXT";
            case ROBOTS -> "a role of robots or the id of one" + besides();
        };
        if (min > -inf() && max < inf()) {
            what += " from " + plain(min) + " to " + plain(max);
        } else if (min > -inf()) {
            what += " of at least " + plain(min);
        } else if (max < inf()) {
            what += " of at most " + plain(max);
        }
        return unit.isEmpty() ? what : what + " [" + unit + "]";
    }

    private String besides() {
        return options.stream()
                .map(word -> word.isEmpty() ? " or nothing" : " or " + word)
                .collect(Collectors.joining());
    }

    private static String plain(double value) {
        return value == Math.rint(value) && Math.abs(value) < 1e15
                ? Long.toString((long) value)
                : Double.toString(value);
    }
}
