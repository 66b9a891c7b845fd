package rsal.experiment.report;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.function.Function;
import java.util.stream.Stream;
import rsal.experiment.Change;
import rsal.experiment.Combination;
import rsal.experiment.Findings;
import rsal.experiment.MetricSamples;
import rsal.experiment.Row;
import rsal.experiment.report.Conclusions.Ending;
import rsal.experiment.report.Conclusions.InPlaces;
import rsal.experiment.report.Conclusions.Quantity;
import rsal.experiment.statistics.BoxPlot;
import rsal.experiment.statistics.ConfidenceInterval;
import rsal.experiment.statistics.Effect;
import rsal.experiment.statistics.KaplanMeier;
import rsal.experiment.statistics.Mean;
import rsal.experiment.statistics.Share;

/// The tables of a report.
final class ReportTables {
    private static final String NONE = "–";
    private static final List<String> SURE = List.of("seeds", "mean difference", "95 %", "p", "p (Holm)", "d_z");
    private static final List<String> SURE_FIELDS =
            List.of("seeds", "ofSeeds", "difference", "low95", "high95", "p", "pHolm", "dz");

    private ReportTables() {}

    static DataTable outcomes(Findings findings, List<Combination> combinations) {
        List<String> outcomes = Figures.outcomes(findings);
        var header = new ArrayList<>(List.of("combination", "runs"));
        header.addAll(outcomes);
        var rows = new ArrayList<List<String>>();
        var exact = new ArrayList<List<String>>();
        for (Combination combination : combinations) {
            List<Row> ended = findings.of(combination);
            var cells = new ArrayList<>(List.of(findings.label(combination), Integer.toString(ended.size())));
            for (String outcome : outcomes) {
                var share = new Share(Figures.count(ended, outcome), ended.size());
                ConfidenceInterval interval = share.interval();
                cells.add("%s (%s to %s)"
                        .formatted(
                                NumberFormats.percent(share.value()),
                                NumberFormats.percent(interval.low()),
                                NumberFormats.percent(interval.high())));
                exact.add(List.of(
                        findings.label(combination),
                        outcome,
                        Integer.toString(share.count()),
                        Integer.toString(share.of()),
                        NumberFormats.exact(share.value()),
                        NumberFormats.exact(interval.low()),
                        NumberFormats.exact(interval.high())));
            }
            rows.add(cells);
        }
        return new DataTable(
                "outcomes",
                "Shares of outcomes, with 95 % confidence intervals (Wilson's)",
                1,
                header,
                rows,
                List.of("combination", "outcome", "count", "n", "share", "low95", "high95"),
                exact);
    }

    static DataTable effectsOnShares(List<Compared<Ending>> endings) {
        return comparisons(
                "outcomes-effects",
                "Differences in shares of outcomes, in percentage points, all else equal, by seed",
                List.of("outcome", "change"),
                List.of("outcome", "factor", "from", "to"),
                endings,
                ending -> List.of(ending.outcome(), ending.change().toString()),
                ending -> Stream.concat(Stream.of(ending.outcome()), fields(ending.change()))
                        .toList());
    }

    static DataTable effects(Quantity quantity) {
        return comparisons(
                quantity.metric().name() + "-effects",
                "Differences in %s, all else equal, by seed".formatted(Figures.title(quantity.metric())),
                List.of("change"),
                List.of("factor", "from", "to"),
                quantity.changes(),
                change -> List.of(change.toString()),
                change -> fields(change).toList());
    }

