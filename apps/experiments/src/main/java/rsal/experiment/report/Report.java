package rsal.experiment.report;

import java.io.IOException;
import java.net.URLEncoder;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.function.BiFunction;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import java.util.stream.StreamSupport;
import rsal.experiment.Combination;
import rsal.experiment.CsvLine;
import rsal.experiment.Factor;
import rsal.experiment.Findings;
import rsal.experiment.Manifest.Argument;
import rsal.experiment.Manifest.Measure;
import rsal.experiment.Manifest.Session;
import rsal.experiment.Recordings;
import rsal.experiment.Row;
import rsal.experiment.statistics.BoxPlot;
import rsal.experiment.statistics.Effect;
import rsal.experiment.statistics.Mean;
import rsal.experiment.statistics.Share;
import rsal.scenario.Counted;

/// What an experiment says, as a page that carries all it needs: it can be sent to others, read without a
/// network, and printed. Its figures are also there as files, a picture and the numbers of each.
public final class Report {
    private static final int MOST_LISTED = 10_000; // runs

    private final Findings findings;
    private final Map<Integer, String> recordings; // of runs: where they are, seen from the page
    private final List<Combination> combinations; // of which runs have ended
    private final List<Figure> figures = new ArrayList<>();
    private final StringBuilder html = new StringBuilder();

    private Report(Findings findings, Map<Integer, String> recordings) {
        this.findings = findings;
        this.recordings = recordings;
        this.combinations = findings.design().combinations().stream()
                .filter(combination -> !findings.of(combination).isEmpty())
                .toList();
    }

    /// Writes the page, and its figures beside it: `report.html` and `report-figures/outcomes.png`. It links to the
    /// recordings of runs that are there.
    ///
    /// @param folder of the sweep
    /// @return all files that were written, the page first
    /// @throws IOException when they can't be
    public static List<Path> write(Findings findings, Path folder, Path page) throws IOException {
        var report = new Report(findings, recordings(findings, folder, page));
        String text = report.page();
        String name = String.valueOf(page.getFileName()).replaceAll("\\.html?$", "");
        Path beside = page.resolveSibling(name + "-figures");
        var written = new ArrayList<Path>();
        written.add(Files.writeString(page, text));
        if (!report.figures.isEmpty()) {
            Files.createDirectories(beside);
        }
        for (Figure figure : report.figures) {
            Path csv = beside.resolve(figure.name() + ".csv");
            String lines = Stream.concat(Stream.of(figure.header()), figure.numbers().stream())
                    .map(row -> CsvLine.of(row.stream()))
                    .collect(Collectors.joining());
            written.add(Files.writeString(csv, lines, StandardCharsets.UTF_8));
            written.add(Files.write(beside.resolve(figure.name() + ".png"), PngDrawing.of(figure)));
        }
        return written;
    }

    private static Map<Integer, String> recordings(Findings findings, Path folder, Path page) {
        Path from = page.toAbsolutePath().normalize().getParent();
        var recordings = new HashMap<Integer, String>();
        for (Row row : findings.rows()) {
            Path file = Recordings.file(folder, row.run()).toAbsolutePath().normalize();
            if (from != null && Files.exists(file)) {
                recordings.put(row.run(), link(from.relativize(file)));
            }
        }
        return recordings;
    }

    private static String link(Path relative) {
        return StreamSupport.stream(relative.spliterator(), false)
                .map(name -> URLEncoder.encode(name.toString(), StandardCharsets.UTF_8)
                        .replace("+", "%20"))
                .collect(Collectors.joining("/"));
    }

    /// The page alone, without links to recordings.
    public static String html(Findings findings) {
        return new Report(findings, Map.of()).page();
    }

