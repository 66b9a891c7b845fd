package rsal.metric;

import java.util.List;
import rsal.settings.Arguments;
import rsal.settings.Plugin;

/// A kind of metric. Those of an installation are found by [java.util.ServiceLoader], and are part of every run
/// when each of their parameters has a default. Others are files that a scenario names:
/// `metricTypes: [{type: Spacing.java}]`.
public interface MetricType extends Plugin {
    /// What conditions can compare. Their words are unique in a run.
    default List<QuantityType> quantities() {
        return List.of();
    }

    /// What metrics can take means and percentiles of. Their words are unique in a run, also among quantities.
    default List<SignalType> signals() {
        return List.of();
    }

    /// One for each run.
    ///
    /// @param arguments for [#parameters]
    /// @param run what it may look at, on the run's thread
    Metric create(Arguments arguments, RunState run);
}
