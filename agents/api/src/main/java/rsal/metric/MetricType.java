package rsal.metric;

import java.util.List;
import rsal.settings.Arguments;
import rsal.settings.Parameter;

/// A kind of metric. Those of an installation are found by [java.util.ServiceLoader] and are part of every run; others
/// are files that a scenario names (`metrics: [{type: Spacing.java}]`).
public interface MetricType {
    /// What scenarios call it, as `capture`; unique in an installation.
    String key();

    /// A sentence about what it measures.
    String description();

    /// What can be set. A metric that is installed is part of every run when each of these has a default.
    default List<Parameter> parameters() {
        return List.of();
    }

    /// What conditions can compare. Their words are unique in a run.
    default List<QuantityType> quantities() {
        return List.of();
    }

    /// What measures can take means and percentiles of. Their words are unique in a run, also among quantities.
    default List<SignalType> signals() {
        return List.of();
    }

    /// One for each run.
    ///
    /// @param arguments for [#parameters]
    /// @param run what it may look at, on the run's thread
    Metric create(Arguments arguments, RunState run);
}
