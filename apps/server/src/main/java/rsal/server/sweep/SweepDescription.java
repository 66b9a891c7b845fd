package rsal.server.sweep;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Optional;
import rsal.experiment.Combination;
import rsal.experiment.Findings;
import rsal.experiment.MetricSamples;
import rsal.experiment.Row;
import rsal.experiment.statistics.BoxPlot;
import rsal.experiment.statistics.ConfidenceInterval;
import rsal.experiment.statistics.Mean;
import rsal.experiment.statistics.Share;
import rsal.server.message.Messages.Box;
import rsal.server.message.Messages.OutcomeShare;
import rsal.server.message.Messages.SweepCombination;
import rsal.server.message.Messages.SweepEstimate;
import rsal.server.message.Messages.SweepMetric;
import rsal.server.message.Messages.SweepRunInfo;

/// The result of a sweep so far, as the page shows it. The numbers are those of `rsal report`.
record SweepDescription(int broken, List<SweepMetric> metrics, List<SweepCombination> combinations) {
    static SweepDescription of(Findings findings) {
        List<MetricSamples> metrics = findings.manifest().metrics().stream()
                .map(findings::measurements)
                .toList();
        List<String> outcomes =
                findings.rows().stream().map(Row::outcome).distinct().sorted().toList();
        return new SweepDescription(
                (int) findings.rows().stream().filter(Row::isBroken).count(),
                metrics.stream().map(SweepDescription::metric).toList(),
                findings.design().combinations().stream()
                        .map(combination -> combination(findings, combination, outcomes, metrics))
                        .toList());
    }

    private static SweepMetric metric(MetricSamples measurements) {
        return new SweepMetric(
                measurements.metric().name(),
                measurements.metric().unit(),
                measurements.horizon().isPresent()
                        ? Optional.of(measurements.horizon().getAsDouble())
                        : Optional.empty());
    }

    private static SweepCombination combination(
            Findings findings, Combination combination, List<String> outcomes, List<MetricSamples> metrics) {
        List<Row> rows = findings.of(combination);
        var estimates = new LinkedHashMap<String, SweepEstimate>();
        for (MetricSamples measurements : metrics) {
            measurements
                    .mean(combination)
                    .ifPresent(mean -> estimates.put(
                            measurements.metric().name(),
                            estimate(
                                    mean,
                                    measurements.reached(combination),
                                    BoxPlot.of(measurements.of(combination)))));
        }
        return new SweepCombination(
                findings.label(combination),
                rows.size(),
                outcomes.stream().map(outcome -> share(outcome, rows)).toList(),
                estimates);
    }

    static SweepRunInfo run(Row row) {
        return new SweepRunInfo(
                row.run(),
                Long.toString(row.seed()),
                row.outcome(),
                row.reason(),
                row.simulatedSeconds().isPresent()
                        ? Optional.of(row.simulatedSeconds().getAsDouble())
                        : Optional.empty());
    }

    private static OutcomeShare share(String outcome, List<Row> rows) {
        int count =
                (int) rows.stream().filter(row -> row.outcome().equals(outcome)).count();
        Optional<ConfidenceInterval> interval =
                rows.isEmpty() ? Optional.empty() : Optional.of(new Share(count, rows.size()).interval());
        return new OutcomeShare(
                outcome, count, interval.map(ConfidenceInterval::low), interval.map(ConfidenceInterval::high));
    }

    private static SweepEstimate estimate(Mean mean, int measured, BoxPlot plot) {
        return new SweepEstimate(
                mean.count(),
                measured,
                mean.value(),
                mean.interval().map(ConfidenceInterval::low),
                mean.interval().map(ConfidenceInterval::high),
                new Box(plot.low(), plot.first(), plot.median(), plot.third(), plot.high(), plot.outside()));
    }
}
