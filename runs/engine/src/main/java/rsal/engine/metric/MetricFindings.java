package rsal.engine.metric;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import rsal.engine.metric.MetricsObserver.Finding;
import rsal.scenario.RunPlan.MetricDefinition;
import rsal.scenario.condition.Facts;
import rsal.scenario.condition.MetricExpression;
import rsal.scenario.condition.MetricExpression.Aggregate;
import rsal.scenario.condition.Quantity;

/// Computes the values of a scenario's metrics of what was noted during a run. Lives for one computation.
///
/// @param facts the present value of each quantity
/// @param records of robots, by id
/// @param quantities samples of those that are taken after each step
/// @param ofRun samples of signals that belong to no robot, by word
/// @param published what agents have published
/// @param firstTimes when conditions were first true [s]; those that were not are absent
/// @param time of the run [s]
record MetricFindings(
        Facts facts,
        Map<String, RobotRecord> records,
        Map<Quantity, Samples> quantities,
        Map<String, Samples> ofRun,
        Published published,
        Map<MetricDefinition, OptionalDouble> firstTimes,
        double time) {
    /// In the order of the metrics; one for each robot where that is asked for.
    List<Finding> of(List<MetricDefinition> metrics) {
        var findings = new ArrayList<Finding>();
        for (MetricDefinition measured : metrics) {
            if (measured.perRobot()) {
                records.forEach((id, own) -> {
                    if (own.hasRole(measured.from().role())) {
                        findings.add(finding(measured, measured.nameOf(id), List.of(own), Optional.of(id)));
                    }
                });
            } else {
                List<RobotRecord> all = records.values().stream()
                        .filter(own -> own.hasRole(measured.from().role()))
                        .toList();
                findings.add(finding(measured, measured.name(), all, Optional.empty()));
            }
        }
        return findings;
    }

    /// @param robot whose it is; empty for all
    private Finding finding(MetricDefinition measured, String name, List<RobotRecord> from, Optional<String> robot) {
        OptionalDouble value = switch (measured.from()) {
            case MetricExpression.FirstTime _ -> firstTimes.getOrDefault(measured, OptionalDouble.empty());
            case MetricExpression.Count(var quantity) -> known(facts.value(quantity));
            case MetricExpression.Distance _ ->
                from.stream().anyMatch(RobotRecord::seen)
                        ? OptionalDouble.of(
                                from.stream().mapToDouble(RobotRecord::distance).sum())
                        : OptionalDouble.empty();
            case MetricExpression.OfSignal(var aggregate, var signal, var _) ->
                signal.isOfRobots()
                        ? value(
                                aggregate,
                                from.stream().map(own -> own.samples(signal)).toList())
                        : ofRun.getOrDefault(signal.word(), new Samples()).value(aggregate, time);
            case MetricExpression.OfQuantity of ->
                of.isPublished()
                        ? value(
                                of.aggregate(),
                                published.samples(of.quantity().names().getFirst(), robot))
                        : quantities.getOrDefault(of.quantity(), new Samples()).value(of.aggregate(), time);
        };
        boolean inBounds =
                value.isEmpty() || (value.getAsDouble() >= measured.min() && value.getAsDouble() <= measured.max());
        return new Finding(name, value, inBounds);
    }

    private OptionalDouble value(Aggregate aggregate, List<Samples> several) {
        return Samples.together(several, time).value(aggregate, time);
    }

    private static OptionalDouble known(double value) {
        return Double.isNaN(value) ? OptionalDouble.empty() : OptionalDouble.of(value);
    }
}
