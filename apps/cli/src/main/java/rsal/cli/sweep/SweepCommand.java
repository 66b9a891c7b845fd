package rsal.cli.sweep;

import java.io.UncheckedIOException;
import java.nio.file.Path;
import java.time.Duration;
import java.time.Instant;
import java.time.temporal.ChronoUnit;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.jspecify.annotations.Nullable;
import picocli.CommandLine.Command;
import picocli.CommandLine.ITypeConverter;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.TypeConversionException;
import rsal.cli.run.RunChoices;
import rsal.cli.run.RunCommand;
import rsal.cli.show.ScenarioReference;
import rsal.cli.terminal.ClosedAtExit;
import rsal.cli.terminal.Destination;
import rsal.cli.terminal.Exit;
import rsal.cli.terminal.FileError;
import rsal.cli.terminal.FileName;
import rsal.cli.terminal.Logging;
import rsal.cli.terminal.Subcommand;
import rsal.cli.terminal.Unreachable;
import rsal.experiment.Design;
import rsal.experiment.Factor;
import rsal.experiment.Findings;
import rsal.experiment.Manifest;
import rsal.experiment.Recordings;
import rsal.experiment.Row;
import rsal.experiment.SeedRange;
import rsal.experiment.Sweep;
import rsal.experiment.SweepFolder;
import rsal.experiment.SweepRun;
import rsal.scenario.Scenario;
import rsal.settings.InvalidSettings;
import rsal.settings.Problem;
import rsal.time.AllowedToReadWallClock;

/// `rsal sweep`
@Command(
        name = "sweep",
        description = {
            "Run a scenario with every combination of configurations and arguments, each with the same seeds, and"
                    + " write a row for each run. 'rsal report' shows the results.",
            "Several runs execute at once, as fast as possible. Each has the same result as 'rsal run' with its seed."
        })
@AllowedToReadWallClock("Notes when a sweep was made.")
public final class SweepCommand extends Subcommand {
    private static final int SEEDS = 10; // when nothing is said

    @Parameters(
            converter = FileName.class,
            paramLabel = "SCENARIO[:CONFIGURATION]",
            description = ScenarioReference.WHAT + ".")
    private String scenario = "";

    @Option(
            names = "--configuration",
            paramLabel = "NAME",
            split = ",",
            description = "Configurations to compare, such as virtual,advanced. Default: the first.")
    private List<String> configurations = List.of();

    @Option(
            names = "--vary",
            paramLabel = "NAME=VALUES",
            converter = RunChoices.Setting.Converter.class,
            description = "Run with several values of an argument: 1,2,4; for numbers also 1:10:3, which is 1,4,7,10."
                    + " May be repeated: all combinations are run.")
    private List<RunChoices.Setting> varied = List.of();

    @Option(
            names = "--set",
            paramLabel = "NAME=VALUE",
            converter = RunChoices.Setting.Converter.class,
            description = "Set an argument for all runs. May be repeated.")
    private List<RunChoices.Setting> settings = List.of();

    @Option(
            names = "--repeat",
            paramLabel = "N",
            description = "Run each combination with the seeds 1 to N. Default: " + SEEDS + ".")
    private @Nullable Integer repeat;

    @Option(
            names = "--seeds",
            paramLabel = "A:B",
            converter = Seeds.class,
            description = "Run each combination with the seeds A to B, such as 101:120 or 101-120. A single number N is"
                    + " 1 to N, as with --repeat.")
    private @Nullable SeedRange seeds;

    @Option(names = "--jobs", paramLabel = "N", description = "Number of runs at once. Default: the number of cores.")
    private int jobs = Runtime.getRuntime().availableProcessors();

    @Option(
            names = "--for",
            paramLabel = "SECONDS",
            converter = RunCommand.Seconds.class,
            description = "End each run after this number of simulated seconds.")
    private @Nullable Duration limit;

    @Option(
            names = "--resume",
            description = "Resume an interrupted sweep: give the same command again, with this option.")
    private boolean resume;

    @Option(
            names = "--record",
            description =
                    "Record each run to DIR/recordings/RUN.mcap. 'rsal replay' shows it, and the report links to it.")
    private boolean record;

    @Option(
            names = "--out",
            paramLabel = "DIR",
            required = true,
            description = "Folder for the rows. It is made if it does not exist.")
    private String out = "";