    private String page() {
        Session first = findings.manifest().sessions().getFirst();
        String title = findings.manifest().title();
        html.append(Style.head(title));
        html.append("<main>\n<header>\n<p class=\"kind\">Sweep of %s, %s</p>\n<h1>%s</h1>\n<p>%s</p>\n</header>\n"
                .formatted(
                        text(findings.manifest().subject().scenario()),
                        text(first.started()
                                .substring(0, Math.min(10, first.started().length()))),
                        text(title),
                        text(size())));
        if (combinations.isEmpty()) {
            html.append("<p>No run has ended yet.</p>\n");
        } else {
            summary();
            outcomes();
            for (Measure measure : findings.manifest().measures()) {
                measure(measure);
            }
            failures();
            recorded();
        }
        made();
        return html.append("</main>\n</body>\n</html>\n").toString();
    }

    private String size() {
        int wanted = findings.design().trials().size();
        int seeds = findings.design().seeds().size();
        String all = "%s of %s with %s (%s)"
                .formatted(
                        Counted.of(wanted, "run"),
                        Counted.of(findings.design().combinations().size(), "combination"),
                        Counted.of(seeds, "seed"),
                        seeds == 1
                                ? findings.design().seeds().getFirst()
                                : findings.design().seeds().getFirst() + " to "
                                        + findings.design().seeds().getLast());
        return findings.isComplete()
                ? all + "; the seeds are the same for each combination."
                : all
                        + ", of which only %d have ended so far."
                                .formatted(findings.rows().size());
    }

    /// What makes a difference, first.
    private void summary() {
        var clear = new ArrayList<String>();
        long asked = 0;
        for (String outcome : toldApart()) {
            List<Change> changes = changes(outcome);
            asked += known(changes);
            changes.stream()
                    .filter(change -> change.effect().isClear())
                    .map(change -> item(change, " percentage points of runs that end as", outcome, ""))
                    .forEach(clear::add);
        }
        for (Measure measure : findings.manifest().measures()) {
            List<Change> changes = changes(measure);
            asked += known(changes);
            changes.stream()
                    .filter(change -> change.effect().isClear())
                    .map(change -> item(change, unit(measure) + " of", measure.name(), judged(measure, change)))
                    .forEach(clear::add);
        }
        html.append("<section>\n<h2>In short</h2>\n");
        if (asked == 0) {
            html.append("<p>Nothing can be compared: that takes two combinations, and two seeds or more.</p>\n");
        } else if (clear.isEmpty()) {
            html.append("<p>No change of what was varied makes a clear difference to what was measured.</p>\n");
        } else {
            html.append("<p>These changes make a clear difference, all else equal:</p>\n<ul>\n");
            clear.forEach(html::append);
            html.append("</ul>\n");
        }
        if (asked > 0) {
            html.append(("<p class=\"note\">%s looked at, each with a 95 %% confidence interval: were there no"
                            + " differences at all, about one in twenty would still look clear.</p>\n")
                    .formatted(asked == 1 ? "One difference was" : asked + " differences were"));
        }
        html.append("</section>\n");
    }

    /// How many have a confidence interval.
    private static long known(List<Change> changes) {
        return changes.stream()
                .filter(change ->
                        change.effect().difference().flatMap(Mean::interval).isPresent())
                .count();
    }

    /// @param unit with what joins it to the name
    /// @param judged what is said behind it
    private static String item(Change change, String unit, String name, String judged) {
        Mean difference = change.effect().difference().orElseThrow();
        return "<li><b>%s</b>: %s <b>%s</b> (95 %%: %s), over %s%s.</li>%n"
                .formatted(
                        text(change.toString()),
                        text(Numbers.signed(difference.value()) + unit),
                        text(name),
                        text(Numbers.signed(difference.interval().orElseThrow())),
                        Counted.of(difference.count(), "seed"),
                        judged);
    }

    private static String judged(Measure measure, Change change) {
        double difference = change.effect().difference().orElseThrow().value();
        return switch (measure.better()) {
            case "less" -> difference < 0 ? ": better" : ": worse";
            case "more" -> difference > 0 ? ": better" : ": worse";
            default -> "";
        };
    }

