package rsal.cli;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.jspecify.annotations.Nullable;
import rsal.scenario.run.Hearing;
import rsal.scenario.run.RunResult;

/// A run's result for programs. Part of what users build on: names and order stay.
///
/// @param measures null where there was nothing to measure
/// @param communication empty where the scenario does not limit it
record ResultJson(
        String scenario,
        String configuration,
        long seed,
        String outcome,
        double simulatedSeconds,
        double wallSeconds,
        String eventHash,
        Map<String, @Nullable Double> measures,
        List<Hearing> communication) {
    static ResultJson of(RunResult result) {
        var measures = new LinkedHashMap<String, @Nullable Double>();
        result.measures().forEach((name, value) -> measures.put(name, value.isPresent() ? value.getAsDouble() : null));
        return new ResultJson(
                result.scenario(),
                result.configuration(),
                result.seed(),
                result.outcome(),
                result.simulatedSeconds(),
                result.wallSeconds(),
                result.eventHash(),
                measures,
                result.communication());
    }
}
