package rsal.cli.bench;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.ServiceLoader;
import java.util.SplittableRandom;
import java.util.TreeMap;
import picocli.CommandLine.Command;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import rsal.agents.patrol.strategy.GraphFile;
import rsal.agents.patrol.strategy.IdealPatrol;
import rsal.agents.patrol.strategy.PatrolGraph;
import rsal.agents.patrol.strategy.PatrolStrategyType;
import rsal.agents.patrol.strategy.VisitGaps;
import rsal.cli.terminal.Exit;
import rsal.cli.terminal.Subcommand;
import rsal.cli.terminal.TextTable;
import rsal.settings.Arguments;
import rsal.settings.InvalidSettings;
import rsal.settings.Location;

/// `rsal patrol`
@Command(
        name = "patrol",
        description = "Compare patrol strategies on a .graph file of patrolling_sim, with ideal robots: points on the"
                + " edges that do not disturb each other. The first quarter of the time does not count.")
public final class PatrolCommand extends Subcommand {
    private static final long LARGEST = 4_000_000; // bytes of a file

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

    /// Means over the seeds, in s.
    record Row(int robots, String strategy, double meanIdleness, double visitGap, double worst, double deviation) {}

    @Override
    protected int run() {
        check(
                robots.stream().allMatch(n -> n >= 1 && n <= 50),
                "--robots must be from 1 to 50, not %s.".formatted(robots));
        check(speed >= 0.01 && speed <= 100, "--speed must be from 0.01 to 100 m/s, not %s.".formatted(speed));
        check(stop >= 0 && stop <= 600, "--stop must be from 0 to 600 s, not %s.".formatted(stop));
        check(seeds >= 1 && seeds <= 100, "--seeds must be from 1 to 100, not %d.".formatted(seeds));
        check(time >= 10 && time <= 1e5, "--for must be from 10 to 100000 s, not %s.".formatted(time));
        var types = new TreeMap<String, PatrolStrategyType>();
        ServiceLoader.load(PatrolStrategyType.class).forEach(type -> types.put(type.key(), type));
        strategies.forEach(key -> check(
                types.containsKey(key),
                "--strategy: there is no strategy '%s'. Known are: %s."
                        .formatted(key, String.join(", ", types.keySet()))));
        PatrolGraph graph = read().graph(speed, stop);
        var rows = new ArrayList<Row>();
        for (int team : robots) {
            types.forEach((key, type) -> {
                if (strategies.isEmpty() || strategies.contains(key)) {
                    rows.add(row(graph, team, type));
                }
            });
        }
        if (json) {
            printJson(Map.of("places", graph.size(), "rows", rows));
            return Exit.SUCCESS;
        }
        var table = new TextTable("");
        table.row("robots", "strategy", "meanIdleness [s]", "visitGap [s]", "worst [s]", "visitGapDeviation [s]");
        rows.forEach(row -> table.row(
                String.valueOf(row.robots),
                row.strategy,
                number(row.meanIdleness),
                number(row.visitGap),
                number(row.worst),
                number(row.deviation)));
        out().print(table);
        out().flush();
        return Exit.SUCCESS;
    }

    private static String number(double seconds) {
        return String.format(Locale.ROOT, "%.1f", seconds);
    }

    private Row row(PatrolGraph graph, int team, PatrolStrategyType type) {
        double idleness = 0;
        double gap = 0;
        double worst = 0;
        double deviation = 0;
        for (int seed = 1; seed <= seeds; seed++) {
            int[] starts =
                    new SplittableRandom(seed).ints(team, 0, graph.size()).toArray();
            VisitGaps gaps = IdealPatrol.run(
                    graph,
                    () -> type.create(Arguments.defaults(type.parameters())),
                    starts,
                    List.of(),
                    seed,
                    time / 4,
                    time);
            idleness += gaps.meanIdleness(time) / seeds;
            gap += gaps.meanGap(time) / seeds;
            worst += gaps.worst(time) / seeds;
            deviation += gaps.deviation(time) / seeds;
        }
        return new Row(team, type.key(), idleness, gap, worst, deviation);
    }

    private GraphFile read() {
        var location = Location.of(file.toString());
        try {
            if (Files.size(file) > LARGEST) {
                throw new InvalidSettings(location, "This file is too large for a graph.", "");
            }
            return GraphFile.read(Files.readString(file));
        } catch (NoSuchFileException _) {
            throw new InvalidSettings(location, "There is no file '%s'.".formatted(file), "");
        } catch (IOException e) {
            throw new InvalidSettings(location, "This file can't be read: %s.".formatted(e), "");
        } catch (IllegalArgumentException e) {
            throw new InvalidSettings(location, String.valueOf(e.getMessage()), "");
        }
    }
}
