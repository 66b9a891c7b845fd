package rsal.cli.grade;

import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import org.jspecify.annotations.Nullable;
import picocli.CommandLine;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParameterException;
import rsal.cli.run.RunCommand;
import rsal.cli.start.OwnProgram;
import rsal.cli.sweep.SweepCommand;
import rsal.experiment.SeedRange;

/// With which seeds and within which bounds agents are tried, as options.
final class Limits {
    private static final int LEAST_MEMORY = 64; // MB

    @Option(
            names = "--seeds",
            paramLabel = "A:B",
            converter = SweepCommand.Seeds.class,
            description =
                    "Run with the seeds A to B, such as 1:20 or 1-20. A single number N is 1 to N. Default: 1:10.")
    SeedRange seeds = new SeedRange(1, 10);

    @Option(
            names = "--time",
            paramLabel = "SECONDS",
            converter = RunCommand.Seconds.class,
            description = "End a run that takes longer than this number of real seconds. Default: 120.")
    Duration longest = Duration.ofMinutes(2);

    @Option(
            names = "--memory",
            paramLabel = "MB",
            description = "Maximum heap of a run, in megabytes. Default: ${DEFAULT-VALUE}.",
            defaultValue = "512")
    int megabytes = 512;

    @Option(names = "--jobs", paramLabel = "N", description = "Number of runs at once. Default: the number of cores.")
    int jobs = Runtime.getRuntime().availableProcessors();

    @Option(
            names = "--for",
            paramLabel = "SECONDS",
            description = "End each run after this number of simulated seconds.")
    private @Nullable String simulated;

    /// @throws ParameterException unless all are right
    void check(CommandLine line) {
        if (jobs < 1) {
            throw new ParameterException(line, "--jobs must be at least 1, not '%d'.".formatted(jobs));
        }
        if (megabytes < LEAST_MEMORY) {
            throw new ParameterException(
                    line, "--memory must be at least %d, not '%d'.".formatted(LEAST_MEMORY, megabytes));
        }
    }

    /// Of this process's options, those that a run has, too. It has its own bound, shows no page, and makes no cache.
    private static boolean isForRuns(String option) {
        return !option.startsWith("-Xmx") && !option.startsWith("-Drsal.page=") && !option.startsWith("-Drsal.cache=");
    }

    SeparateRun run(Path folder, String scenario, Path logs) {
        return new SeparateRun(
                OwnProgram.command(Limits::isForRuns, List.of("-Xmx%dm".formatted(megabytes))),
                folder,
                scenario,
                logs,
                longest,
                simulated == null ? List.of() : List.of("--for", simulated));
    }
}
