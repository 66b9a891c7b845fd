package rsal.cli;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import picocli.CommandLine.Command;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.Parameters;
import rsal.bench.Area;
import rsal.bench.Assignment;
import rsal.bench.Plot;
import rsal.bench.Result;
import rsal.settings.Suggestion;

/// `rsal bench`
@Command(
        name = "bench",
        description = "Measure how fast RSAL is on this machine. Leave it alone meanwhile; an area takes minutes.")
final class BenchCommand extends Subcommand {
    @Parameters(paramLabel = "AREA", arity = "0..1", description = "What to measure; left out: lists the areas.")
    private Optional<String> area = Optional.empty();

    @Option(
            names = "--only",
            paramLabel = "TEXT",
            description = "Measure only what has this in its name, like laser180.1000.core1.")
    private String only = "";

    @Option(
            names = "--repeat",
            paramLabel = "N",
            defaultValue = "5",
            description = "How often each is measured; ${DEFAULT-VALUE} when left out. The median counts.")
    private int repeats;

    @Option(
            names = "--data",
            paramLabel = "DIR",
            description = {
                "Where public data is: folders logs, maps, barn. What needs it is left out without.",
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
    int run() {
        if (repeats < 1) {
            throw new ParameterException(
                    spec.commandLine(), "'--repeat' must be at least 1, not (%d).".formatted(repeats));
        }
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
                    "Nothing in area (%s) has (%s) in its name. It has: %s."
                            .formatted(chosen.name(), only, String.join(", ", chosen.names())));
        }
        Optional<BenchPage> report = page.map(BenchPage::at);
        var results = new ArrayList<Result>();
        var plots = new ArrayList<Plot>();
        chosen.measure(new Assignment(
                Set.copyOf(wanted),
                repeats,
                data.or(() -> Optional.ofNullable(System.getenv("RSAL_DATA")).map(Path::of)),
                result -> {
                    results.add(result);
                    err().println("%d/%d %s".formatted(results.size(), wanted.size(), result.name()));
                },
                plots::add,
                err()::println));
        var machine = machine();
        report.ifPresent(written -> written.write(chosen.name(), results, plots, machine));
        print(results, machine);
        return Exit.SUCCESS;
    }

    private Area chosen(String name) {
        return Area.all().stream()
                .filter(a -> a.name().equals(name))
                .findFirst()
                .orElseThrow(() -> new ParameterException(
                        spec.commandLine(),
                        "There is no area (%s). %s"
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
        var table = new Table("");
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
        if (value >= 1e6) {
            return String.format(Locale.ROOT, "%.3g M", value / 1e6);
        }
        return String.format(Locale.ROOT, value >= 100 ? "%.0f" : "%.3g", value);
    }
}
