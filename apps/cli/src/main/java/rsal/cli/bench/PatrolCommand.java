package rsal.cli.bench;

import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.ServiceLoader;
import java.util.stream.Stream;
import picocli.CommandLine.Command;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import rsal.agent.StrategyComparison;
import rsal.cli.terminal.Exit;
import rsal.cli.terminal.Subcommand;
import rsal.cli.terminal.TextTable;
import rsal.settings.FileSource;
import rsal.settings.InvalidSettings;
import rsal.settings.Location;

/// `rsal patrol`
@Command(
        name = "patrol",
        description = "Compare patrol strategies on a .graph file of patrolling_sim, with ideal robots: points on the"
                + " edges that do not disturb each other. The first quarter of the time does not count.")
public final class PatrolCommand extends Subcommand {
    private static final int LARGEST = 4_000_000; // bytes of a file

    @Parameters(paramLabel = "FILE.graph", description = "Places and edges.")
    @SuppressWarnings("NullAway.Init") // picocli fills it in
    private Path file;

    @Option(
            names = "--robots",
            split = ",",
            paramLabel = "N",
            description = "Numbers of robots, from 1 to 50. Default: 2,4,8.")
    private List<Integer> robots = List.of(2, 4, 8);

    @Option(names = "--strategy", split = ",", paramLabel = "KEY", description = "Strategies. Default: all.")
    private List<String> strategies = List.of();

    @Option(names = "--speed", paramLabel = "M/S", description = "Speed of the robots. Default: ${DEFAULT-VALUE}.")
    private double speed = 1;

    @Option(
            names = "--stop",
            paramLabel = "SECONDS",
            description = "Time that a robot loses at each place. Default: ${DEFAULT-VALUE}.")
    private double stop;

    @Option(names = "--seeds", paramLabel = "N", description = "Number of runs, 1 to 100. Default: ${DEFAULT-VALUE}.")
    private int seeds = 3;

    @Option(
            names = "--for",
            paramLabel = "SECONDS",
            description = "Simulated time, 10 to 100000. Default: ${DEFAULT-VALUE}.")
    private double time = 3600;

    @Override
    protected int run() {
        check(
                robots.stream().allMatch(n -> n >= 1 && n <= 50),
                "--robots must be from 1 to 50, not %s.".formatted(robots));
        check(speed >= 0.01 && speed <= 100, "--speed must be from 0.01 to 100 m/s, not %s.".formatted(speed));
        check(stop >= 0 && stop <= 600, "--stop must be from 0 to 600 s, not %s.".formatted(stop));
        check(seeds >= 1 && seeds <= 100, "--seeds must be from 1 to 100, not %d.".formatted(seeds));
        check(time >= 10 && time <= 1e5, "--for must be from 10 to 100000 s, not %s.".formatted(time));
        StrategyComparison comparison = ServiceLoader.load(StrategyComparison.class).stream()
                .map(ServiceLoader.Provider::get)
                .filter(found -> found.key().equals("patrol"))
                .findFirst()
                .orElseThrow(() -> new IllegalStateException("No comparison of patrol strategies is installed."));
        List<String> known = comparison.strategies();
        strategies.forEach(key -> check(
                known.contains(key),
                "--strategy: there is no strategy '%s'. Known are: %s.".formatted(key, String.join(", ", known))));
        var team = new StrategyComparison.Team(robots, speed, stop, seeds, time);
        List<StrategyComparison.Row> rows = rows(comparison, strategies.isEmpty() ? known : strategies, team);
        if (json) {
            printJson(Map.of("rows", rows));
            return Exit.SUCCESS;
        }
        var table = new TextTable("");
        table.row(cells(
                "robots",
                "strategy",
                rows.getFirst().means().keySet().stream()
                        .map(metric -> "%s [%s]".formatted(metric, comparison.unit()))));
        rows.forEach(row -> table.row(cells(
                String.valueOf(row.robots()),
                row.strategy(),
                row.means().values().stream().map(PatrolCommand::number))));
        out().print(table);
        out().flush();
        return Exit.SUCCESS;
    }

    private static String[] cells(String robots, String strategy, Stream<String> means) {
        return Stream.concat(Stream.of(robots, strategy), means).toArray(String[]::new);
    }

    private static String number(double seconds) {
        return String.format(Locale.ROOT, "%.1f", seconds);
    }

    private List<StrategyComparison.Row> rows(
            StrategyComparison comparison, List<String> keys, StrategyComparison.Team team) {
        var location = Location.of(file.toString());
        String text = FileSource.disk().text(file.toString(), LARGEST, location);
        try {
            return comparison.compare(text, keys, team);
        } catch (IllegalArgumentException e) {
            throw new InvalidSettings(location, String.valueOf(e.getMessage()), "");
        }
    }
}