    private static String unit(Measure measure) {
        return measure.unit().isEmpty() ? "" : " " + measure.unit();
    }

    private void outcomes() {
        html.append("<section>\n<h2>How runs ended</h2>\n");
        figure(Figures.outcomes(findings, combinations));
        List<String> outcomes = Figures.outcomes(findings);
        var header = new ArrayList<>(List.of("combination", "runs"));
        header.addAll(outcomes);
        var rows = new ArrayList<List<String>>();
        for (Combination combination : combinations) {
            List<Row> ended = findings.of(combination);
            var cells = new ArrayList<>(List.of(findings.label(combination), Integer.toString(ended.size())));
            for (String outcome : outcomes) {
                var share = new Share(Figures.count(ended, outcome), ended.size());
                cells.add("%s (%s to %s)"
                        .formatted(
                                Numbers.percent(share.value()),
                                Numbers.percent(share.interval().low()),
                                Numbers.percent(share.interval().high())));
            }
            rows.add(cells);
        }
        html.append(Html.table("Shares of outcomes, with 95 % confidence intervals (Wilson's)", 1, header, rows));
        effectsOnShares();
        html.append("</section>\n");
    }

    /// The outcomes whose shares tell something by themselves: of two, one is what the other isn't.
    private List<String> toldApart() {
        List<String> outcomes = Figures.outcomes(findings);
        return outcomes.size() <= 2 ? outcomes.subList(0, outcomes.size() / 2) : outcomes;
    }

    private void effectsOnShares() {
        List<String> outcomes = Figures.outcomes(findings);
        if (outcomes.size() < 2 || findings.design().compared().isEmpty()) {
            return;
        }
        html.append("<h3>What each change does to it</h3>\n");
        var rows = new ArrayList<List<String>>();
        for (String outcome : outcomes) {
            for (Change change : changes(outcome)) {
                rows.add(Stream.concat(Stream.of(outcome), cells(change)).toList());
            }
        }
        html.append(Html.table(
                "Differences in shares of outcomes, in percentage points, all else equal, by seed",
                2,
                List.of("outcome", "change", "seeds used", "mean difference", "95 % (Student's)"),
                rows));
        html.append("<p class=\"note\">A run that ends so counts for 100, another one for 0; of each seed the mean over"
                + " all that is varied besides. The interval is rough where seeds are few, or nearly all runs end"
                + " alike.</p>\n");
    }

    private static Stream<String> cells(Change change) {
        Effect effect = change.effect();
        return Stream.of(
                change.toString(),
                "%d of %d".formatted(effect.complete(), effect.blocks()),
                effect.difference().map(d -> Numbers.signed(d.value())).orElse("–"),
                effect.difference().flatMap(Mean::interval).map(Numbers::signed).orElse("–"));
    }

    private void measure(Measure measure) {
        html.append("<section>\n<h2>%s</h2>\n".formatted(text(Figures.title(measure))));
        List<Combination> measured = combinations.stream()
                .filter(combination -> findings.values(combination, measure).length > 0)
                .toList();
        if (measured.isEmpty()) {
            html.append("<p>There was nothing to measure in any run.</p>\n</section>\n");
            return;
        }
        figure(Figures.measure(findings, measure, measured));
        var rows = new ArrayList<List<String>>();
        for (Combination combination : combinations) {
            double[] values = findings.values(combination, measure);
            int runs = findings.of(combination).size();
            var cells =
                    new ArrayList<>(List.of(findings.label(combination), "%d of %d".formatted(values.length, runs)));
            if (values.length == 0) {
                cells.addAll(List.of("–", "–", "–", "–", "–", "–"));
            } else {
                Mean mean = Mean.of(values);
                BoxPlot box = BoxPlot.of(values);
                cells.add(Numbers.of(mean.value()));
                cells.add(mean.interval().map(Numbers::of).orElse("–"));
                cells.add(values.length == 1 ? "–" : Numbers.of(mean.deviation()));
                cells.add(Numbers.of(box.least()));
                cells.add(Numbers.of(box.median()));
                cells.add(Numbers.of(box.most()));
            }
            rows.add(cells);
        }
        html.append(Html.table(
                Figures.title(measure) + " by combination",
                1,
                List.of(
                        "combination",
                        "runs with it",
                        "mean",
                        "95 % (Student's)",
                        "deviation",
                        "least",
                        "median",
                        "most"),
                rows));
        if (combinations.stream()
                .anyMatch(
                        c -> findings.values(c, measure).length < findings.of(c).size())) {
            html.append("<p class=\"note\">Runs in which there was nothing to measure are not in these numbers. When"
                    + " that is so because they ended too early, the means of the others flatter.</p>\n");
        }
        effects(measure);
        html.append("</section>\n");
    }

