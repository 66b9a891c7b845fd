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
import java.util.Optional;
import java.util.Set;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import java.util.stream.StreamSupport;
import rsal.experiment.Change;
import rsal.experiment.Combination;
import rsal.experiment.Factor;
import rsal.experiment.Findings;
import rsal.experiment.Manifest.Argument;
import rsal.experiment.Manifest.Session;
import rsal.experiment.MetricSamples;
import rsal.experiment.Recordings;
import rsal.experiment.Row;
import rsal.experiment.report.Conclusions.Quantity;
import rsal.experiment.report.Conclusions.Sentence;
import rsal.scenario.text.Counted;
import rsal.scenario.text.CsvLine;

/// What an experiment says, as a page that carries all it needs: it can be sent to others, read without a
/// network, and printed. Its figures and tables are also there as files.
public final class Report {
    private static final int MOST_LISTED = 10_000; // runs

    private final Findings findings;
    private final Map<Integer, String> recordings; // of runs: where they are, seen from the page
    private final List<Combination> combinations; // of which runs have ended
    private final Conclusions conclusions;
    private final List<ReportFigure> figures = new ArrayList<>();
    private final List<DataTable> tables = new ArrayList<>();
    private final StringBuilder html = new StringBuilder();

    private Report(Findings findings, Map<Integer, String> recordings) {
        this.findings = findings;
        this.recordings = recordings;
        this.conclusions = Conclusions.of(findings);
        this.combinations = findings.design().combinations().stream()
                .filter(combination -> !findings.of(combination).isEmpty())
                .toList();
    }

    /// What was written.
    ///
    /// @param figures folder of the figures, each as SVG, PDF, PNG and its numbers as CSV; empty when there are
    /// none
    /// @param tables folder of the tables, each as CSV and LaTeX; the same
    /// @param files all of them, the page first
    public record Written(Path page, Optional<Path> figures, Optional<Path> tables, List<Path> files) {}

    /// Writes the page, and its figures and tables beside it: `report.html`, `report-figures/outcomes.png` and
    /// `report-tables/outcomes.csv`. It links to the recordings of runs that are there.
    ///
    /// @param folder of the sweep
    /// @param print how figures are made for a paper, as SVG and PDF
    /// @throws IOException when they can't be
    public static Written write(Findings findings, Path folder, Path page, Print print) throws IOException {
        var report = new Report(findings, recordings(findings, folder, page));
        String text = report.page();
        var files = new ArrayList<Path>();
        files.add(Files.writeString(page, text));
        return new Written(
                page,
                report.writeFigures(beside(page, "figures"), print, files),
                report.writeTables(beside(page, "tables"), files),
                List.copyOf(files));
    }

    private static Path beside(Path page, String what) {
        String name = String.valueOf(page.getFileName()).replaceAll("\\.html?$", "");
        return page.resolveSibling(name + "-" + what);
    }

    private Optional<Path> writeFigures(Path folder, Print print, List<Path> files) throws IOException {
        if (figures.isEmpty()) {
            return Optional.empty();
        }
        Files.createDirectories(folder);
        for (ReportFigure figure : figures) {
            String numbers = Stream.concat(Stream.of(figure.header()), figure.numbers().stream())
                    .map(row -> CsvLine.of(row.stream()))
                    .collect(Collectors.joining());
            files.add(Files.writeString(folder.resolve(figure.name() + ".csv"), numbers));
            files.add(Files.writeString(folder.resolve(figure.name() + ".svg"), SvgDrawing.of(figure, print)));
            files.add(Files.write(folder.resolve(figure.name() + ".pdf"), PdfDrawing.of(figure, print)));
            files.add(Files.write(folder.resolve(figure.name() + ".png"), PngDrawing.of(figure)));
        }
        return Optional.of(folder);
    }

    private Optional<Path> writeTables(Path folder, List<Path> files) throws IOException {
        if (tables.isEmpty()) {
            return Optional.empty();
        }
        Files.createDirectories(folder);
        for (DataTable table : tables) {
            files.add(Files.writeString(folder.resolve(table.name() + ".csv"), table.csv()));
            files.add(Files.writeString(folder.resolve(table.name() + ".tex"), table.latex()));
        }
        return Optional.of(folder);
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
            conclusions.quantities().forEach(this::quantity);
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
        html.append("<section>\n<h2>In short</h2>\n");
        int known = conclusions.known();
        List<Sentence> clear = conclusions.clear();
        if (known == 0) {
            html.append("<p>Nothing can be compared: that takes two combinations, and two seeds or more.</p>\n");
        } else if (clear.isEmpty()) {
            html.append("<p>No change of what was varied makes a clear difference to what was measured.</p>\n");
        } else {
            html.append("<p>These changes make a clear difference, all else equal:</p>\n");
            list(clear);
        }
        List<Sentence> unclear = conclusions.unclear();
        if (!unclear.isEmpty()) {
            html.append("<details>\n<summary>%s</summary>\n"
                    .formatted(
                            unclear.size() == 1
                                    ? "One difference that is not clear"
                                    : unclear.size() + " differences that are not clear"));
            list(unclear);
            html.append("<p class=\"note\">Not clear does not mean equal: all differences in an interval are still"
                    + " possible. More seeds make it narrower.</p>\n</details>\n");
        }
        conclusions.missing(combinations).forEach(this::note);
        if (known > 0) {
            note(
                    "Runs with the same seed are compared with each other. A difference is clear when p < 0.05, corrected for"
                            + " all comparisons of its table (Holm). Decide which metric matters before you look at results.");
        }
        html.append("</section>\n");
    }