    static DataTable interactions(Quantity quantity) {
        var rows = new ArrayList<List<String>>();
        var exact = new ArrayList<List<String>>();
        for (InPlaces each : quantity.interactions()) {
            Change change = each.compared().subject().change();
            Change where = each.compared().subject().where();
            rows.add(Stream.concat(
                            Stream.of(
                                    change.toString(),
                                    where.toString(),
                                    difference(each.before()),
                                    difference(each.after())),
                            cells(each.compared()))
                    .toList());
            exact.add(Stream.of(
                            fields(change),
                            fields(where),
                            Stream.of(exactDifference(each.before()), exactDifference(each.after())),
                            fields(each.compared()))
                    .flatMap(fields -> fields)
                    .toList());
        }
        return new DataTable(
                quantity.metric().name() + "-interactions",
                "How much more a change does to %s where something else is changed, too, by seed"
                        .formatted(Figures.title(quantity.metric())),
                2,
                Stream.concat(Stream.of("change", "where", "before", "after"), SURE.stream())
                        .toList(),
                rows,
                Stream.concat(
                                Stream.of(
                                        "factor",
                                        "from",
                                        "to",
                                        "whereFactor",
                                        "whereFrom",
                                        "whereTo",
                                        "before",
                                        "after"),
                                SURE_FIELDS.stream())
                        .toList(),
                exact);
    }

    private static <T> DataTable comparisons(
            String name,
            String caption,
            List<String> header,
            List<String> fields,
            List<Compared<T>> compared,
            Function<T, List<String>> cells,
            Function<T, List<String>> exact) {
        return new DataTable(
                name,
                caption,
                header.size(),
                Stream.concat(header.stream(), SURE.stream()).toList(),
                compared.stream()
                        .map(each -> Stream.concat(cells.apply(each.subject()).stream(), cells(each))
                                .toList())
                        .toList(),
                Stream.concat(fields.stream(), SURE_FIELDS.stream()).toList(),
                compared.stream()
                        .map(each -> Stream.concat(exact.apply(each.subject()).stream(), fields(each))
                                .toList())
                        .toList());
    }

    private static Stream<String> cells(Compared<?> compared) {
        Effect effect = compared.effect();
        return Stream.of(
                "%d of %d".formatted(effect.complete(), effect.blocks()),
                difference(effect),
                effect.difference()
                        .flatMap(Mean::interval)
                        .map(NumberFormats::signed)
                        .orElse(NONE),
                probability(effect.pValue()),
                probability(compared.corrected()),
                effect.difference()
                        .map(Mean::standardized)
                        .filter(OptionalDouble::isPresent)
                        .map(size -> NumberFormats.signed(size.getAsDouble()))
                        .orElse(NONE));
    }

    private static String probability(OptionalDouble p) {
        return p.isPresent() ? NumberFormats.probability(p.getAsDouble()) : NONE;
    }

    private static String difference(Effect effect) {
        return effect.difference()
                .map(mean -> NumberFormats.signed(mean.value()))
                .orElse(NONE);
    }

    private static String exactDifference(Effect effect) {
        return effect.difference()
                .map(mean -> NumberFormats.exact(mean.value()))
                .orElse("");
    }

    private static Stream<String> fields(Change change) {
        return Stream.of(change.factor().argument(), change.from(), change.to());
    }

    private static Stream<String> fields(Compared<?> compared) {
        Effect effect = compared.effect();
        Optional<ConfidenceInterval> interval = effect.difference().flatMap(Mean::interval);
        return Stream.of(
                Integer.toString(effect.complete()),
                Integer.toString(effect.blocks()),
                exactDifference(effect),
                interval.map(ends -> NumberFormats.exact(ends.low())).orElse(""),
                interval.map(ends -> NumberFormats.exact(ends.high())).orElse(""),
                exact(effect.pValue()),
                exact(compared.corrected()),
                exact(effect.difference().map(Mean::standardized).orElseGet(OptionalDouble::empty)));
    }

    private static String exact(OptionalDouble value) {
        return value.isPresent() ? NumberFormats.exact(value.getAsDouble()) : "";
    }