    private List<Change> changes(Measure measure) {
        return changes((factor, to) -> findings.effect(factor, to, measure));
    }

    private List<Change> changes(String outcome) {
        return changes((factor, to) -> findings.effectOnShare(factor, to, outcome));
    }

    private List<Change> changes(BiFunction<Factor, String, Effect> effect) {
        var changes = new ArrayList<Change>();
        for (Factor factor : findings.design().compared()) {
            String from = factor.levels().getFirst();
            for (String to : factor.levels().subList(1, factor.levels().size())) {
                changes.add(new Change(factor.argument(), from, to, effect.apply(factor, to)));
            }
        }
        return changes;
    }

    private void effects(Measure measure) {
        List<Change> changes = changes(measure);
        if (changes.isEmpty()) {
            return;
        }
        html.append("<h3>What each change does to it</h3>\n");
        List<Change> known = changes.stream()
                .filter(change -> change.effect().difference().isPresent())
                .toList();
        if (!known.isEmpty()) {
            figure(Figures.effects(measure, known));
        }
        html.append(Html.table(
                "Differences in %s, all else equal, by seed".formatted(measure.name()),
                1,
                List.of("change", "seeds used", "mean difference", "95 % (Student's)"),
                changes.stream().map(change -> cells(change).toList()).toList()));
        html.append("<p class=\"note\">Of each seed the mean over all that is varied besides; seeds in which a value"
                + " is missing are left out.</p>\n");
    }

    private void figure(Figure figure) {
        figures.add(figure);
        html.append("<figure>\n").append(SvgDrawing.of(figure)).append("</figure>\n");
    }

    /// Runs that broke, and agents that failed in runs that went on.
    private void failures() {
        var rows = new ArrayList<List<String>>();
        for (Row row : findings.rows()) {
            String reason = Stream.concat(
                            Stream.of(row.reason()).filter(text -> !text.isEmpty()),
                            row.failedAgents().entrySet().stream()
                                    .map(agent -> "Agent (%s) failed: %s".formatted(agent.getKey(), agent.getValue())))
                    .collect(Collectors.joining(" "));
            if (!reason.isEmpty()) {
                rows.add(List.of(Integer.toString(row.run()), row.outcome(), reason, again(row)));
            }
        }
        html.append("<section>\n<h2>What went wrong</h2>\n");
        if (rows.isEmpty()) {
            html.append("<p>No run broke, and no agent failed.</p>\n");
        } else {
            html.append(Html.table(
                    "Runs that broke, or in which agents failed",
                    4,
                    List.of("run", "outcome", "reason", "see it again"),
                    rows));
        }
        html.append("</section>\n");
    }

