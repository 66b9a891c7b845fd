package rsal.cli.bench;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.Set;
import java.util.stream.Collectors;
import picocli.CommandLine.Command;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.Parameters;
import rsal.bench.Area;
import rsal.bench.measurement.BenchmarkRequest;
import rsal.bench.measurement.Plot;
import rsal.bench.measurement.Result;
import rsal.cli.terminal.Destination;
import rsal.cli.terminal.Exit;
import rsal.cli.terminal.Subcommand;
import rsal.cli.terminal.TextTable;
import rsal.cli.terminal.Unreachable;
import rsal.settings.InvalidSettings;
import rsal.settings.Location;
import rsal.settings.Suggestion;

/// `rsal bench`
@Command(
        name = "bench",
        description = "Measure the speed of RSAL on this machine. Do not use the machine for other work during this"
                + " time. An area takes minutes, some areas take hours.")
public final class BenchCommand extends Subcommand {
    @Parameters(paramLabel = "AREA", arity = "0..1", description = "The area to measure. Default: list the areas.")
    private Optional<String> area = Optional.empty();

    @Option(
            names = "--only",
            paramLabel = "TEXT",
            description = "Measure only benchmarks with this text in their name, such as laser180.1000.core1.")
    private String only = "";

    @Option(
            names = "--repeat",
            paramLabel = "N",
            description = {
                "Number of measurements of each benchmark: " + BenchmarkRequest.REPEATS + " by default, of which the"
                        + " median counts.",
                "For compared runs, the number of seeds: " + BenchmarkRequest.SEEDS + " by default, of which the mean"
                        + " counts."
            })
    private Optional<Integer> repeats = Optional.empty();

    @Option(
            names = "--episodes",
            paramLabel = "N",
            description = "Number of episodes after which area python compares the memory in use: "
                    + BenchmarkRequest.EPISODES + " by default.")
    private int episodes = BenchmarkRequest.EPISODES;

    @Option(
            names = "--data",
            paramLabel = "DIR",
            description = {
                "Folder of public data, with the folders logs, maps and barn. Default: the folder that RSAL_DATA"
                        + " names.",
                "Without either, benchmarks that need the data are skipped."
            })
    private Optional<Path> data = Optional.empty();

    @Option(
            names = "--page",
            paramLabel = "FILE.html",
            description = "Also write the results with plots to a page in one file, which needs no network.")
    private Optional<Path> page = Optional.empty();

    /// On which machine.
    record Machine(String java, String system, int cores) {
        @Override
        public String toString() {
            return "Java %s, %s, %d cores".formatted(java, system, cores);
        }
    }

    @Override
    protected int run() {
        OptionalInt often = repeats.stream().mapToInt(Integer::intValue).findFirst();
        often.ifPresent(times -> check(times >= 1, "--repeat must be at least 1, not '%d'.".formatted(times)));
        check(episodes >= 2, "--episodes must be at least 2, not '%d'.".formatted(episodes));
        if (area.isEmpty()) {
            Area.all().forEach(a -> out().println(a.name()));
            out().flush();
            return Exit.SUCCESS;
        }
        Area chosen = chosen(area.get());
        List<String> wanted =
                chosen.names().stream().filter(name -> name.contains(only)).toList();
        if (wanted.isEmpty()) {
            throw new ParameterException(
                    spec.commandLine(),
                    "Nothing in area '%s' has '%s' in its name. Names begin with %s."
                            .formatted(chosen.name(), only, String.join(", ", beginnings(chosen))));
        }
        Optional<Path> publicData = publicData();
        Optional<BenchPage> report = page.map(BenchPage::at);
        var results = new ArrayList<Result>();
        var progress = new BenchProgress(err(), wanted.size());
        var plots = new ArrayList<Plot>();
        List<String> failures = chosen.measure(new BenchmarkRequest(
                Set.copyOf(wanted),
                often,
                episodes,
                publicData,
                result -> {
                    results.add(result);
                    progress.measured(text(result));
                },
                plots::add,
                err()::println,
                progress::reached));
        progress.end();
        failures.forEach(err()::println);
        if (results.isEmpty() && failures.isEmpty()) {
            throw new Unreachable("Nothing was measured, since the data is missing.");
        }
        var machine = machine();
        report.ifPresent(written -> written.write(chosen.name(), results, plots, machine));
        print(results, machine);
        return failures.isEmpty() ? Exit.SUCCESS : Exit.NO_SUCCESS;
    }

    private Optional<Path> publicData() {
        String variable = System.getenv("RSAL_DATA");
        Optional<Path> named = data.or(
                () -> Optional.ofNullable(variable).filter(v -> !v.isEmpty()).map(Destination::path));
        named.filter(folder -> !Files.isDirectory(folder)).ifPresent(folder -> {
            throw new InvalidSettings(
                    Location.of(data.isPresent() ? "--data" : "RSAL_DATA"),
                    "There is no folder '%s'.".formatted(folder),
                    "It must have the folders logs, maps and barn.");
        });
        return named;
    }

    private static Set<String> beginnings(Area area) {
        return area.names().stream()
                .map(name -> name.substring(0, name.indexOf('.') + 1))
                .collect(Collectors.toCollection(LinkedHashSet::new));
    }

    private Area chosen(String name) {
        return Area.all().stream()
                .filter(a -> a.name().equals(name))
                .findFirst()
                .orElseThrow(() -> new ParameterException(
                        spec.commandLine(),
                        "There is no area '%s'. %s"
                                .formatted(
                                        name,
                                        Suggestion.among(
                                                name,
                                                Area.all().stream()
                                                        .map(Area::name)
                                                        .toList()))));
    }

    private static Machine machine() {
        return new Machine(
                Runtime.version().toString(),
                System.getProperty("os.name") + " " + System.getProperty("os.arch"),
                Runtime.getRuntime().availableProcessors());
    }

    private void print(List<Result> results, Machine machine) {
        if (json) {
            printJson(Map.of("results", results, "machine", machine));
            return;
        }
        var table = new TextTable("");
        for (Result result : results) {
            table.row(
                    result.name(),
                    "%10s %-4s  %s to %s%s"
                            .formatted(
                                    number(result.value()),
                                    result.unit(),
                                    number(result.least()),
                                    number(result.most()),
                                    toReach(result)));
        }
        out().print(table);
        out().println(machine);
        out().flush();
    }

    private static String toReach(Result result) {
        return result.goal().map(goal -> ", to reach: " + number(goal)).orElse("");
    }

    /// `ros2.loss10.delay.p50 0.21 ms, to reach: 100`
    private static String text(Result result) {
        String value = "%s %s".formatted(number(result.value()), result.unit()).strip();
        return "%s %s%s".formatted(result.name(), value, toReach(result));
    }

    /// Three digits that say something.
    static String number(double value) {
        double size = Math.abs(value);
        if (size >= 1e6) {
            return String.format(Locale.ROOT, "%.3g M", value / 1e6);
        }
        return String.format(Locale.ROOT, size >= 100 ? "%.0f" : "%.3g", value);
    }
}
