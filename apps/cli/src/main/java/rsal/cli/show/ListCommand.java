package rsal.cli.show;

import java.util.EnumSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.stream.Stream;
import picocli.CommandLine.Command;
import picocli.CommandLine.Parameters;
import rsal.cli.terminal.Exit;
import rsal.cli.terminal.Subcommand;
import rsal.cli.terminal.TextTable;
import rsal.map.Maps;
import rsal.model.RobotModels;
import rsal.scenario.Scenario;
import rsal.scenario.installed.Providers;
import rsal.system.BridgeProvider;

/// `rsal list`
@Command(name = "list", description = "List the scenarios that come with RSAL, or the parts that scenarios can use.")
public final class ListCommand extends Subcommand {
    @Parameters(
            paramLabel = "WHAT",
            arity = "0..1",
            defaultValue = "scenarios",
            description = "One of ${COMPLETION-CANDIDATES}. Default: ${DEFAULT-VALUE}.")
    @SuppressWarnings("NullAway.Init") // picocli fills it in
    private What what;

    public enum What {
        scenarios,
        maps,
        models,
        parts,
        agents,
        drivers,
        deviceKinds,
        controllers,
        planners,
        goalCheckers,
        progressCheckers,
        recoveries,
        trafficRules,
        metrics,
        mas,
        mrs,
        bridges
    }

    private static final Set<What> WITH_MORE = EnumSet.complementOf(EnumSet.of(What.scenarios, What.bridges));

    record Entry(String name, String description) {}

    @Override
    protected int run() {
        List<Entry> entries = entries();
        if (json) {
            printJson(Map.of(what.name(), entries));
            return Exit.SUCCESS;
        }
        var table = new TextTable("");
        entries.forEach(entry -> table.row(entry.name, entry.description));
        out().print(table);
        if (WITH_MORE.contains(what)) {
            out().println("\n'rsal show NAME' shows more.");
        }
        out().flush();
        return Exit.SUCCESS;
    }

    private List<Entry> entries() {
        return switch (what) {
            case scenarios ->
                Scenario.builtIn().stream()
                        .map(s -> new Entry(s.name(), s.title()))
                        .toList();
            case maps ->
                Maps.builtIn().stream()
                        .map(name -> new Entry(
                                name, ShownMap.of(name, ShownMap.find(name)).size()))
                        .toList();
            case models -> named(RobotModels.builtIn());
            case parts -> named(RobotModels.builtInParts());
            case agents -> entries(InstalledKind.agents());
            case drivers -> entries(InstalledKind.drivers());
            case deviceKinds -> entries(InstalledKind.devices());
            case controllers -> entries(InstalledKind.plugins("controller"));
            case planners -> entries(InstalledKind.plugins("planner"));
            case goalCheckers -> entries(InstalledKind.plugins("goalChecker"));
            case progressCheckers -> entries(InstalledKind.plugins("progressChecker"));
            case recoveries -> entries(InstalledKind.plugins("recovery"));
            case trafficRules -> entries(InstalledKind.plugins("traffic"));
            case metrics -> entries(InstalledKind.metrics());
            case mas -> entries(InstalledKind.hosts());
            case mrs -> entries(InstalledKind.systems());
            case bridges ->
                Providers.byKey(BridgeProvider.class, BridgeProvider::key).values().stream()
                        .map(bridge -> new Entry(bridge.key(), bridge.description()))
                        .toList();
        };
    }

    private static List<Entry> named(List<String> names) {
        return names.stream()
                .map(name -> new Entry(name, ShownPart.of(name).orElseThrow().title()))
                .toList();
    }

    private static List<Entry> entries(Stream<InstalledKind> kinds) {
        return kinds.map(kind -> new Entry(kind.name(), kind.description())).toList();
    }
}