    /// Runs that can be seen again.
    private void recorded() {
        List<Row> all = findings.rows().stream()
                .filter(row -> recordings.containsKey(row.run()))
                .toList();
        List<Row> rows = all.subList(0, Math.min(MOST_LISTED, all.size()));
        if (rows.isEmpty()) {
            return;
        }
        html.append("<section>\n<h2>Recordings</h2>\n<p>'rsal replay FILE.mcap' shows a run in the page, Foxglove opens"
                + " the file, too.</p>\n<details>\n<summary>%s</summary>\n"
                        .formatted(Counted.of(all.size(), "recorded run")
                                + (rows.size() < all.size() ? ", the first %d of them".formatted(rows.size()) : "")));
        html.append(Html.table(
                "Runs with their recordings",
                3,
                List.of("run", "combination", "outcome", "seed", "simulated [s]"),
                rows.stream().map(this::listed).toList(),
                rows.stream().map(row -> recordings.getOrDefault(row.run(), "")).toList()));
        html.append("</details>\n</section>\n");
    }

    private List<String> listed(Row row) {
        Combination combination = findings.design().combinations().get(row.combination() - 1);
        return List.of(
                Integer.toString(row.run()),
                findings.label(combination),
                row.outcome(),
                Long.toString(row.seed()),
                row.simulatedSeconds().isPresent()
                        ? Numbers.of(row.simulatedSeconds().getAsDouble())
                        : "–");
    }

    /// How to do one run by itself.
    private String again(Row row) {
        Combination combination = findings.design().combinations().get(row.combination() - 1);
        var words = new ArrayList<>(List.of(
                "rsal", "run", findings.manifest().sessions().getFirst().scenario() + ":" + row.configuration()));
        var set = new LinkedHashMap<>(findings.manifest().subject().settings());
        set.putAll(combination.levels());
        set.forEach((name, value) -> words.addAll(List.of("--set", name + "=" + value)));
        words.addAll(List.of("--seed", Long.toString(row.seed())));
        findings.manifest()
                .subject()
                .forSeconds()
                .ifPresent(seconds -> words.addAll(List.of("--for", Numbers.exact(seconds))));
        return ShellWords.of(words);
    }

    private void made() {
        html.append("<section>\n<h2>How it was made</h2>\n");
        for (Session session : findings.manifest().sessions()) {
            html.append("<p>%s, %s at once, with %s, Java %s, on %s with %s:</p>\n<pre tabindex=\"0\">%s</pre>\n"
                    .formatted(
                            text(session.started().replace("T", " ").replace("Z", " UTC")),
                            Counted.of(session.jobs(), "run"),
                            text(session.machine().rsal()),
                            text(session.machine().java()),
                            text(session.machine().system()),
                            Counted.of(session.machine().cores(), "core"),
                            text(ShellWords.of(session.command()))));
        }
        Set<String> varied =
                findings.design().factors().stream().map(Factor::argument).collect(Collectors.toSet());
        Map<String, String> settings = findings.manifest().subject().settings();
        List<List<String>> arguments = findings.manifest().arguments().stream()
                .filter(argument -> varied.contains(argument.name()) || settings.containsKey(argument.name()))
                .map(argument ->
                        List.of(argument.name(), levels(argument, settings), argument.unit(), argument.description()))
                .toList();
        if (!arguments.isEmpty()) {
            html.append(Html.table(
                    "Arguments that were varied or set",
                    4,
                    List.of("argument", "values", "unit", "meaning"),
                    arguments));
        }
        html.append(
                "<details>\n<summary>The scenario (SHA-256 %s)</summary>\n<pre tabindex=\"0\">%s</pre>\n</details>\n"
                        .formatted(
                                text(findings.manifest().subject().sha256()),
                                text(findings.manifest().scenarioText())));
        html.append("</section>\n");
    }

    private String levels(Argument argument, Map<String, String> settings) {
        return findings.design().factors().stream()
                .filter(factor -> factor.argument().equals(argument.name()))
                .findFirst()
                .map(factor -> String.join(", ", factor.levels()))
                .orElseGet(() -> settings.getOrDefault(argument.name(), ""));
    }

    private static String text(String plain) {
        return Html.text(plain);
    }
}
