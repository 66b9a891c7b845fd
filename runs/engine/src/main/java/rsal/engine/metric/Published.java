package rsal.engine.metric;

import java.util.Collection;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/// Values that agents publish under a name, as far as somebody asks.
final class Published {
    private final Map<String, Map<String, Series>> metrics = new HashMap<>(); // by name, then by agent
    private final Map<String, Double> newest = new HashMap<>(); // by name

    private record Series(Optional<String> robot, Samples samples) {}

    /// @param names of those that are asked for; no others are kept
    Published(Collection<String> names) {
        names.forEach(name -> metrics.put(name, new LinkedHashMap<>()));
    }

    /// @param robot of the agent
    /// @param now since the run's start [s]
    void add(String agent, Optional<String> robot, String name, double value, double now) {
        Map<String, Series> known = metrics.get(name);
        if (known != null) {
            known.computeIfAbsent(agent, _ -> new Series(robot, new Samples()))
                    .samples
                    .add(now, value);
            newest.put(name, value);
        }
    }

    /// As an agent published it last; NaN before the first.
    double newest(String name) {
        return newest.getOrDefault(name, Double.NaN);
    }

    /// Of each agent, or of those of one robot.
    List<Samples> samples(String name, Optional<String> robot) {
        return metrics.getOrDefault(name, Map.of()).values().stream()
                .filter(series -> robot.isEmpty() || series.robot.equals(robot))
                .map(Series::samples)
                .toList();
    }
}
