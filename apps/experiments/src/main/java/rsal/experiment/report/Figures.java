package rsal.experiment.report;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import rsal.experiment.Combination;
import rsal.experiment.Findings;
import rsal.experiment.Manifest.Measure;
import rsal.experiment.Row;
import rsal.experiment.report.Drawing.Align;
import rsal.experiment.report.Drawing.Ink;
import rsal.experiment.statistics.BoxPlot;
import rsal.experiment.statistics.Interval;
import rsal.experiment.statistics.Mean;
import rsal.experiment.statistics.Share;

/// The figures of a report.
final class Figures {
    private static final Map<String, Ink> INKS = inks();
    private static final int ROW = 34; // height of a combination [px]
    private static final int TOP = 34; // above the first
    private static final int BOTTOM = 48; // below the last
    private static final int RIGHT = Figure.WIDTH - 30;
    private static final int LONGEST = 44; // letters of a label
    private static final double LETTER = 8; // width of a wide font [px]

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

    static String title(Measure measure) {
        String unit = measure.unit().isEmpty() ? "" : " [%s]".formatted(measure.unit());
        return measure.name() + unit + (measure.perRobot() ? ", mean over the robots of a run" : "");
    }

    /// A bar of shares for each combination.
    static Figure outcomes(Findings findings, List<Combination> combinations) {
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
                        Numbers.exact(share.value()),
                        Numbers.exact(share.interval().low()),
                        Numbers.exact(share.interval().high())));
            }
        }
        return figure(
                "outcomes",
                "Bars of how runs ended, for each of %s; the table below has the numbers."
                        .formatted(counted(combinations)),
                combinations.size(),
                drawing -> drawOutcomes(drawing, findings, combinations, outcomes),
                List.of("combination", "outcome", "count", "runs", "share", "low95", "high95"),
                numbers);
    }

    private static void drawOutcomes(
            Drawing drawing, Findings findings, List<Combination> combinations, List<String> outcomes) {
        double left = labels(drawing, findings.labels(combinations));
        double x = left;
        for (String outcome : outcomes) {
            drawing.bar(x, 8, 12, 12, ink(outcome));
            drawing.text(x + 17, 19, outcome, Align.START, Ink.TEXT);
            x += 32 + outcome.length() * LETTER;
        }
        var scale = new Scale(0, 100, left, RIGHT);
        scale.draw(drawing, TOP, TOP + combinations.size() * ROW, "share of the runs [%]");
        for (int i = 0; i < combinations.size(); i++) {
            List<Row> rows = findings.of(combinations.get(i));
            double from = 0;
            for (String outcome : outcomes) {
                double share = 100.0 * count(rows, outcome) / rows.size();
                double width = scale.at(from + share) - scale.at(from);
                if (width > 0) {
                    drawing.bar(scale.at(from), TOP + i * ROW + 5, width, ROW - 10, ink(outcome));
                }
                if (width > 40) {
                    drawing.text(
                            scale.at(from) + width / 2,
                            middle(i) + 5,
                            Numbers.percent(share / 100),
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
    static Figure measure(Findings findings, Measure measure, List<Combination> combinations) {
        var boxes = new ArrayList<BoxPlot>();
        var means = new ArrayList<Mean>();
        var numbers = new ArrayList<List<String>>();
        for (Combination combination : combinations) {
            double[] values = findings.values(combination, measure);
            BoxPlot box = BoxPlot.of(values);
            Mean mean = Mean.of(values);
            boxes.add(box);
            means.add(mean);
            numbers.add(List.of(
                    findings.label(combination),
                    Integer.toString(mean.count()),
                    Numbers.exact(mean.value()),
                    mean.interval().map(i -> Numbers.exact(i.low())).orElse(""),
                    mean.interval().map(i -> Numbers.exact(i.high())).orElse(""),
                    Numbers.exact(mean.deviation()),
                    Numbers.exact(box.least()),
                    Numbers.exact(box.first()),
                    Numbers.exact(box.median()),
                    Numbers.exact(box.third()),
                    Numbers.exact(box.most())));
        }
        return figure(
                measure.name(),
                "Box plots of %s and means with 95 %% confidence intervals, for each of %s; the table below has the numbers."
                        .formatted(title(measure), counted(combinations)),
                combinations.size(),
                drawing -> drawMeasure(drawing, findings.labels(combinations), boxes, means, title(measure)),
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

    private static void drawMeasure(
            Drawing drawing, List<String> labels, List<BoxPlot> boxes, List<Mean> means, String title) {
        double left = labels(drawing, labels);
        double[] ends = Stream.concat(
                        boxes.stream().flatMap(box -> Stream.of(box.least(), box.most())),
                        means.stream().flatMap(Figures::ends))
                .mapToDouble(Double::doubleValue)
                .toArray();
        Scale scale = scale(ends, left);
        drawing.box(left, 7, 22, 12, Ink.DATA);
        drawing.text(left + 29, 18, "quartiles, median; points lie beyond 1.5 boxes", Align.START, Ink.QUIET);
        drawing.line(left + 370, 13, left + 392, 13, 2, Ink.MEAN);
        drawing.dot(left + 381, 13, 4, Ink.MEAN);
        drawing.text(left + 399, 18, "mean, 95 %", Align.START, Ink.QUIET);
        scale.draw(drawing, TOP, TOP + boxes.size() * ROW, title);
        for (int i = 0; i < boxes.size(); i++) {
            BoxPlot box = boxes.get(i);
            double y = middle(i) - 4;
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

    /// For each change the mean difference with its interval.
    ///
    /// @param changes that are known
    static Figure effects(Measure measure, List<Change> changes) {
        List<Mean> means = changes.stream()
                .map(change -> change.effect().difference().orElseThrow())
                .toList();
        var numbers = new ArrayList<List<String>>();
        for (int i = 0; i < changes.size(); i++) {
            Change change = changes.get(i);
            Optional<Interval> interval = means.get(i).interval();
            numbers.add(List.of(
                    change.factor(),
                    change.from(),
                    change.to(),
                    Integer.toString(change.effect().complete()),
                    Integer.toString(change.effect().blocks()),
                    Numbers.exact(means.get(i).value()),
                    interval.map(ends -> Numbers.exact(ends.low())).orElse(""),
                    interval.map(ends -> Numbers.exact(ends.high())).orElse("")));
        }
        return figure(
                measure.name() + "-effects",
                "What each change does to %s: mean differences with 95 %% confidence intervals; the table below has the numbers."
                        .formatted(title(measure)),
                changes.size(),
                drawing -> {
                    double left = labels(
                            drawing, changes.stream().map(Change::toString).toList());
                    double[] ends = Stream.concat(Stream.of(0.0), means.stream().flatMap(Figures::ends))
                            .mapToDouble(Double::doubleValue)
                            .toArray();
                    Scale scale = scale(ends, left);
                    int bottom = TOP + changes.size() * ROW;
                    scale.draw(drawing, TOP, bottom, "difference of " + title(measure));
                    drawing.line(scale.at(0), TOP - 6, scale.at(0), bottom, 1.5, Ink.QUIET);
                    drawing.text(scale.at(0), TOP - 11, "no difference", Align.MIDDLE, Ink.QUIET);
                    for (int i = 0; i < means.size(); i++) {
                        estimate(drawing, scale, means.get(i), middle(i));
                    }
                },
                List.of("factor", "from", "to", "seeds", "ofSeeds", "difference", "low95", "high95"),
                numbers);
    }

    private static Scale scale(double[] ends, double left) {
        return Scale.of(
                Arrays.stream(ends).min().orElse(0), Arrays.stream(ends).max().orElse(1), left, RIGHT);
    }

    private static double middle(int row) {
        return TOP + row * ROW + ROW / 2.0;
    }

    /// @return where there is room beside them, in pixels
    private static double labels(Drawing drawing, List<String> labels) {
        List<String> shown = labels.stream().map(Figures::shortened).toList();
        double left =
                16 + LETTER * shown.stream().mapToInt(String::length).max().orElse(0);
        for (int i = 0; i < shown.size(); i++) {
            drawing.text(left - 10, middle(i) + 4, shown.get(i), Align.END, Ink.TEXT);
        }
        return left;
    }

    private static String shortened(String label) {
        return label.length() > LONGEST ? label.substring(0, LONGEST - 1) + "…" : label;
    }

    private static String counted(List<Combination> combinations) {
        return combinations.size() == 1 ? "one combination" : combinations.size() + " combinations";
    }

    private static Figure figure(
            String name,
            String alternative,
            int rows,
            Consumer<Drawing> picture,
            List<String> header,
            List<List<String>> numbers) {
        return new Figure(
                name.replaceAll("[^A-Za-z0-9.-]", "_").toLowerCase(Locale.ROOT),
                alternative,
                Figure.WIDTH,
                TOP + rows * ROW + BOTTOM,
                picture,
                header,
                numbers);
    }
}
