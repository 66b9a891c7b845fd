package rsal.cli.grade;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.LinkOption;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.jspecify.annotations.Nullable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import rsal.cli.terminal.Destination;
import rsal.cli.terminal.Exit;
import rsal.cli.terminal.FileName;
import rsal.cli.terminal.Subcommand;
import rsal.cli.terminal.TextTable;
import rsal.cli.terminal.Unreachable;
import rsal.scenario.text.CsvLine;

/// `rsal grade`
@Command(
        name = "grade",
        description = {
            "Grade the agents of students: run a scenario with the agent of each student, with several seeds. FOLDER"
                    + " has one folder for each student. Each run is a separate process with limits of time and"
                    + " memory.",
            "DIR gets grades.csv with a row for each run, and summary.csv with a row for each student. It also"
                    + " gets a folder for each student, with the files and logs of the runs."
        })
public final class GradeCommand extends Subcommand {
    private static final String ROWS = "grades.csv";
    private static final String SUMMARY = "summary.csv";

    @Parameters(
            converter = FileName.class,
            paramLabel = "FOLDER",
            description = "The folder that has one folder for each student.")
    private String folder = "";

    @Option(
            names = "--scenario",
            converter = FileName.class,
            paramLabel = "FILE.yaml",
            required = true,
            description = "The scenario, in a folder with all files that it needs except the agent.")
    private String scenario = "";

    @Option(
            names = "--agent",
            paramLabel = "FILE",
            description =
                    "The file that each student hands in, such as Hunter.java. Default: the one agent in a file that the"
                            + " scenario names.")
    private @Nullable String agent;

    @Option(names = "--out", paramLabel = "DIR", required = true, description = "Where results are written.")
    private String out = "";

    @Mixin
    private Limits limits = new Limits();

    @Override
    protected int run() throws InterruptedException {
        limits.check(spec.commandLine());
        Path students = Destination.path(folder);
        Destination.require(students);
        check(
                !Destination.path(out)
                        .toAbsolutePath()
                        .normalize()
                        .startsWith(students.toAbsolutePath().normalize()),
                "--out '%s' is in the folder of students, and would be taken for one. Name a folder elsewhere."
                        .formatted(out));
        Exercise exercise = Exercise.of(scenario, agent);
        Destination results = Destination.of(out, List.of(ROWS, SUMMARY), false).prepare();
        try {
            var runs = new LinkedHashMap<String, SeparateRun>();
            var missing = new TreeMap<String, String>();
            for (Path student : studentsIn(students)) {
                String name = name(student);
                Path work = results.resolve(name);
                try {
                    exercise.handIn(student, work);
                    runs.put(name, limits.run(work.toAbsolutePath(), exercise.scenario(), work.toAbsolutePath()));
                } catch (Exercise.Missing e) {
                    missing.put(name, e.getMessage());
                }
            }
            check(!runs.isEmpty() || !missing.isEmpty(), "'%s' has no folder of a student.".formatted(folder));
            List<SeededTrials.Trial> trials = all(new SeededTrials(limits).all(runs, _ -> {}, this::print), missing);
            results.write(Map.of(
                    ROWS, rows(trials).getBytes(StandardCharsets.UTF_8),
                    SUMMARY, summary(trials).getBytes(StandardCharsets.UTF_8)));
            print(trials, results);
            return Exit.SUCCESS;
        } catch (IOException e) {
            throw new Unreachable("'%s' can't be graded: %s.".formatted(folder, e));
        }
    }

    private static List<Path> studentsIn(Path folder) throws IOException {
        try (Stream<Path> all = Files.list(folder)) {
            return all.filter(path -> Files.isDirectory(path, LinkOption.NOFOLLOW_LINKS))
                    .filter(path -> !name(path).startsWith("."))
                    .sorted()
                    .toList();
        }
    }

    private static String name(Path student) {
        return String.valueOf(student.getFileName());
    }

    /// With those who handed in nothing, in the order of names.
    private List<SeededTrials.Trial> all(List<SeededTrials.Trial> tried, Map<String, String> missing) {
        var all = new TreeMap<String, SeededTrials.Trial>();
        tried.forEach(trial -> all.put(trial.who(), trial));
        missing.forEach((who, message) -> all.put(
                who,
                new SeededTrials.Trial(
                        who,
                        limits.seeds.seeds().stream()
                                .map(seed -> SeparateRun.Result.failed(seed, "missing", message))
                                .toList())));
        return List.copyOf(all.values());
    }

    // ── What is told ──────────────────────────────────────────────────────────────────────────────────────────────

    private void print(SeededTrials.Trial trial) {
        err().println("%s: %d of %d"
                .formatted(trial.who(), trial.successes(), trial.results().size()));
        err().flush();
    }

    private static Set<String> metrics(List<SeededTrials.Trial> trials) {
        return trials.stream()
                .flatMap(trial -> trial.results().stream())
                .flatMap(result -> result.metrics().keySet().stream())
                .collect(Collectors.toCollection(LinkedHashSet::new));
    }

    private static String rows(List<SeededTrials.Trial> trials) {
        Set<String> metrics = metrics(trials);
        var csv = new StringBuilder(CsvLine.of(Stream.concat(
                Stream.of("student", "seed", "outcome", "success", "simulatedSeconds", "eventHash", "message"),
                metrics.stream())));
        for (SeededTrials.Trial trial : trials) {
            for (SeparateRun.Result result : trial.results()) {
                csv.append(CsvLine.of(Stream.concat(
                        Stream.of(
                                trial.who(),
                                Long.toString(result.seed()),
                                result.outcome(),
                                Boolean.toString(result.success()),
                                Double.toString(result.simulatedSeconds()),
                                result.eventHash(),
                                result.message()),
                        metrics.stream().map(name -> number(result.metrics().get(name))))));
            }
        }
        return csv.toString();
    }

    private static String summary(List<SeededTrials.Trial> trials) {
        Set<String> metrics = metrics(trials);
        var csv = new StringBuilder(CsvLine.of(Stream.concat(
                Stream.of("student", "runs", "successes"),
                Stream.concat(metrics.stream().map("mean "::concat), Stream.of("message")))));
        for (SeededTrials.Trial trial : trials) {
            csv.append(CsvLine.of(Stream.concat(
                    Stream.of(trial.who(), Integer.toString(trial.results().size()), Long.toString(trial.successes())),
                    Stream.concat(
                            metrics.stream().map(name -> number(trial.mean(name))), Stream.of(trial.firstMessage())))));
        }
        return csv.toString();
    }

    private static String number(@Nullable Double value) {
        return value == null || value.isNaN() ? "" : value.toString();
    }

    private void print(List<SeededTrials.Trial> trials, Destination results) {
        if (json) {
            printJson(Map.of("students", trials, "out", out));
            return;
        }
        var table = new TextTable("").row("student", "success", "");
        trials.forEach(trial -> table.row(
                trial.who(),
                String.format(
                        Locale.ROOT,
                        "%d of %d",
                        trial.successes(),
                        trial.results().size()),
                trial.firstMessage()));
        out().print(table);
        out().println("Rows: %s; a row for each student: %s"
                .formatted(results.resolve(ROWS), results.resolve(SUMMARY)));
        out().flush();
    }
}