    /// Of a metric that has a value in each run, or none.
    static DataTable values(Findings findings, MetricSamples measurements, List<Combination> combinations) {
        var rows = new ArrayList<List<String>>();
        var exact = new ArrayList<List<String>>();
        for (Combination combination : combinations) {
            double[] values = measurements.of(combination);
            var cells = begin(findings, combination, values.length + " of " + measurements.runs(combination));
            var fields = begin(
                    findings,
                    combination,
                    Integer.toString(measurements.runs(combination)),
                    Integer.toString(values.length));
            cells.addAll(mean(measurements.mean(combination)));
            fields.addAll(exactMean(measurements.mean(combination)));
            if (values.length == 0) {
                cells.addAll(List.of(NONE, NONE, NONE));
                fields.addAll(List.of("", "", ""));
            } else {
                BoxPlot box = BoxPlot.of(values);
                for (double value : new double[] {box.least(), box.median(), box.most()}) {
                    cells.add(NumberFormats.of(value));
                    fields.add(NumberFormats.exact(value));
                }
            }
            rows.add(cells);
            exact.add(fields);
        }
        return new DataTable(
                measurements.metric().name(),
                Figures.title(measurements.metric()) + " by combination",
                1,
                List.of("combination", "n", "mean", "95 % (Student's)", "deviation", "least", "median", "most"),
                rows,
                List.of("combination", "runs", "n", "mean", "low95", "high95", "deviation", "least", "median", "most"),
                exact);
    }

    /// Of a metric that tells when something happened.
    static DataTable times(Findings findings, MetricSamples measurements, List<Combination> combinations) {
        var rows = new ArrayList<List<String>>();
        var exact = new ArrayList<List<String>>();
        double horizon = measurements.horizon().orElse(0);
        for (Combination combination : combinations) {
            Optional<KaplanMeier> curve = measurements.curve(combination);
            OptionalDouble median = curve.map(KaplanMeier::median).orElseGet(OptionalDouble::empty);
            int used = measurements.used(combination);
            int reached = measurements.reached(combination);
            var cells = begin(
                    findings, combination, used + " of " + measurements.runs(combination), Integer.toString(reached));
            var fields = begin(
                    findings,
                    combination,
                    Integer.toString(measurements.runs(combination)),
                    Integer.toString(used),
                    Integer.toString(reached),
                    NumberFormats.exact(horizon));
            cells.addAll(mean(measurements.mean(combination)));
            fields.addAll(exactMean(measurements.mean(combination)));
            cells.add(median.isPresent() ? NumberFormats.of(median.getAsDouble()) : "not reached");
            fields.add(exact(median));
            rows.add(cells);
            exact.add(fields);
        }
        return new DataTable(
                measurements.metric().name(),
                "%s by combination, restricted to %s%s"
                        .formatted(
                                Figures.title(measurements.metric()),
                                NumberFormats.of(horizon),
                                measurements.metric().unit().isEmpty()
                                        ? ""
                                        : " " + measurements.metric().unit()),
                1,
                List.of("combination", "n", "happened in", "mean", "95 % (Student's)", "deviation", "median"),
                rows,
                List.of(
                        "combination",
                        "runs",
                        "n",
                        "happened",
                        "horizon",
                        "mean",
                        "low95",
                        "high95",
                        "deviation",
                        "median"),
                exact);
    }

    private static List<String> begin(Findings findings, Combination combination, String... counts) {
        var cells = new ArrayList<String>();
        cells.add(findings.label(combination));
        cells.addAll(List.of(counts));
        return cells;
    }

    private static List<String> mean(Optional<Mean> mean) {
        return List.of(
                mean.map(m -> NumberFormats.of(m.value())).orElse(NONE),
                mean.flatMap(Mean::interval).map(NumberFormats::of).orElse(NONE),
                mean.filter(m -> m.count() > 1)
                        .map(m -> NumberFormats.of(m.deviation()))
                        .orElse(NONE));
    }

    private static List<String> exactMean(Optional<Mean> mean) {
        Optional<ConfidenceInterval> interval = mean.flatMap(Mean::interval);
        return List.of(
                mean.map(m -> NumberFormats.exact(m.value())).orElse(""),
                interval.map(ends -> NumberFormats.exact(ends.low())).orElse(""),
                interval.map(ends -> NumberFormats.exact(ends.high())).orElse(""),
                mean.filter(m -> m.count() > 1)
                        .map(m -> NumberFormats.exact(m.deviation()))
                        .orElse(""));
    }
}
