package rsal.cli.sweep;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import rsal.cli.terminal.TextTable;
import rsal.experiment.Combination;
import rsal.experiment.Findings;
import rsal.experiment.Manifest.MetricEntry;
import rsal.experiment.MetricSamples;
import rsal.experiment.Row;
import rsal.experiment.SweepFolder;
import rsal.experiment.report.Conclusions;
import rsal.experiment.report.NumberFormats;
import rsal.experiment.statistics.ConfidenceInterval;
import rsal.experiment.statistics.Mean;
import rsal.experiment.statistics.Share;

/// The result of a sweep, in short: for each combination how its runs ended, and the means of what was
/// measured.
record SweepSummary(Findings findings, Path folder) {
    private static final int MOST_FEW = 4; // runs; the quantile of Student's t is 3.2 then, 12.7 of two

    static SweepSummary of(Findings findings, Path folder) {
        return new SweepSummary(findings, folder);
    }

    /// For programs. Part of what users build on: names and order stay.
    record Json(
            String scenario, int runs, int ended, long broken, String folder, String rows, List<Each> combinations) {}

    /// @param arguments that are varied, as typed
    /// @param outcomes how many runs ended so
    /// @param metrics that had something to measure
    record Each(
            String configuration,
            Map<String, String> arguments,
            int runs,
            Map<String, Long> outcomes,
            Map<String, Estimate> metrics) {}

    /// @param count runs that count
    /// @param measured runs in which there was something to measure; fewer where the others count to the horizon
    /// @param horizon up to when times of events count; empty of other metrics
    /// @param low end of the 95 % confidence interval of the mean; empty for one value
    record Estimate(
            int count,
            int measured,
            Optional<Double> horizon,
            double mean,
            Optional<Double> low,
            Optional<Double> high) {
        static Estimate of(MetricSamples measurements, Combination combination, Mean mean) {
            return new Estimate(
                    mean.count(),
                    measurements.reached(combination),
                    measurements.horizon().isPresent()
                            ? Optional.of(measurements.horizon().getAsDouble())
                            : Optional.empty(),
                    mean.value(),
                    mean.interval().map(ConfidenceInterval::low),
                    mean.interval().map(ConfidenceInterval::high));
        }
    }

    Json json() {
        return new Json(
                findings.manifest().subject().scenario(),
                findings.design().trials().size(),
                findings.rows().size(),
                findings.rows().stream().filter(Row::isBroken).count(),
                folder.toString(),
                folder.resolve(SweepFolder.TABLE).toString(),
                findings.design().combinations().stream().map(this::each).toList());
    }

    private Each each(Combination combination) {
        List<Row> rows = findings.of(combination);
        var outcomes = new LinkedHashMap<String, Long>();
        rows.forEach(row -> outcomes.merge(row.outcome(), 1L, Long::sum));
        var metrics = new LinkedHashMap<String, Estimate>();
        for (MetricSamples measured : measurements()) {
            measured.mean(combination)
                    .ifPresent(mean -> metrics.put(measured.metric().name(), Estimate.of(measured, combination, mean)));
        }
        return new Each(combination.configuration(), combination.levels(), rows.size(), outcomes, metrics);
    }

    /// For people.
    String text() {
        List<MetricSamples> metrics = measurements();
        var table = new TextTable("");
        var head = new ArrayList<>(List.of("combination", "runs", "success"));
        metrics.forEach(measured -> head.add(head(measured.metric())));
        table.row(head.toArray(String[]::new));
        for (Combination combination : findings.design().combinations()) {
            List<Row> rows = findings.of(combination);
            var cells = new ArrayList<>(List.of(findings.label(combination), Integer.toString(rows.size())));
            cells.add(rows.isEmpty() ? "–" : successes(rows));
            metrics.forEach(measured -> cells.add(cell(measured, combination)));
            table.row(cells.toArray(String[]::new));
        }
        return table
                + failures()
                + conclusions()
                + aboutFewRuns(fewestRuns())
                + "Means ± half of their 95 %% confidence intervals. Rows: %s; a page of them: rsal report %s%n"
                        .formatted(folder.resolve(SweepFolder.TABLE), folder);
    }

    private int fewestRuns() {
        return findings.design().combinations().stream()
                .mapToInt(combination -> findings.of(combination).size())
                .min()
                .orElse(0);
    }

    /// Why intervals may be wider than what they are about.
    ///
    /// @param runs of the combination that has the fewest
    static String aboutFewRuns(int runs) {
        return runs < 2 || runs > MOST_FEW
                ? ""
                : "The intervals are wide because they are of only %d runs (Student's t distribution). Add seeds: --repeat 10.%n"
                        .formatted(runs);
    }

    private List<MetricSamples> measurements() {
        return findings.manifest().metrics().stream()
                .map(findings::measurements)
                .toList();
    }

    private static String head(MetricEntry metric) {
        return metric.unit().isEmpty() ? metric.name() : "%s [%s]".formatted(metric.name(), metric.unit());
    }

    /// `80 ± 22`, and in how many runs there was something to measure where that is not in all.
    private static String cell(MetricSamples measurements, Combination combination) {
        String mean = measurements.mean(combination).map(SweepSummary::words).orElse("–");
        int reached = measurements.reached(combination);
        int runs = measurements.runs(combination);
        return reached == runs ? mean : "%s (%d of %d)".formatted(mean, reached, runs);
    }

    /// What is to be known of runs without a value, and which differences are clear.
    private String conclusions() {
        var conclusions = Conclusions.of(findings);
        var text = new StringBuilder();
        conclusions
                .missing(findings.design().combinations())
                .forEach(each -> text.append(each).append(System.lineSeparator()));
        if (conclusions.known() > 0) {
            List<Conclusions.Sentence> clear = conclusions.clear();
            text.append(
                    clear.isEmpty()
                            ? "No difference is clear (%d compared).%n".formatted(conclusions.known())
                            : "Clear differences (%d of %d compared):%n".formatted(clear.size(), conclusions.known()));
            clear.forEach(each -> text.append("  ").append(each).append(System.lineSeparator()));
        }
        return text.toString();
    }

    /// In how many runs agents failed, and what the first of them was; empty when none did.
    private String failures() {
        List<Row> rows = findings.rows().stream().filter(Row::hasFailedAgents).toList();
        if (rows.isEmpty()) {
            return "";
        }
        Row first = rows.getFirst();
        var agent = first.failedAgents().entrySet().iterator().next();
        return "Agents failed in %d of %d runs; in run %d %s: %s%n"
                .formatted(rows.size(), findings.rows().size(), first.run(), agent.getKey(), agent.getValue());
    }

    private static String successes(List<Row> rows) {
        long count =
                rows.stream().filter(row -> row.outcome().equals("success")).count();
        return "%.0f %%".formatted(100 * new Share((int) count, rows.size()).value());
    }

    private static String words(Mean mean) {
        return mean.interval()
                .map(interval -> NumberFormats.withError(mean.value(), interval.high() - mean.value()))
                .orElseGet(() -> NumberFormats.of(mean.value()));
    }
}
