package rsal.scenario;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import rsal.settings.Location;
import rsal.settings.Parameter;
import rsal.settings.Problems;
import rsal.settings.Section;
import rsal.settings.Suggestion;
import rsal.settings.Value;

/// Reads which arguments a scenario has, finds their values, and puts these in where `$name` stands.
final class ArgumentReader {
    private static final Pattern REFERENCE = Pattern.compile("\\$([A-Za-z][A-Za-z0-9_-]*)");

    private ArgumentReader() {}

    static List<Parameter<?>> declared(Section arguments) {
        var declared = new ArrayList<Parameter<?>>();
        for (String name : arguments.names()) {
            if (!Format.NAME.matcher(name).matches()) {
                arguments.problem(
                        arguments.mapping().keys().getOrDefault(name, arguments.location()),
                        "'%s' can't be the name of an argument.".formatted(name),
                        "Use letters and digits, at most 40.");
            }
            declared.add(declared(name, arguments.section(name)));
        }
        arguments.done();
        return declared;
    }

    private static Parameter<?> declared(String name, Section section) {
        Parameter.Kind kind =
                switch (String.valueOf(section.value(Format.ARGUMENT_TYPE).orElse(""))) {
                    case "integer" -> Parameter.Kind.INTEGER;
                    case "string" -> Parameter.Kind.TEXT;
                    case "boolean" -> Parameter.Kind.FLAG;
                    default -> Parameter.Kind.NUMBER;
                };
        boolean bounded = kind == Parameter.Kind.NUMBER || kind == Parameter.Kind.INTEGER;
        var parameter = new Parameter<>(
                name,
                kind,
                Optional.empty(),
                bounded ? section.number("min", Double.NEGATIVE_INFINITY) : Double.NEGATIVE_INFINITY,
                bounded ? section.number("max", Double.POSITIVE_INFINITY) : Double.POSITIVE_INFINITY,
                kind == Parameter.Kind.TEXT ? options(section) : List.of(),
                section.text("unit", ""),
                section.text("description", ""));
        Optional<Object> fallback = fallback(section, parameter);
        section.done();
        return new Parameter<>(
                name,
                kind,
                fallback,
                parameter.min(),
                parameter.max(),
                parameter.options(),
                parameter.unit(),
                parameter.description());
    }

    private static Optional<Object> fallback(Section section, Parameter<?> parameter) {
        Optional<Value> given = section.find("default");
        if (given.isEmpty()) {
            section.problem(
                    section.location(),
                    "'%s' is missing: the value when none is given.".formatted(section.path("default")),
                    "");
            return Optional.empty();
        }
        return accepted(parameter, given.get(), section.problems());
    }

    private static List<String> options(Section section) {
        var options = new ArrayList<String>();
        for (Value item : section.list("enum").orElse(List.of())) {
            if (item instanceof Value.Scalar scalar && scalar.value() instanceof String text) {
                options.add(text);
            } else {
                section.expected("enum", "a list of texts", item);
            }
        }
        return options;
    }

    /// A value that stands in the file.
    private static Optional<Object> accepted(Parameter<?> parameter, Value value, Problems problems) {
        try {
            return Optional.of(
                    parameter.accept(value instanceof Value.Scalar scalar ? scalar.value() : value.describe()));
        } catch (IllegalArgumentException e) {
            problems.add(value.location(), String.valueOf(e.getMessage()), "");
            return Optional.empty();
        }
    }

    /// The values of a configuration's `args`.
    static Map<String, Object> overridden(List<Parameter<?>> declared, Section args) {
        var values = new LinkedHashMap<String, Object>();
        for (Parameter<?> parameter : declared) {
            args.find(parameter.name())
                    .flatMap(value -> accepted(parameter, value, args.problems()))
                    .ifPresent(value -> values.put(parameter.name(), value));
        }
        args.done();
        return values;
    }

    /// Values as typed.
    static Map<String, Object> typed(List<Parameter<?>> declared, RunOptions options, Problems problems) {
        var values = new LinkedHashMap<String, Object>();
        options.arguments().forEach((name, text) -> {
            Location at = options.locationOf(name);
            var names = declared.stream().map(Parameter::name).toList();
            var parameter = declared.stream().filter(p -> p.name().equals(name)).findFirst();
            if (parameter.isEmpty()) {
                problems.add(at, "The scenario has no argument '%s'.".formatted(name), Suggestion.among(name, names));
                return;
            }
            try {
                values.put(name, parameter.get().parse(text));
            } catch (IllegalArgumentException e) {
                problems.add(at, String.valueOf(e.getMessage()), "");
            }
        });
        return values;
    }

    /// The same settings with each `$name` replaced by the argument's value. Where that has none, because the name
    /// is unknown or the argument itself is wrong, this is all that the author hears about the place.
    static Value.Mapping replace(
            Value.Mapping settings, List<Parameter<?>> declared, Map<String, Object> values, Problems problems) {
        List<String> names = declared.stream().map(Parameter::name).toList();
        return (Value.Mapping) settings.map(scalar -> {
            if (!(scalar.value() instanceof String text) || text.indexOf('$') < 0) {
                return scalar;
            }
            Matcher reference = REFERENCE.matcher(text);
            if (reference.matches()) {
                Object value = values.get(reference.group(1));
                if (value != null) {
                    return new Value.Scalar(scalar.location(), value);
                }
                if (!names.contains(reference.group(1))) {
                    problems.add(
                            scalar.location(),
                            "There is no argument '%s'.".formatted(reference.group(1)),
                            Suggestion.among(reference.group(1), names));
                }
                problems.settle(scalar.location());
            } else if (reference.reset().results().anyMatch(found -> names.contains(found.group(1)))) {
                problems.add(
                        scalar.location(),
                        "An argument stands for a whole value, never inside other text '%s'.".formatted(text),
                        "");
            }
            return scalar;
        });
    }
}
