package rsal.experiment.report;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;
import static org.assertj.core.api.Assertions.within;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Random;
import java.util.stream.LongStream;
import javax.imageio.ImageIO;
import org.apache.pdfbox.Loader;
import org.apache.pdfbox.pdmodel.PDDocument;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import rsal.experiment.Change;
import rsal.experiment.Combination;
import rsal.experiment.Factor;
import rsal.experiment.Findings;
import rsal.experiment.Manifest;
import rsal.experiment.Manifest.MetricEntry;
import rsal.experiment.MetricSamples;
import rsal.experiment.Recordings;
import rsal.experiment.Row;
import rsal.experiment.Trial;
import rsal.experiment.statistics.Effect;

class ReportTest {
    private static final MetricEntry TIME =
            new MetricEntry("captureTime", "s", false, "less", Optional.of(MetricEntry.EVENT_TIME));
    private static final MetricEntry ERROR =
            new MetricEntry("error", "m", true, "neither", Optional.of(MetricEntry.VALUE));
    private static final Factor HUNTERS = new Factor("hunters", List.of("2", "4"));
    private static final Change MORE_HUNTERS = new Change(HUNTERS, "2", "4");
    private static final Factor WORDS = new Factor("words", List.of("a", "b & <b>"));
    private static final Change OTHER_WORDS = new Change(WORDS, "a", "b & <b>");

    @TempDir
    Path folder;

    private Findings findings;

    /// Four hunters are 10 s faster than two, whatever the seed and the words; seed 3 with "b" has no time in 120 s,
    /// seed 4 broke once.
    @BeforeEach
    void makeUpRuns() {
        var manifest = new Manifest(
                1,
                new Manifest.Subject(
                        "hunt",
                        "0123456789abcdef",
                        List.of("virtual"),
                        List.of(HUNTERS, WORDS),
                        Map.of("prey", "1"),
                        LongStream.rangeClosed(1, 12).boxed().toList(),
                        OptionalDouble.empty()),
                "Hunters & <prey>",
                List.of(new Manifest.Argument("hunters", "", "How many."), new Manifest.Argument("speed", "m/s", "")),
                List.of(TIME, ERROR),
                List.of(new Manifest.Session(
                        "2026-03-04T05:06:07Z",
                        "my hunt.yaml",
                        List.of("rsal", "sweep", "my hunt.yaml", "--vary", "hunters=2,4"),
                        2,
                        new Manifest.Machine("rsal 9", "25", "Linux", 2))),
                "scenario: hunt # </pre><script>alert(1)</script>\n");
        var random = new Random(1);
        double[] luck = random.doubles(13, 50, 100).toArray();
        findings = new Findings(
                manifest,
                manifest.subject().design().trials().stream()
                        .map(trial -> row(trial, luck[(int) trial.seed()] + random.nextGaussian()))
                        .toList());
    }

    private static Row row(Trial trial, double luck) {
        Combination combination = trial.combination();
        boolean broken = trial.seed() == 4 && combination.number() == 2;
        boolean timeout = trial.seed() == 3 && combination.levels().get("words").startsWith("b");
        double time = luck - (combination.levels().get("hunters").equals("4") ? 10 : 0);
        return new Row(
                trial.number(),
                combination.number(),
                combination.configuration(),
                Map.of(),
                trial.seed(),
                broken ? "broken" : timeout ? "timeout" : "success",
                broken ? "Agent 'x' has not returned for 20 s." : "",
                broken ? OptionalDouble.empty() : OptionalDouble.of(timeout ? 120 : time),
                OptionalDouble.of(1),
                "beef",
                broken
                        ? Map.of()
                        : Map.of(
                                "captureTime",
                                timeout ? OptionalDouble.empty() : OptionalDouble.of(time),
                                "error.r-1",
                                OptionalDouble.of(1),
                                "error.r-2",
                                OptionalDouble.of(2)),
                List.of(),
                trial.number() == 5 ? Map.of("hunter-1", "a wheel came off") : Map.of());
    }

    @Test
    void findsTheEffectThatIsThere() {
        MetricSamples times = findings.measurements(TIME);
        Effect effect = findings.effect(MORE_HUNTERS, times);
        assertThat(times.horizon()).hasValue(120);
        assertThat(effect.blocks()).isEqualTo(12);
        assertThat(effect.complete()).isEqualTo(11); // without seed 4; seed 3 counts
        assertThat(effect.difference().orElseThrow().value()).isEqualTo(-10 * 10.5 / 11, within(1.0));
        assertThat(effect.pValue().orElseThrow()).isLessThan(0.001);
        assertThat(findings.effect(OTHER_WORDS, times).pValue().orElseThrow()).isGreaterThan(0.05);
        assertThat(findings.value(findings.rows().getFirst(), ERROR)).hasValue(1.5);
    }

