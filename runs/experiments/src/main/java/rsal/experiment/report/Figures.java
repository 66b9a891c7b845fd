package rsal.experiment.report;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import rsal.experiment.Change;
import rsal.experiment.Combination;
import rsal.experiment.Findings;
import rsal.experiment.Manifest.MetricEntry;
import rsal.experiment.MetricSamples;
import rsal.experiment.Row;
import rsal.experiment.report.Drawing.Align;
import rsal.experiment.report.Drawing.Ink;
import rsal.experiment.report.FigureLayout.Mark;
import rsal.experiment.report.ReportFigure.Picture;
import rsal.experiment.statistics.BoxPlot;
import rsal.experiment.statistics.ConfidenceInterval;
import rsal.experiment.statistics.KaplanMeier;
import rsal.experiment.statistics.Mean;
import rsal.experiment.statistics.Share;

/// The figures of a report.
final class Figures {
    private static final Map<String, Ink> INKS = inks();
    private static final List<Ink> CURVES =
            List.of(Ink.CURVE1, Ink.CURVE2, Ink.CURVE3, Ink.CURVE4, Ink.CURVE5, Ink.CURVE6);
    private static final Mark MEAN = new Mark(
            "mean, 95 %",
            (drawing, at) -> {
                drawing.line(at.x() - 11, at.y(), at.x() + 11, at.y(), 2, Ink.MEAN);
                drawing.dot(at.x(), at.y(), 4, Ink.MEAN);
            });
    private static final int MOST_BANDS = 3; // curves with intervals; more would hide each other
    private static final int CURVES_HIGH = 240; // height of curves [px]

    private Figures() {}

    private static Map<String, Ink> inks() {
        var inks = new LinkedHashMap<String, Ink>(); // in the order in which they are drawn
        inks.put("success", Ink.SUCCESS);
        inks.put("limit", Ink.LIMIT);
        inks.put("timeout", Ink.TIMEOUT);
        inks.put("failure", Ink.FAILURE);
        inks.put(Row.BROKEN, Ink.BROKEN);
        return inks;
    }

    /// The outcomes that there were, in the order in which they are shown.
    static List<String> outcomes(Findings findings) {
        var there = findings.rows().stream().map(Row::outcome).collect(Collectors.toSet());
        return INKS.keySet().stream().filter(there::contains).toList();
    }

    static int count(List<Row> rows, String outcome) {
        return (int) rows.stream().filter(row -> row.outcome().equals(outcome)).count();
    }

    static String title(MetricEntry metric) {
        String unit = metric.unit().isEmpty() ? "" : " [%s]".formatted(metric.unit());
        return metric.name() + unit + (metric.perRobot() ? ", mean over the robots of a run" : "");
    }

    /// What is drawn in rows, with a scale below.
    private record Rows(List<String> labels, List<Mark> keys, Content content) implements Picture {
        interface Content {
            void draw(Drawing drawing, FigureLayout frame);
        }

        private FigureLayout frame(double width) {
            return new FigureLayout(width, labels, keys);
        }

        @Override
        public double height(double width) {
            return frame(width).height();
        }

        @Override
        public void draw(Drawing drawing, double width) {
            frame(width).draw(drawing);
            content.draw(drawing, frame(width));
        }
    }

    /// A bar of shares for each combination.
    static ReportFigure outcomes(Findings findings, List<Combination> combinations) {
        List<String> outcomes = outcomes(findings);
        var numbers = new ArrayList<List<String>>();
        for (Combination combination : combinations) {
            List<Row> rows = findings.of(combination);
            for (String outcome : outcomes) {
                var share = new Share(count(rows, outcome), rows.size());
                numbers.add(List.of(
                        findings.label(combination),
                        outcome,
                        Integer.toString(share.count()),
                        Integer.toString(share.of()),
                        NumberFormats.exact(share.value()),
                        NumberFormats.exact(share.interval().low()),
                        NumberFormats.exact(share.interval().high())));
            }
        }
        List<Mark> keys = outcomes.stream()
                .map(outcome ->
                        new Mark(outcome, (drawing, at) -> drawing.bar(at.x() - 6, at.y() - 6, 12, 12, ink(outcome))))
                .toList();
        return new ReportFigure(
                "outcomes",
                "Bars of how runs ended, for each of %s; the table below has the numbers."
                        .formatted(counted(combinations)),
                new Rows(
                        findings.labels(combinations),
                        keys,
                        (drawing, frame) -> drawOutcomes(drawing, frame, findings, combinations)),
                List.of("combination", "outcome", "count", "runs", "share", "low95", "high95"),
                numbers);
    }

