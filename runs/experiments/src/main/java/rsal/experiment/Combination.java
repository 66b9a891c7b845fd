package rsal.experiment;

import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.stream.Collectors;

/// A configuration with a level of each factor.
///
/// @param number from 1, in the order of the design
/// @param levels by argument, as typed
public record Combination(int number, String configuration, Map<String, String> levels) {
    public Combination {
        levels = Collections.unmodifiableMap(new LinkedHashMap<>(levels));
    }

    /// `advanced, hunters=2`
    @Override
    public String toString() {
        return levels.isEmpty() ? configuration : configuration + ", " + levelsOnly();
    }

    /// `hunters=2`; the configuration where nothing is varied.
    public String levelsOnly() {
        return levels.isEmpty()
                ? configuration
                : levels.entrySet().stream()
                        .map(level -> level.getKey() + "=" + level.getValue())
                        .collect(Collectors.joining(", "));
    }

    /// Its level of one of [Design#compared].
    public String level(String factor) {
        return factor.equals(Design.CONFIGURATION) && !levels.containsKey(factor)
                ? configuration
                : levels.getOrDefault(factor, "");
    }
}
