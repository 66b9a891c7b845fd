package rsal.scenario;

import rsal.metric.MetricType;
import rsal.settings.Arguments;

/// A metric of a run.
public record PlannedMetric(MetricType type, Arguments arguments) {}