    private static void drawOutcomes(
            Drawing drawing, FigureLayout frame, Findings findings, List<Combination> combinations) {
        var scale = new Scale(0, 100, frame.left(), frame.right());
        scale.draw(drawing, frame.top(), frame.bottom(), "share of the runs [%]");
        for (int i = 0; i < combinations.size(); i++) {
            List<Row> rows = findings.of(combinations.get(i));
            double from = 0;
            for (String outcome : outcomes(findings)) {
                double share = 100.0 * count(rows, outcome) / rows.size();
                double width = scale.at(from + share) - scale.at(from);
                if (width > 0) {
                    drawing.bar(scale.at(from), frame.middle(i) - 12, width, 24, ink(outcome));
                }
                if (width > 40) {
                    drawing.text(
                            scale.at(from) + width / 2,
                            frame.middle(i) + 5,
                            NumberFormats.percent(share / 100),
                            Align.MIDDLE,
                            Ink.ON_BAR);
                }
                from += share;
            }
        }
    }

    private static Ink ink(String outcome) {
        return INKS.getOrDefault(outcome, Ink.BROKEN);
    }

    /// For each combination a box plot, and the mean with its interval.
    ///
    /// @param combinations that have values
    static ReportFigure values(Findings findings, MetricSamples measurements, List<Combination> combinations) {
        MetricEntry metric = measurements.metric();
        var boxes = new ArrayList<BoxPlot>();
        var means = new ArrayList<Mean>();
        var numbers = new ArrayList<List<String>>();
        for (Combination combination : combinations) {
            double[] values = measurements.of(combination);
            BoxPlot box = BoxPlot.of(values);
            Mean mean = Mean.of(values);
            boxes.add(box);
            means.add(mean);
            numbers.add(List.of(
                    findings.label(combination),
                    Integer.toString(mean.count()),
                    NumberFormats.exact(mean.value()),
                    mean.interval().map(i -> NumberFormats.exact(i.low())).orElse(""),
                    mean.interval().map(i -> NumberFormats.exact(i.high())).orElse(""),
                    NumberFormats.exact(mean.deviation()),
                    NumberFormats.exact(box.least()),
                    NumberFormats.exact(box.first()),
                    NumberFormats.exact(box.median()),
                    NumberFormats.exact(box.third()),
                    NumberFormats.exact(box.most())));
        }
        return new ReportFigure(
                metric.name(),
                "Box plots of %s and means with 95 %% confidence intervals, for each of %s; the table below has the numbers."
                        .formatted(title(metric), counted(combinations)),
                new Rows(
                        findings.labels(combinations),
                        List.of(
                                new Mark(
                                        "quartiles, median; points lie beyond 1.5 boxes",
                                        (drawing, at) -> drawing.box(at.x() - 11, at.y() - 6, 22, 12, Ink.DATA)),
                                MEAN),
                        (drawing, frame) -> drawValues(drawing, frame, boxes, means, title(metric))),
                List.of(
                        "combination",
                        "runs",
                        "mean",
                        "low95",
                        "high95",
                        "deviation",
                        "least",
                        "quartile1",
                        "median",
                        "quartile3",
                        "most"),
                numbers);
    }

    private static void drawValues(
            Drawing drawing, FigureLayout frame, List<BoxPlot> boxes, List<Mean> means, String title) {
        Scale scale = scale(
                Stream.concat(
                        boxes.stream().flatMap(box -> Stream.of(box.least(), box.most())),
                        means.stream().flatMap(Figures::ends)),
                frame);
        scale.draw(drawing, frame.top(), frame.bottom(), title);
        for (int i = 0; i < boxes.size(); i++) {
            BoxPlot box = boxes.get(i);
            double y = frame.middle(i) - 4;
            drawing.line(scale.at(box.low()), y, scale.at(box.first()), y, 1.2, Ink.DATA);
            drawing.line(scale.at(box.third()), y, scale.at(box.high()), y, 1.2, Ink.DATA);
            drawing.box(scale.at(box.first()), y - 8, scale.at(box.third()) - scale.at(box.first()), 16, Ink.DATA);
            drawing.line(scale.at(box.median()), y - 8, scale.at(box.median()), y + 8, 2.5, Ink.DATA);
            box.outside().forEach(value -> drawing.ring(scale.at(value), y, 3, Ink.DATA));
            estimate(drawing, scale, means.get(i), y + 13);
        }
    }