    private void list(List<Sentence> sentences) {
        html.append("<ul>\n");
        sentences.forEach(
                each -> html.append("<li><b>%s</b>%s</li>\n".formatted(text(each.subject()), text(each.said()))));
        html.append("</ul>\n");
    }

    private void note(String plain) {
        html.append("<p class=\"note\">%s</p>\n".formatted(text(plain)));
    }

    private void outcomes() {
        html.append("<section>\n<h2>How runs ended</h2>\n");
        figure(Figures.outcomes(findings, combinations));
        table(ReportTables.outcomes(findings, combinations));
        if (!conclusions.endings().isEmpty()) {
            html.append("<h3>What each change does to it</h3>\n");
            table(ReportTables.effectsOnShares(conclusions.endings()));
            note("A run that ends so counts for 100, another one for 0; of each seed the mean over all that is varied"
                    + " besides. The interval is rough where seeds are few, or nearly all runs end alike.");
        }
        html.append("</section>\n");
    }

    private void quantity(Quantity quantity) {
        MetricSamples measurements = quantity.measurements();
        html.append("<section>\n<h2>%s</h2>\n".formatted(text(Figures.title(quantity.metric()))));
        List<Combination> measured = combinations.stream()
                .filter(combination -> measurements.used(combination) > 0)
                .toList();
        if (measured.isEmpty()) {
            html.append("<p>There was nothing to measure in any run.</p>\n</section>\n");
            return;
        }
        if (quantity.metric().isEventTime()) {
            Figures.curves(findings, measurements, measured).forEach(this::figure);
            note(
                    "Kaplan-Meier curves: the share of runs in which it has happened, by time. A tick is a run that ended before that.");
            table(ReportTables.times(findings, measurements, combinations));
        } else {
            figure(Figures.values(findings, measurements, measured));
            table(ReportTables.values(findings, measurements, combinations));
        }
        Conclusions.missing(measurements, combinations).ifPresent(this::note);
        effects(quantity);
        html.append("</section>\n");
    }

    private void effects(Quantity quantity) {
        if (quantity.changes().isEmpty()) {
            return;
        }
        html.append("<h3>What each change does to it</h3>\n");
        List<Compared<Change>> known = quantity.changes().stream()
                .filter(change -> change.effect().difference().isPresent())
                .toList();
        if (!known.isEmpty()) {
            figure(Figures.effects(quantity.metric(), known));
        }
        table(ReportTables.effects(quantity));
        note(
                "Of each seed the mean over all that is varied besides; 95 % intervals are Student's. p (Holm) is corrected"
                        + " for all rows. d_z is the mean difference in standard deviations of the differences.");
        if (!quantity.interactions().isEmpty()) {
            html.append("<h3>Where it depends on something else</h3>\n");
            table(ReportTables.interactions(quantity));
            note(
                    "'before' and 'after' are what the change does before and after what stands under 'where'; the difference"
                            + " of both is judged.");
        }
    }

    private void figure(ReportFigure figure) {
        figures.add(figure);
        html.append("<figure>\n").append(SvgDrawing.of(figure)).append("</figure>\n");
    }

    private void table(DataTable table) {
        tables.add(table);
        html.append(table.html());
    }

    /// Runs that broke, and agents that failed in runs that went on.
    private void failures() {
        var rows = new ArrayList<List<String>>();
        for (Row row : findings.rows()) {
            String reason = Stream.concat(
                            Stream.of(row.reason()).filter(text -> !text.isEmpty()),
                            row.failedAgents().entrySet().stream()
                                    .map(agent -> "Agent '%s' failed: %s".formatted(agent.getKey(), agent.getValue())))
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
                        ? NumberFormats.of(row.simulatedSeconds().getAsDouble())
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
                .ifPresent(seconds -> words.addAll(List.of("--for", NumberFormats.exact(seconds))));
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
