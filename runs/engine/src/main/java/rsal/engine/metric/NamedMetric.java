package rsal.engine.metric;

import java.util.List;
import rsal.engine.report.RunBroken;
import rsal.metric.Metric;
import rsal.metric.RunState;
import rsal.scenario.PlannedMetric;

/// A metric that is blamed by its name for what it throws.
record NamedMetric(String name, Metric metric) {
    static NamedMetric of(PlannedMetric planned, RunState run) {
        String name = "Metric '%s'".formatted(planned.type().key());
        return new NamedMetric(
                name, RunBroken.blaming(name, () -> planned.type().create(planned.arguments(), run)));
    }

    void onMessage(String sender, Object content) {
        RunBroken.blaming(name, () -> metric.onMessage(sender, content));
    }

    void onStep() {
        RunBroken.blaming(name, metric::onStep);
    }

    double value(String quantity, List<String> names) {
        return RunBroken.blaming(name, () -> metric.value(quantity, names));
    }

    boolean holdsForAll(String quantity, String which, int all) {
        return RunBroken.blaming(name, () -> metric.holdsForAll(quantity, which, all));
    }
}