    /// The same study, told by the times of all runs: those that ended before count until then, those that failed
    /// count to the end.
    @Test
    void leavesNoRunOutForNotHavingGotThere() {
        Combination combination = findings.design().combinations().getLast();
        MetricSamples times = findings.measurements(TIME);
        assertThat(times.runs(combination)).isEqualTo(12);
        assertThat(times.used(combination)).isEqualTo(12);
        assertThat(times.reached(combination)).isEqualTo(11);
        assertThat(times.curve(combination).orElseThrow().count()).isEqualTo(12);
        double mean = findings.of(combination).stream()
                .mapToDouble(row -> findings.value(row, TIME).orElse(120))
                .average()
                .orElseThrow();
        assertThat(times.mean(combination).orElseThrow().value()).isEqualTo(mean, within(1e-9));

        MetricSamples failed = new Findings(
                        findings.manifest(),
                        findings.rows().stream().map(ReportTest::failedEarly).toList())
                .measurements(TIME);
        assertThat(failed.mean(combination).orElseThrow().value()).isGreaterThan(mean - 20);
        assertThat(failed.curve(combination).orElseThrow().censored()).isEmpty();
    }

    /// In place of what ran out of time, a run that failed after 7 s.
    private static Row failedEarly(Row row) {
        return row.outcome().equals("timeout")
                ? new Row(
                        row.run(),
                        row.combination(),
                        row.configuration(),
                        row.arguments(),
                        row.seed(),
                        "failure",
                        "",
                        OptionalDouble.of(7),
                        row.wallSeconds(),
                        row.eventHash(),
                        row.metrics(),
                        List.of(),
                        Map.of())
                : row;
    }

    /// Hunters do more with "b": by 10 s and by 40 s, but for seed 3.
    @Test
    void reportsWhatDependsOnSomethingElse() {
        var rows = findings.rows().stream().map(ReportTest::muchMoreWithB).toList();
        var more = new Findings(findings.manifest(), rows);
        Effect effect = more.effect(more.interactions().getFirst(), more.measurements(TIME));
        assertThat(more.interactions()).hasSize(1);
        assertThat(effect.difference().orElseThrow().value()).isEqualTo((-30 * 10 + 10) / 11.0, within(2.0));
        assertThat(Report.html(more)).contains("what it does to captureTime depends on words");
    }

    private static Row muchMoreWithB(Row row) {
        OptionalDouble time = row.metrics().getOrDefault("captureTime", OptionalDouble.empty());
        boolean much = row.combination() == 4 && time.isPresent();
        return new Row(
                row.run(),
                row.combination(),
                row.configuration(),
                row.arguments(),
                row.seed(),
                row.outcome(),
                "",
                row.simulatedSeconds(),
                row.wallSeconds(),
                row.eventHash(),
                much ? Map.of("captureTime", OptionalDouble.of(time.getAsDouble() - 30)) : row.metrics(),
                List.of(),
                Map.of());
    }

    /// With "b", seed 3 has no time left whatever the hunters: one seed of twelve.
    @Test
    void reportsWhatAChangeDoesToHowRunsEnd() {
        Effect effect = findings.effectOnShare(OTHER_WORDS, "timeout");
        assertThat(effect.complete()).isEqualTo(12);
        assertThat(effect.difference().orElseThrow().value()).isEqualTo(100 / 12.0, within(1e-9));
        assertThat(effect.pValue().orElseThrow()).isGreaterThan(0.05);
        assertThat(findings.effectOnShare(MORE_HUNTERS, "timeout")
                        .difference()
                        .orElseThrow()
                        .value())
                .isZero();
        assertThat(Report.html(findings))
                .contains("Differences in shares of outcomes")
                .contains(NumberFormats.signed(100 / 12.0));
    }

    @Test
    void carriesAllThatItNeedsAndNothingThatIsNotEscaped() throws Exception {
        Path page = folder.resolve("report.html");
        List<Path> written = Report.write(findings, folder, page, Print.COLUMN).files();
        String html = Files.readString(page);
        assertThat(html)
                .contains("Hunters &amp; &lt;prey&gt;", "words=b &amp; &lt;b&gt;", "&lt;script&gt;")
                .doesNotContain("<script", "src=", "href=", "url(", "@import", "http://", "https://");
        assertThat(html)
                .contains("<b>hunters 2 → 4</b>", "): better", "12 seeds (1 to 12)")
                .contains(
                        "captureTime: in 2 of 48 runs it did not happen", "at most 120 s", "1 runs broke".substring(2))
                .contains("error: 1 of 48 runs have no value".substring(7), "11 of 12 seeds")
                .contains("Agent 'x' has not returned", "Agent 'hunter-1' failed: a wheel came off")
                .contains("rsal run &#39;my hunt".replace("&#39;", "'"), "--set prey=1 --set hunters=2", "--seed 4")
                .contains("2026-03-04 05:06:07 UTC", "Java 25", "rsal 9", "2 cores");
        assertThat(html.split("<svg", -1).length - 1).isEqualTo(5);
        assertThat(html.split("role=\"img\" aria-label=\"", -1).length - 1).isEqualTo(5);
        assertThat(written)
                .hasSize(1 + 4 * 5 + 2 * 8)
                .allSatisfy(file -> assertThat(file).isNotEmptyFile());
    }

