package rsal.scenario;

import rsal.metric.Metric;
import rsal.metric.MetricType;
import rsal.metric.RunState;
import rsal.settings.Arguments;

/// In place of a metric whose file is a program from who knows where, as from a recording. The program is neither
/// read nor run.
///
/// @param key path of the file
record UntrustedMetric(String key) implements MetricType {
    @Override
    public String description() {
        return "A program that came with a recording, which is not run.";
    }

    @Override
    public Metric create(Arguments arguments, RunState run) {
        throw new IllegalStateException(
                "Metric '%s' is a program that came with a recording, and such are not run.".formatted(key));
    }
}