    private static Stream<Double> ends(Mean mean) {
        return mean.interval().map(i -> Stream.of(i.low(), i.high())).orElseGet(() -> Stream.of(mean.value()));
    }

    private static void estimate(Drawing drawing, Scale scale, Mean mean, double y) {
        mean.interval().ifPresent(i -> {
            drawing.line(scale.at(i.low()), y, scale.at(i.high()), y, 2, Ink.MEAN);
            for (double end : new double[] {i.low(), i.high()}) {
                drawing.line(scale.at(end), y - 4, scale.at(end), y + 4, 2, Ink.MEAN);
            }
        });
        drawing.dot(scale.at(mean.value()), y, 4, Ink.MEAN);
    }

    /// In which share of runs it had happened by when: Kaplan-Meier curves, a few in each figure.
    ///
    /// @param combinations with a curve
    static List<ReportFigure> curves(Findings findings, MetricSamples measurements, List<Combination> combinations) {
        int figures = (combinations.size() + CURVES.size() - 1) / CURVES.size();
        return IntStream.range(0, figures)
                .mapToObj(i -> curves(
                        findings,
                        measurements,
                        combinations.subList(i * CURVES.size(), Math.min((i + 1) * CURVES.size(), combinations.size())),
                        i == 0 ? "" : "-" + (i + 1)))
                .toList();
    }

    private static ReportFigure curves(
            Findings findings, MetricSamples measurements, List<Combination> combinations, String part) {
        MetricEntry metric = measurements.metric();
        double horizon = measurements.horizon().orElseThrow();
        var numbers = new ArrayList<List<String>>();
        for (Combination combination : combinations) {
            KaplanMeier curve = measurements.curve(combination).orElseThrow();
            for (KaplanMeier.Step step : curve.steps()) {
                numbers.add(List.of(
                        findings.label(combination),
                        NumberFormats.exact(step.time()),
                        Integer.toString(step.atRisk()),
                        Integer.toString(step.happened()),
                        NumberFormats.exact(1 - step.share()),
                        NumberFormats.exact(1 - step.interval().high()),
                        NumberFormats.exact(1 - step.interval().low())));
            }
        }
        var keys = new ArrayList<Mark>();
        for (int i = 0; i < combinations.size(); i++) {
            Ink ink = CURVES.get(i);
            keys.add(new Mark(
                    findings.label(combinations.get(i)),
                    (drawing, at) -> drawing.line(at.x() - 11, at.y(), at.x() + 11, at.y(), 2.5, ink)));
        }
        return new ReportFigure(
                metric.name() + part,
                "Kaplan-Meier curves of %s: in which share of runs it had happened by when, for each of %s."
                        .formatted(title(metric), counted(combinations)),
                new Picture() {
                    @Override
                    public double height(double width) {
                        return frame(width).height(CURVES_HIGH);
                    }

                    @Override
                    public void draw(Drawing drawing, double width) {
                        frame(width).draw(drawing);
                        drawCurves(drawing, frame(width), measurements, combinations, horizon);
                    }

                    private FigureLayout frame(double width) {
                        return new FigureLayout(width, List.of(), keys);
                    }
                },
                List.of("combination", "time", "atRisk", "happened", "share", "low95", "high95"),
                numbers);
    }

    private static void drawCurves(
            Drawing drawing,
            FigureLayout frame,
            MetricSamples measurements,
            List<Combination> combinations,
            double horizon) {
        double bottom = frame.bottom(CURVES_HIGH);
        var scale = new Scale(0, Math.max(horizon, 1e-9), frame.left(), frame.right());
        var shares = new Scale(0, 1, bottom, frame.top());
        scale.draw(drawing, frame.top(), bottom, title(measurements.metric()));
        drawing.text(frame.left(), frame.top() - 7, "share of runs in which it has happened", Align.START, Ink.QUIET);
        for (int percent = 0; percent <= 100; percent += 25) {
            double y = shares.at(percent / 100.0);
            drawing.line(frame.left(), y, frame.right(), y, 1, Ink.GRID);
            drawing.text(frame.left() - 6, y + 4, percent + " %", Align.END, Ink.QUIET);
        }
        for (int i = 0; i < combinations.size(); i++) {
            KaplanMeier curve = measurements.curve(combinations.get(i)).orElseThrow();
            drawCurve(drawing, scale, shares, curve, CURVES.get(i), combinations.size() <= MOST_BANDS);
        }
    }