    @Test
    void leadsToRecordingsThatAreThere() throws Exception {
        Path sweep = Files.createDirectories(folder.resolve("my sweep"));
        Path file = Recordings.file(sweep, 3);
        Files.createDirectories(file.getParent());
        Files.createFile(file);
        Path page = Files.createDirectories(folder.resolve("pages")).resolve("report.html");
        Report.write(findings, sweep, page, Print.COLUMN);
        assertThat(Files.readString(page))
                .contains("1 recorded run<", "<a href=\"../my%20sweep/recordings/3.mcap\">3</a>")
                .doesNotContain("recordings/4.mcap");
        assertThat(Report.html(findings)).doesNotContain("Recordings");
    }

    @Test
    void eachFigureIsThereAsNumbersAndAsAPicture() throws Exception {
        Report.write(findings, folder, folder.resolve("my.report.html"), Print.COLUMN);
        Path figures = folder.resolve("my.report-figures");
        assertThat(Files.readAllLines(figures.resolve("outcomes.csv")))
                .startsWith("combination,outcome,count,runs,share,low95,high95")
                .anyMatch(line -> line.startsWith("\"hunters=2, words=a\",success,12,12,1.0,"));
        List<String> effects = Files.readAllLines(figures.resolve("capturetime-effects.csv"));
        assertThat(effects).hasSize(3);
        assertThat(effects.get(1)).startsWith("hunters,2,4,11,12,-");
        assertThat(ImageIO.read(figures.resolve("capturetime.png").toFile()).getWidth())
                .isEqualTo((int) (2 * ReportFigure.WIDTH));
    }

    @Test
    void tablesAreThereForProgramsAndPapers() throws Exception {
        Report.write(findings, folder, folder.resolve("report.html"), Print.COLUMN);
        Path tables = folder.resolve("report-tables");
        assertThat(Files.readAllLines(tables.resolve("capturetime.csv")))
                .hasSize(5)
                .startsWith("combination,runs,n,happened,horizon,mean,low95,high95,deviation,median")
                .anyMatch(line -> line.startsWith("\"hunters=4, words=b & <b>\",12,12,11,120.0,"));
        assertThat(Files.readAllLines(tables.resolve("capturetime-effects.csv")).getFirst())
                .isEqualTo("factor,from,to,seeds,ofSeeds,difference,low95,high95,p,pHolm,dz");
        assertThat(tables.resolve("capturetime-interactions.csv")).isNotEmptyFile();
        assertThat(tables.resolve("capturetime-effects.tex"))
                .content()
                .contains(
                        "\\begin{tabular}{lrrrrrr}",
                        "\\toprule",
                        "hunters 2 $\\rightarrow$ 4 & 11 of 12 & $-$",
                        "\\bottomrule")
                .contains("words a $\\rightarrow$ b \\& $<$b$>$ & ");
    }

    @Test
    void figuresForPapersHaveTheirSizeAndFont() throws Exception {
        var print = new Print(60, "serif", 7);
        Report.write(findings, folder, folder.resolve("report.html"), print);
        Path figures = folder.resolve("report-figures");
        assertThat(figures.resolve("capturetime.svg"))
                .content()
                .contains("width=\"60mm\"", "font-family=\"serif\"", "stroke=\"#0072b2\"")
                .doesNotContain("class=");
        try (PDDocument document = Loader.loadPDF(figures.resolve("error.pdf").toFile())) {
            var sheet = document.getPage(0);
            assertThat(document.getNumberOfPages()).isEqualTo(1);
            assertThat((double) sheet.getMediaBox().getWidth()).isEqualTo(60 * 72 / 25.4, within(0.1));
            assertThat(sheet.getResources().getFontNames()).isEmpty(); // letters are outlines
        }
        byte[] first = Files.readAllBytes(figures.resolve("error.pdf"));
        Report.write(findings, folder, folder.resolve("report.html"), print);
        assertThat(Files.readAllBytes(figures.resolve("error.pdf"))).isEqualTo(first);
    }

    @Test
    void figuresForPapersAreNotMadeWithoutAFontOrSize() {
        assertThatIllegalArgumentException()
                .isThrownBy(() -> new Print(60, "No Such Font", 8))
                .withMessageContaining("'No Such Font' is not installed");
        assertThatIllegalArgumentException().isThrownBy(() -> new Print(0, "serif", 8));
        assertThatIllegalArgumentException().isThrownBy(() -> new Print(88, "serif", Double.NaN));
    }

    @Test
    void anUnfinishedSweepSaysSo() throws Exception {
        Path page = folder.resolve("report.html");
        Report.write(new Findings(findings.manifest(), findings.rows().subList(0, 6)), folder, page, Print.COLUMN);
        assertThat(Files.readString(page)).contains("only 6 have ended so far");
        Report.write(new Findings(findings.manifest(), List.of()), folder, page, Print.COLUMN);
        assertThat(Files.readString(page)).contains("No run has ended yet");
    }
}
