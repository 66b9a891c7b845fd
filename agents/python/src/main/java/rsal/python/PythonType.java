package rsal.python;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.jspecify.annotations.Nullable;
import rsal.agent.Agent;
import rsal.agent.AgentType;
import rsal.device.Device;
import rsal.settings.Arguments;
import rsal.settings.InvalidSettings;
import rsal.settings.Location;
import rsal.settings.Parameter;
import rsal.settings.Problem;
import rsal.settings.Problems;
import rsal.settings.Suggestion;

/// A kind of agent that somebody wrote in Python.
///
/// @param key as the scenario names it
/// @param className of the agent in its file
record PythonType(
        String key,
        String description,
        List<Parameter<?>> parameters,
        List<Class<? extends Device>> needs,
        String className,
        PythonSources sources,
        List<Problem> warnings)
        implements AgentType {

    PythonType {
        parameters = List.copyOf(parameters);
        needs = List.copyOf(needs);
        warnings = List.copyOf(warnings);
    }

    /// @param found what its file says
    /// @throws InvalidSettings when it needs devices that there are not
    static PythonType of(String key, PythonSources sources, Map<?, ?> found) {
        var problems = new Problems();
        var needs = new ArrayList<Class<? extends Device>>();
        for (Object each : FromWords.list(found.get("needs"))) {
            List<?> named = (List<?>) each;
            String name = String.valueOf(named.getFirst());
            Class<? extends Device> contract = DeviceCalls.all().get(name);
            if (contract == null) {
                problems.add(
                        location(found, sources, named.get(1), named.get(2)),
                        "There is no device '%s'.".formatted(name),
                        Suggestion.among(name, List.copyOf(DeviceCalls.all().keySet())));
            } else {
                needs.add(contract);
            }
        }
        problems.throwIfAny();
        List<Parameter<?>> parameters = new ArrayList<>();
        for (Object each : FromWords.list(found.get("parameters"))) {
            parameters.add(parameter((Map<?, ?>) each));
        }
        return new PythonType(
                key,
                String.valueOf(found.get("description")),
                parameters,
                needs,
                String.valueOf(found.get("class")),
                sources,
                FromWords.list(found.get("warnings")).stream()
                        .map(each -> (Map<?, ?>) each)
                        .map(each -> new Problem(
                                location(found, sources, each.get("line"), each.get("column")),
                                text(each, "message"),
                                text(each, "remedy")))
                        .toList());
    }

    private static Location location(
            Map<?, ?> found, PythonSources sources, @Nullable Object line, @Nullable Object column) {
        String file = found.get("file") instanceof String path ? path : sources.path();
        return new Location(file, FromWords.integer(line), FromWords.integer(column));
    }

    private static Parameter<?> parameter(Map<?, ?> found) {
        String name = String.valueOf(found.get("name"));
        String about = text(found, "description");
        Object fallback = found.get("default");
        Parameter<?> parameter = switch (String.valueOf(found.get("kind"))) {
            case "NUMBER" ->
                Parameter.number(
                        name,
                        fallback == null ? 0 : FromWords.number(fallback),
                        bound(found, "min", Double.NEGATIVE_INFINITY),
                        bound(found, "max", Double.POSITIVE_INFINITY),
                        text(found, "unit"),
                        about);
            case "INTEGER" ->
                new Parameter<Integer>(
                        name,
                        Parameter.Kind.INTEGER,
                        Optional.of(fallback == null ? 0L : (long) FromWords.number(fallback)),
                        bound(found, "min", Double.NEGATIVE_INFINITY),
                        bound(found, "max", Double.POSITIVE_INFINITY),
                        List.of(),
                        text(found, "unit"),
                        about);
            case "FLAG" -> Parameter.flag(name, Boolean.TRUE.equals(fallback), about);
            default -> words(found, name, fallback == null ? "" : fallback.toString(), about);
        };
        return fallback == null ? parameter.required() : parameter;
    }

    private static Parameter<String> words(Map<?, ?> found, String name, String fallback, String about) {
        List<String> choices = FromWords.list(found.get("choices")).stream()
                .map(String::valueOf)
                .toList();
        if (Boolean.TRUE.equals(found.get("robots"))) {
            return Parameter.robots(name, fallback, choices, about);
        }
        return choices.isEmpty()
                ? Parameter.text(name, fallback, about)
                : Parameter.choice(name, fallback, choices, about);
    }

    private static double bound(Map<?, ?> found, String name, double none) {
        Object bound = found.get(name);
        return bound == null ? none : FromWords.number(bound);
    }

    private static String text(Map<?, ?> found, String name) {
        Object text = found.get(name);
        return text == null ? "" : text.toString();
    }

    @Override
    public Agent create(Arguments arguments) {
        return new PythonAgent(this, arguments.written());
    }
}
