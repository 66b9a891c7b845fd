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
        description =
                "Measure how fast RSAL is on this machine. Leave it alone meanwhile; an area takes minutes, some take hours.")
public final class BenchCommand extends Subcommand {
    @Parameters(paramLabel = "AREA", arity = "0..1", description = "What to measure. Default: lists the areas.")
    private Optional<String> area = Optional.empty();

    @Option(
            names = "--only",
            paramLabel = "TEXT",
            description = "Measure only what has this in its name, like laser180.1000.core1.")
    private String only = "";

    @Option(
            names = "--repeat",
            paramLabel = "N",
            description = {
                "How often each is measured; " + BenchmarkRequest.REPEATS + " by default. The median counts.",
                "With how many seeds runs are compared; " + BenchmarkRequest.SEEDS + " by default. The mean counts."
            })
    private Optional<Integer> repeats = Optional.empty();

    @Option(
            names = "--data",
            paramLabel = "DIR",
            description = {
                "Folder of public data, with the folders logs, maps and barn. Without it, benchmarks that need them are skipped.",
                "Else the folder that RSAL_DATA names."
            })
    private Optional<Path> data = Optional.empty();

    @Option(
            names = "--page",
            paramLabel = "FILE.html",
            description = "Write the results with plots to a page, too. It can be read anywhere, without a network.")
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
        chosen.measure(new BenchmarkRequest(
                Set.copyOf(wanted),
                often,
                publicData,
                result -> {
                    results.add(result);
                    progress.measured(result.name());
                },
                plots::add,
                err()::println,
                progress::reached));
        progress.end();
        if (results.isEmpty()) {
            throw new Unreachable("Nothing was measured, for want of data.");
        }
        var machine = machine();
        report.ifPresent(written -> written.write(chosen.name(), results, plots, machine));
        print(results, machine);
        return Exit.SUCCESS;
    }

    private Optional<Path> publicData() {
        String variable = System.getenv("RSAL_DATA");
        Optional<Path> named = data.or(
                () -> Optional.ofNullable(variable).filter(v -> !v.isEmpty()).map(Destination::path));
        named.filter(folder -> !Files.isDirectory(folder)).ifPresent(folder -> {
            throw new InvalidSettings(
                    Location.of(data.isPresent() ? "--data" : "RSAL_DATA"),
                    "There is no folder '%s'.".formatted(folder),
                    "It is to have the folders logs, maps and barn.");
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
                    "%10s %-4s  %s to %s"
                            .formatted(
                                    number(result.value()),
                                    result.unit(),
                                    number(result.least()),
                                    number(result.most())));
        }
        out().print(table);
        out().println(machine);
        out().flush();
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
