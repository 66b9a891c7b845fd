package rsal.cli.grade;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.stream.Stream;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Parameters;
import rsal.cli.show.ScenarioReference;
import rsal.cli.terminal.Exit;
import rsal.cli.terminal.FileName;
import rsal.cli.terminal.Subcommand;
import rsal.cli.terminal.TextTable;
import rsal.cli.terminal.Unreachable;
import rsal.scenario.RunOptions;

/// `rsal test-agent`
@Command(
        name = "test-agent",
        description =
                "Test your own agents: run their scenario with several seeds, each in a separate process with limits"
                        + " of time and memory. The exit code is 0 when each run is a success, otherwise 4.")
public final class TestAgentCommand extends Subcommand {
    @Parameters(
            converter = FileName.class,
            paramLabel = "SCENARIO[:CONFIGURATION]",
            description = ScenarioReference.WHAT + ".")
    private String scenario = "";

    @Mixin
    private Limits limits = new Limits();

    @Override
    protected int run() throws InterruptedException {
        limits.check(spec.commandLine());
        ScenarioReference reference = ScenarioReference.parse(scenario);
        reference
                .load()
                .plan(reference
                        .configuration()
                        .map(RunOptions.NONE::withConfiguration)
                        .orElse(RunOptions.NONE)); // tells errors once
        try {
            Path logs = Files.createTempDirectory("rsal-test-agent-");
            SeparateRun run = limits.run(Path.of("").toAbsolutePath(), scenario, logs);
            var ended = new AtomicInteger();
            SeededTrials.Trial trial = new SeededTrials(limits)
                    .all(Map.of(scenario, run), result -> print(result, ended.incrementAndGet()), _ -> {})
                    .getFirst();
            print(trial, logs);
            boolean success = trial.successes() == trial.results().size();
            if (success && !json) {
                delete(logs);
            }
            return success ? Exit.SUCCESS : Exit.NO_SUCCESS;
        } catch (IOException e) {
            throw new Unreachable("Runs can't be started: %s.".formatted(e));
        }
    }

    /// Progress, as some runs take long.
    private void print(SeparateRun.Result result, int ended) {
        err().println("%d of %d: seed %d, %s"
                .formatted(ended, limits.seeds.seeds().size(), result.seed(), result.outcome()));
        err().flush();
    }

    private void print(SeededTrials.Trial trial, Path logs) {
        if (json) {
            printJson(Map.of("scenario", scenario, "runs", trial.results(), "logs", logs.toString()));
            return;
        }
        var table = new TextTable("").row("seed", "outcome", "time [s]", "");
        List<SeparateRun.Result> results = trial.results();
        results.forEach(result -> table.row(
                Long.toString(result.seed()),
                result.outcome(),
                String.format(Locale.ROOT, "%.1f", result.simulatedSeconds()),
                result.message()));
        out().print(table);
        out().println("%d of %d runs ended in success.".formatted(trial.successes(), results.size()));
        if (trial.successes() < results.size()) {
            out().println("Their reports: %s".formatted(logs));
        }
        out().flush();
    }

    /// Nobody reads what runs told that ended in success.
    private static void delete(Path logs) throws IOException {
        try (Stream<Path> files = Files.list(logs)) {
            for (Path file : files.toList()) {
                Files.delete(file);
            }
        }
        Files.delete(logs);
    }
}
