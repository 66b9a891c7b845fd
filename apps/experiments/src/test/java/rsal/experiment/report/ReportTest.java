package rsal.experiment.report;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.OptionalDouble;
import java.util.Random;
import java.util.stream.LongStream;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import rsal.experiment.Combination;
import rsal.experiment.Factor;
import rsal.experiment.Findings;
import rsal.experiment.Manifest;
import rsal.experiment.Manifest.Measure;
import rsal.experiment.Recordings;
import rsal.experiment.Row;
import rsal.experiment.Trial;
import rsal.experiment.statistics.Effect;

class ReportTest {
    private static final Measure TIME = new Measure("captureTime", "s", false, "less");
    private static final Measure ERROR = new Measure("error", "m", true, "neither");
    private static final Factor HUNTERS = new Factor("hunters", List.of("2", "4"));
    private static final Factor WORDS = new Factor("words", List.of("a", "b & <b>"));

    @TempDir
    Path folder;

    private Findings findings;

    /// Four hunters are 10 s faster than two, whatever the seed and the words; seed 3 with "b" has no time,
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
        double[] luck = random.doubles(13, 0, 100).toArray();
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
                broken ? "Agent (x) has not returned for 20 s." : "",
                OptionalDouble.of(60),
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
        Effect effect = findings.effect(HUNTERS, "4", TIME);
        assertThat(effect.blocks()).isEqualTo(12);
        assertThat(effect.complete()).isEqualTo(10); // without seeds 3 and 4
        assertThat(effect.difference().orElseThrow().value()).isEqualTo(-10, within(1.0));
        assertThat(effect.isClear()).isTrue();
        assertThat(findings.effect(WORDS, "b & <b>", TIME).isClear()).isFalse();
        assertThat(findings.value(findings.rows().getFirst(), ERROR)).hasValue(1.5);
    }

    /// With "b", seed 3 has no time left whatever the hunters: one seed of twelve.
    @Test
    void tellsWhatAChangeDoesToHowRunsEnd() {
        Effect effect = findings.effectOnShare(WORDS, "b & <b>", "timeout");
        assertThat(effect.complete()).isEqualTo(12);
        assertThat(effect.difference().orElseThrow().value()).isEqualTo(100 / 12.0, within(1e-9));
        assertThat(effect.isClear()).isFalse();
        assertThat(findings.effectOnShare(HUNTERS, "4", "timeout")
                        .difference()
                        .orElseThrow()
                        .value())
                .isZero();
        assertThat(Report.html(findings))
                .contains("Differences in shares of outcomes")
                .contains(Numbers.signed(100 / 12.0));
    }

    @Test
    void carriesAllThatItNeedsAndNothingThatIsNotEscaped() throws Exception {
        Path page = folder.resolve("report.html");
        List<Path> written = Report.write(findings, folder, page);
        String html = Files.readString(page);
        assertThat(html)
                .contains("Hunters &amp; &lt;prey&gt;", "words=b &amp; &lt;b&gt;", "&lt;script&gt;")
                .doesNotContain("<script", "src=", "href=", "url(", "@import", "http://", "https://");
        assertThat(html)
                .contains("<b>hunters 2 → 4</b>", ": better, over 10 seeds".substring(10), "12 seeds (1 to 12)")
                .contains("10 of 12", "11 of 12", "not in these numbers")
                .contains("Agent (x) has not returned", "Agent (hunter-1) failed: a wheel came off")
                .contains("rsal run &#39;my hunt".replace("&#39;", "'"), "--set prey=1 --set hunters=2", "--seed 4")
                .contains("2026-03-04 05:06:07 UTC", "Java 25", "rsal 9", "2 cores");
        assertThat(html.split("<svg", -1).length - 1).isEqualTo(5);
        assertThat(html.split("role=\"img\" aria-label=\"", -1).length - 1).isEqualTo(5);
        assertThat(written)
                .hasSize(1 + 2 * 5)
                .allSatisfy(file -> assertThat(file).isNotEmptyFile());
    }

    @Test
    void leadsToRecordingsThatAreThere() throws Exception {
        Path sweep = Files.createDirectories(folder.resolve("my sweep"));
        Path file = Recordings.file(sweep, 3);
        Files.createDirectories(file.getParent());
        Files.createFile(file);
        Path page = Files.createDirectories(folder.resolve("pages")).resolve("report.html");
        Report.write(findings, sweep, page);
        assertThat(Files.readString(page))
                .contains("1 recorded run<", "<a href=\"../my%20sweep/recordings/3.mcap\">3</a>")
                .doesNotContain("recordings/4.mcap");
        assertThat(Report.html(findings)).doesNotContain("Recordings");
    }

    @Test
    void eachFigureIsThereAsNumbersAndAsAPicture() throws Exception {
        Report.write(findings, folder, folder.resolve("my.report.html"));
        Path figures = folder.resolve("my.report-figures");
        assertThat(Files.readAllLines(figures.resolve("outcomes.csv")))
                .startsWith("combination,outcome,count,runs,share,low95,high95")
                .anyMatch(line -> line.startsWith("\"hunters=2, words=a\",success,12,12,1.0,"));
        List<String> effects = Files.readAllLines(figures.resolve("capturetime-effects.csv"));
        assertThat(effects).hasSize(3);
        assertThat(effects.get(1)).startsWith("hunters,2,4,10,12,-");
        assertThat(ImageIO.read(figures.resolve("capturetime.png").toFile()).getWidth())
                .isEqualTo(2 * Figure.WIDTH);
    }

    @Test
    void anUnfinishedSweepSaysSo() throws Exception {
        Path page = folder.resolve("report.html");
        Report.write(new Findings(findings.manifest(), findings.rows().subList(0, 6)), folder, page);
        assertThat(Files.readString(page)).contains("only 6 have ended so far");
        Report.write(new Findings(findings.manifest(), List.of()), folder, page);
        assertThat(Files.readString(page)).contains("No run has ended yet");
    }
}
