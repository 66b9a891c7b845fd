package rsal.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.OptionalDouble;
import java.util.concurrent.TimeUnit;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import rsal.cli.terminal.Exit;
import rsal.experiment.Findings;
import rsal.experiment.Row;
import rsal.experiment.report.NumberFormats;
import rsal.experiment.statistics.Mean;
import rsal.scenario.text.NumberText;
import rsal.testkit.LongTest;

/// The figures in READMEs of scenarios are what a sweep tells, a row for each seed. The first row is run again here.
/// `-Drsal.update=true` runs all, and writes them again:
///
/// ```
/// <!-- figures: hunt-and-prey:advanced --seeds 1-10 | captureTime -->
/// <!-- end -->
/// ```
class FiguresIT {
    private static final Path SCENARIOS = Path.of("../../runs/scenarios/src/main/resources/rsal/scenarios");
    private static final Pattern FIGURES = Pattern.compile(
            "<!-- figures: (?<sweep>[^|\n]+?) \\| (?<metrics>[^\n]+?) -->\n(?<table>.*?)<!-- end -->", Pattern.DOTALL);
    private static final Pattern SEEDS = Pattern.compile("--seeds (\\d+)-\\d+");
    private static final String NOTHING = "–";
    private static final boolean UPDATE = Boolean.getBoolean("rsal.update");
    private static final int LONGEST = 20; // min, of all seeds

    @TempDir
    Path folder;

    private int sweeps;

    static Stream<Path> readmes() throws IOException {
        List<Path> all = new ArrayList<>();
        try (var files = Files.walk(SCENARIOS)) {
            files.filter(file -> file.endsWith("README.md")).sorted().forEach(all::add);
        }
        all.removeIf(file -> !text(file).contains("<!-- figures: "));
        assertThat(all).isNotEmpty();
        return all.stream();
    }

    private static String text(Path file) {
        try {
            return Files.readString(file).replace("\r\n", "\n");
        } catch (IOException e) {
            throw new AssertionError(e);
        }
    }

    @ParameterizedTest
    @MethodSource("readmes")
    @LongTest
    void areWhatASweepReports(Path readme) throws Exception {
        var written = new StringBuilder();
        Matcher block = FIGURES.matcher(text(readme));
        while (block.find()) {
            String sweep = block.group("sweep");
            List<String> metrics = List.of(block.group("metrics").split(", ", -1));
            if (UPDATE) {
                String table = table(sweep, metrics, rows(sweep));
                block.appendReplacement(
                        written,
                        Matcher.quoteReplacement("<!-- figures: %s | %s -->\n%s<!-- end -->"
                                .formatted(sweep, block.group("metrics"), table)));
            } else {
                String first = SEEDS.matcher(sweep).replaceFirst("--seeds $1-$1");
                String row = line(rows(first).getFirst(), metrics);
                assertThat(block.group("table").lines())
                        .as("'rsal sweep %s'. Write them again: -Dit.test=FiguresIT -Drsal.update=true", first)
                        .contains(row);
            }
        }
        if (UPDATE) {
            Files.writeString(readme, block.appendTail(written).toString());
        }
    }

    /// What came of each run.
    private List<Row> rows(String sweep) throws Exception {
        Path out = folder.resolve("sweep-" + sweeps++);
        List<String> arguments = new ArrayList<>(List.of("sweep"));
        arguments.addAll(List.of(sweep.split(" ", -1)));
        arguments.addAll(List.of("--out", out.toString()));
        Process process = new ProcessBuilder(new Rsal(folder).command(arguments.toArray(String[]::new)))
                .directory(folder.toFile())
                .redirectErrorStream(true)
                .redirectOutput(folder.resolve("out").toFile())
                .start();
        assertThat(process.waitFor(LONGEST, TimeUnit.MINUTES)).as("ends").isTrue();
        assertThat(process.exitValue())
                .as(Files.readString(folder.resolve("out")))
                .isEqualTo(Exit.SUCCESS);
        return Findings.read(out).rows();
    }

    private static String table(String sweep, List<String> metrics, List<Row> rows) {
        var table = new StringBuilder("`rsal sweep %s`\n\n".formatted(sweep));
        table.append("| seed | outcome | %s |\n".formatted(String.join(" | ", metrics)));
        table.append("|---|---|").append("---|".repeat(metrics.size())).append("\n");
        rows.forEach(row -> table.append(line(row, metrics)).append("\n"));
        String means = metrics.stream().map(metric -> mean(metric, rows)).collect(Collectors.joining(" | "));
        return table.append("| mean ± half of its 95 %% interval | | %s |\n".formatted(means))
                .toString();
    }

    private static String line(Row row, List<String> metrics) {
        return metrics.stream()
                .map(metric -> value(row, metric))
                .map(value -> value.isEmpty() ? NOTHING : NumberText.of(value.getAsDouble()))
                .collect(Collectors.joining(" | ", "| %d | %s | ".formatted(row.seed(), row.outcome()), " |"));
    }

    private static OptionalDouble value(Row row, String metric) {
        return row.metrics().getOrDefault(metric, OptionalDouble.empty());
    }

    /// Of what was measured in all runs; else nothing.
    private static String mean(String metric, List<Row> rows) {
        double[] values = rows.stream()
                .flatMapToDouble(row -> value(row, metric).stream())
                .toArray();
        if (values.length < rows.size()) {
            return NOTHING;
        }
        Mean mean = Mean.of(values);
        return mean.interval()
                .map(interval -> NumberFormats.withError(mean.value(), interval.high() - mean.value()))
                .orElse(NOTHING);
    }
}
