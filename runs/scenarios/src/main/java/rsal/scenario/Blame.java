package rsal.scenario;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.function.Function;
import java.util.stream.Collectors;
import rsal.settings.Location;
import rsal.settings.Problem;

/// Finds out which errors of a scenario come of arguments that somebody has set: those that are none without. Where
/// they show may be far from where the argument stands.
final class Blame {
    private final RunOptions options;
    private final Map<String, Set<Location>> without = new LinkedHashMap<>(); // an argument, by its name: what is left

    /// @param errors of the scenario with some options
    Blame(RunOptions options, Function<RunOptions, List<Problem>> errors) {
        this.options = options;
        options.arguments().keySet().forEach(name -> without.put(name, places(errors, name)));
    }

    private Set<Location> places(Function<RunOptions, List<Problem>> errors, String name) {
        return errors.apply(options.withoutArgument(name)).stream()
                .map(Problem::location)
                .collect(Collectors.toUnmodifiableSet());
    }

    /// The same errors, with the arguments that they come of.
    List<Problem> of(List<Problem> problems) {
        return problems.stream().map(this::of).toList();
    }

    private Problem of(Problem problem) {
        List<Location> set = without.keySet().stream().map(options::locationOf).toList();
        String blamed = without.entrySet().stream()
                .filter(entry -> !entry.getValue().contains(problem.location()))
                .map(entry -> options.locationOf(entry.getKey()).toString())
                .collect(Collectors.joining(", "));
        if (blamed.isEmpty() || set.contains(problem.location())) {
            return problem;
        }
        String words = "It is caused by %s.".formatted(blamed);
        String remedy = problem.remedy().isEmpty() ? words : problem.remedy() + " " + words;
        return new Problem(problem.location(), problem.message(), remedy);
    }
}
