package rsal.settings;

import java.time.Duration;
import java.util.ArrayList;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.Stream;

/// Values for a list of parameters, checked, with fallbacks filled in. Asking for what was not declared is a
/// error of the code.
public final class Arguments {
    private final Map<String, Object> values;

    private Arguments(Map<String, Object> values) {
        this.values = Collections.unmodifiableMap(values);
    }

    /// @throws IllegalArgumentException with a sentence when a value is unknown, wrong or missing
    public static Arguments of(List<Parameter<?>> parameters, Map<String, ?> given) {
        var values = new LinkedHashMap<String, Object>();
        for (String name : given.keySet()) {
            if (parameters.stream().noneMatch(p -> p.name().equals(name))) {
                throw new IllegalArgumentException("'%s' is not known here. %s"
                        .formatted(
                                name,
                                Suggestion.among(
                                        name,
                                        parameters.stream().map(Parameter::name).toList())));
            }
        }
        for (Parameter<?> parameter : parameters) {
            Object value = given.get(parameter.name());
            if (value != null) {
                values.put(parameter.name(), parameter.accept(value));
            } else {
                values.put(
                        parameter.name(),
                        parameter
                                .fallback()
                                .orElseThrow(() -> new IllegalArgumentException("'%s' is missing: %s, %s."
                                        .formatted(parameter.name(), parameter.description(), parameter.expected()))));
            }
        }
        return new Arguments(values);
    }

    /// The same of values that are texts as typed on a command line or in a form.
    ///
    /// @param typed by name; what is not a text counts as it is
    /// @throws IllegalArgumentException with sentences about all values that are wrong
    public static Arguments parse(List<Parameter<?>> parameters, Map<String, ?> typed) {
        var values = new LinkedHashMap<String, Object>(typed);
        var errors = new ArrayList<String>();
        for (Parameter<?> parameter : parameters) {
            try {
                values.computeIfPresent(
                        parameter.name(), (_, value) -> value instanceof String text ? parameter.parse(text) : value);
            } catch (IllegalArgumentException e) {
                errors.add(e.getMessage());
            }
        }
        if (!errors.isEmpty()) {
            throw new IllegalArgumentException(String.join(" ", errors));
        }
        return of(parameters, values);
    }

    public static Arguments defaults(List<Parameter<?>> parameters) {
        return of(parameters, Map.of());
    }

    /// The value of a parameter.
    ///
    /// @throws IllegalStateException when the parameter is none of these arguments'
    public <T> T get(Parameter<T> parameter) {
        return parameter.read(value(parameter.name()));
    }

    /// A number of seconds, of a parameter in s.
    public Duration seconds(Parameter<Double> parameter) {
        return Duration.ofNanos(Math.round(get(parameter) * 1e9));
    }

    /// A number of degrees, of a parameter in deg, as radians.
    public double radians(Parameter<Double> parameter) {
        return Math.toRadians(get(parameter));
    }

    /// All plugins among the values.
    public List<PluginChoice> plugins() {
        return values.values().stream()
                .flatMap(value -> value instanceof List<?> several ? several.stream() : Stream.of(value))
                .filter(PluginChoice.class::isInstance)
                .map(PluginChoice.class::cast)
                .toList();
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
                    "'%s' was never declared as a parameter; declared are %s.".formatted(name, values.keySet()));
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