    @Override
    protected int run() throws Exception {
        check(jobs >= 1, "--jobs must be at least 1, not '%d'.".formatted(jobs));
        check(repeat == null || repeat >= 1, "--repeat must be at least 1, not '%d'.".formatted(repeat));
        check(repeat == null || seeds == null, "Use either --repeat or --seeds.");
        ScenarioReference reference = ScenarioReference.parse(scenario);
        check(
                reference.configuration().isEmpty() || configurations.isEmpty(),
                "Use either SCENARIO:CONFIGURATION or --configuration.");
        Scenario loaded = reference.load();
        Sweep sweep = Sweep.of(loaded, design(loaded, reference.configuration()));
        printNotes(sweep);
        Path folder = Destination.path(out);
        try (SweepFolder opened = open(folder, sweep, reference.nameOrFile())) {
            runAll(sweep, opened, record ? new SweepRecordings(folder, String.join(" ", command())) : Recordings.NONE);
        } catch (UncheckedIOException e) {
            throw unwritable(folder, e);
        }
        Findings findings = Findings.read(folder);
        if (json) {
            printJson(SweepSummary.of(findings, folder).json());
        } else {
            out().print(SweepSummary.of(findings, folder).text());
            out().flush();
        }
        return exit(findings.rows());
    }

    public static int exit(List<Row> rows) {
        return rows.stream().anyMatch(row -> row.isBroken() || row.failedByAgents()) ? Exit.NO_SUCCESS : Exit.SUCCESS;
    }

    private void runAll(Sweep sweep, SweepFolder opened, Recordings recordings) throws InterruptedException {
        int cores = Runtime.getRuntime().availableProcessors();
        Logging.begin();
        var progress = new SweepProgress(err(), sweep.trials().size());
        try (var runs = new SweepRun(sweep, opened, jobs, cores, recordings, progress::ended)) {
            var ending = new ClosedAtExit(() -> breakOff(runs, progress));
            if (resume && runs.left() > 0) {
                runs.checkRepeatable();
                ending.checkNoSignal();
            }
            progress.begin(opened.rows(), jobs);
            try {
                runs.run();
            } finally {
                ending.checkNoSignal();
                progress.end();
            }
        }
    }

    private void breakOff(SweepRun runs, SweepProgress progress) {
        runs.close();
        progress.interrupted(out);
    }

    /// As it was typed.
    private List<String> command() {
        var command = new ArrayList<>(List.of(spec.root().name()));
        command.addAll(spec.root().commandLine().getParseResult().originalArgs());
        return command;
    }

    private SweepFolder open(Path folder, Sweep sweep, String named) {
        var session = new Manifest.Session(
                Instant.now().truncatedTo(ChronoUnit.SECONDS).toString(),
                named,
                command(),
                jobs,
                Manifest.Machine.here(spec.root().version()[0]));
        return resume ? SweepFolder.resume(folder, sweep, session) : SweepFolder.create(folder, sweep, session);
    }

    private static Unreachable unwritable(Path folder, UncheckedIOException e) {
        return new Unreachable("The sweep can't be written to '%s': %s. Existing rows are kept; continue by --resume."
                .formatted(folder, e.getMessage()));
    }

    private Design design(Scenario loaded, Optional<String> configuration) {
        List<String> compared = configurations.isEmpty()
                ? List.of(configuration.orElseGet(
                        () -> loaded.configurations().getFirst().name()))
                : configurations;
        return new Design(compared, factors(loaded), fixed(), seeds(), Optional.ofNullable(limit));
    }

    /// @throws InvalidSettings with the errors of all of them
    private List<Factor> factors(Scenario loaded) {
        var factors = new ArrayList<Factor>();
        var errors = new ArrayList<Problem>();
        for (RunChoices.Setting each : varied) {
            try {
                factors.add(Factor.read(each.name(), each.value(), loaded.arguments()));
            } catch (InvalidSettings e) {
                errors.addAll(e.problems());
            }
        }
        if (!errors.isEmpty()) {
            throw new InvalidSettings(errors);
        }
        return factors;
    }

    private Map<String, String> fixed() {
        var fixed = new LinkedHashMap<String, String>();
        settings.forEach(setting -> fixed.put(setting.name(), setting.value()));
        return fixed;
    }

    private List<Long> seeds() {
        SeedRange range = seeds != null ? seeds : new SeedRange(1, repeat != null ? repeat : SEEDS);
        return range.seeds();
    }

    private void printNotes(Sweep sweep) {
        sweep.notes().forEach(note -> err().println(FileError.note(note)));
    }

    /// What `--seeds` says.
    public static final class Seeds implements ITypeConverter<SeedRange> {
        @Override
        public SeedRange convert(String typed) {
            try {
                return SeedRange.parse(typed);
            } catch (IllegalArgumentException e) {
                throw new TypeConversionException(String.valueOf(e.getMessage()));
            }
        }
    }
}