    private static void drawCurve(
            Drawing drawing, Scale scale, Scale shares, KaplanMeier curve, Ink ink, boolean bands) {
        double horizon = scale.most();
        double from = 0;
        double share = 0;
        Optional<ConfidenceInterval> interval = Optional.empty();
        for (int i = 0; i <= curve.steps().size(); i++) {
            boolean last = i == curve.steps().size() || curve.steps().get(i).time() > horizon;
            double to = last ? horizon : curve.steps().get(i).time();
            double y = shares.at(share);
            drawing.line(scale.at(from), y, scale.at(to), y, 2, ink);
            if (bands && interval.isPresent()) {
                double high = shares.at(1 - interval.get().low());
                drawing.band(
                        scale.at(from),
                        high,
                        scale.at(to) - scale.at(from),
                        shares.at(1 - interval.get().high()) - high,
                        ink);
            }
            if (last) {
                break;
            }
            KaplanMeier.Step step = curve.steps().get(i);
            drawing.line(scale.at(to), y, scale.at(to), shares.at(1 - step.share()), 2, ink);
            from = to;
            share = 1 - step.share();
            interval = Optional.of(step.interval());
        }
        for (double time : curve.censored()) {
            if (time < horizon) {
                double y = shares.at(1 - curve.share(time));
                drawing.line(scale.at(time), y - 5, scale.at(time), y + 5, 1.5, ink);
            }
        }
    }

    /// For each change the mean difference with its interval.
    ///
    /// @param changes that are known
    static ReportFigure effects(MetricEntry metric, List<Compared<Change>> changes) {
        List<Mean> means = changes.stream()
                .map(change -> change.effect().difference().orElseThrow())
                .toList();
        var numbers = new ArrayList<List<String>>();
        for (int i = 0; i < changes.size(); i++) {
            Compared<Change> change = changes.get(i);
            Optional<ConfidenceInterval> interval = means.get(i).interval();
            numbers.add(List.of(
                    change.subject().factor().argument(),
                    change.subject().from(),
                    change.subject().to(),
                    Integer.toString(change.effect().complete()),
                    Integer.toString(change.effect().blocks()),
                    NumberFormats.exact(means.get(i).value()),
                    interval.map(ends -> NumberFormats.exact(ends.low())).orElse(""),
                    interval.map(ends -> NumberFormats.exact(ends.high())).orElse("")));
        }
        return new ReportFigure(
                metric.name() + "-effects",
                "What each change does to %s: mean differences with 95 %% confidence intervals; the table below has the numbers."
                        .formatted(title(metric)),
                new Rows(
                        changes.stream()
                                .map(change -> change.subject().toString())
                                .toList(),
                        List.of(
                                MEAN,
                                new Mark(
                                        "no difference",
                                        (drawing, at) ->
                                                drawing.line(at.x(), at.y() - 7, at.x(), at.y() + 7, 1.5, Ink.QUIET))),
                        (drawing, frame) -> {
                            Scale scale = scale(
                                    Stream.concat(Stream.of(0.0), means.stream().flatMap(Figures::ends)), frame);
                            scale.draw(drawing, frame.top(), frame.bottom(), "difference of " + title(metric));
                            drawing.line(scale.at(0), frame.top() - 4, scale.at(0), frame.bottom(), 1.5, Ink.QUIET);
                            for (int i = 0; i < means.size(); i++) {
                                estimate(drawing, scale, means.get(i), frame.middle(i));
                            }
                        }),
                List.of("factor", "from", "to", "seeds", "ofSeeds", "difference", "low95", "high95"),
                numbers);
    }

    private static Scale scale(Stream<Double> ends, FigureLayout frame) {
        double[] all = ends.mapToDouble(Double::doubleValue).toArray();
        return Scale.of(
                Arrays.stream(all).min().orElse(0), Arrays.stream(all).max().orElse(1), frame.left(), frame.right());
    }

    private static String counted(List<Combination> combinations) {
        return combinations.size() == 1 ? "one combination" : combinations.size() + " combinations";
    }
}
