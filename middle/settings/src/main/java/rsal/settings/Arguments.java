package rsal.settings;

import java.time.Duration;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.Stream;
import rsal.data.Point2d;

/// Values for a list of parameters, checked, with fallbacks filled in. Asking for what was not declared is a
/// mistake of the code.
public final class Arguments {
    private final Map<String, Object> values;

    private Arguments(Map<String, Object> values) {
        this.values = Collections.unmodifiableMap(values);
    }

    /// @throws IllegalArgumentException with a sentence when a value is unknown, wrong or missing
    public static Arguments of(List<Parameter> parameters, Map<String, ?> given) {
        var values = new LinkedHashMap<String, Object>();
        for (String name : given.keySet()) {
            if (parameters.stream().noneMatch(p -> p.name().equals(name))) {
                throw new IllegalArgumentException("(%s) is not known here. %s"
                        .formatted(
                                name,
                                Suggestion.among(
                                        name,
                                        parameters.stream().map(Parameter::name).toList())));
            }
        }
        for (Parameter parameter : parameters) {
            Object value = given.get(parameter.name());
            if (value != null) {
                values.put(parameter.name(), parameter.accept(value));
            } else {
                values.put(
                        parameter.name(),
                        parameter
                                .fallback()
                                .orElseThrow(() -> new IllegalArgumentException("(%s) is missing: %s, %s."
                                        .formatted(parameter.name(), parameter.description(), parameter.expected()))));
            }
        }
        return new Arguments(values);
    }

    public static Arguments defaults(List<Parameter> parameters) {
        return of(parameters, Map.of());
    }

    public double number(String name) {
        return (Double) value(name);
    }

    public int integer(String name) {
        return Math.toIntExact((Long) value(name));
    }

    public String text(String name) {
        return (String) value(name);
    }

    /// Places in the map [m].
    public List<Point2d> places(String name) {
        return Places.read(text(name)).orElseThrow(); // its parameter has accepted it
    }

    public PluginChoice plugin(String name) {
        return (PluginChoice) value(name);
    }

    /// All plugins among the values.
    public List<PluginChoice> plugins() {
        return values.values().stream()
                .flatMap(value -> value instanceof List<?> several ? several.stream() : Stream.of(value))
                .filter(PluginChoice.class::isInstance)
                .map(PluginChoice.class::cast)
                .toList();
    }

    /// Plugins in their order.
    public List<PluginChoice> plugins(String name) {
        return ((List<?>) value(name)).stream().map(PluginChoice.class::cast).toList();
    }

    public boolean flag(String name) {
        return (Boolean) value(name);
    }

    /// A number of seconds.
    public Duration seconds(String name) {
        return Duration.ofNanos(Math.round(number(name) * 1e9));
    }

    /// A number of degrees, in radians.
    public double radians(String name) {
        return Math.toRadians(number(name));
    }

    /// All values by name, in the order of their parameters: Double, Long, String, Boolean,
    /// [PluginChoice] or a list of these.
    public Map<String, Object> asMap() {
        return values;
    }

    /// The same as they are written: a plugin as its key, or as a map with that as its `type` when something of
    /// it is set.
    public Map<String, Object> written() {
        var all = new LinkedHashMap<String, Object>();
        values.forEach((name, value) -> all.put(name, written(value)));
        return all;
    }

    private static Object written(Object value) {
        return switch (value) {
            case PluginChoice chosen -> chosen.written();
            case List<?> several -> several.stream().map(Arguments::written).toList();
            default -> value;
        };
    }

    private Object value(String name) {
        Object value = values.get(name);
        if (value == null) {
            throw new IllegalStateException(
                    "(%s) was never declared as a parameter; declared are %s.".formatted(name, values.keySet()));
        }
        return value;
    }

    @Override
    public boolean equals(Object other) {
        return other instanceof Arguments arguments && values.equals(arguments.values);
    }

    @Override
    public int hashCode() {
        return values.hashCode();
    }

    @Override
    public String toString() {
        return values.toString();
    }
}
