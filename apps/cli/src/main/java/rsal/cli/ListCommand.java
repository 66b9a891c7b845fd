package rsal.cli;

import java.util.Comparator;
import java.util.List;
import java.util.Map;
import java.util.ServiceLoader;
import java.util.function.Function;
import picocli.CommandLine.Command;
import picocli.CommandLine.Parameters;
import rsal.agent.AgentHostProvider;
import rsal.agent.AgentType;
import rsal.map.Maps;
import rsal.robot.DeviceDriver;
import rsal.robot.RobotModels;
import rsal.robot.RobotSystemProvider;
import rsal.scenario.Scenario;

/// `rsal list`
@Command(name = "list", description = "List the scenarios that come with RSAL, or what scenarios can be made of.")
final class ListCommand extends Subcommand {
    @Parameters(
            paramLabel = "WHAT",
            arity = "0..1",
            defaultValue = "scenarios",
            description = "One of ${COMPLETION-CANDIDATES}; ${DEFAULT-VALUE} when left out.")
    @SuppressWarnings("NullAway.Init") // picocli fills it in
    private Kind what;

    enum Kind {
        scenarios,
        maps,
        models,
        parts,
        agents,
        drivers,
        mas,
        mrs
    }

    record Entry(String name, String description) {}

    @Override
    int run() {
        List<Entry> entries = entries();
        if (json) {
            printJson(Map.of(what.name(), entries));
            return Exit.SUCCESS;
        }
        var table = new Table("");
        entries.forEach(entry -> table.row(entry.name, entry.description));
        out().print(table);
        out().flush();
        return Exit.SUCCESS;
    }

    private List<Entry> entries() {
        return switch (what) {
            case scenarios ->
                Scenario.builtIn().stream()
                        .map(s -> new Entry(s.name(), s.title()))
                        .toList();
            case maps -> named(Maps.builtIn());
            case models -> named(RobotModels.builtIn());
            case parts -> named(RobotModels.builtInParts());
            case agents -> found(AgentType.class, AgentType::key, AgentType::description);
            case drivers ->
                found(
                        DeviceDriver.class,
                        DeviceDriver::key,
                        d -> "makes a " + d.makes().getSimpleName());
            case mas -> found(AgentHostProvider.class, AgentHostProvider::key, _ -> "");
            case mrs -> found(RobotSystemProvider.class, RobotSystemProvider::key, _ -> "");
        };
    }

    private static List<Entry> named(List<String> names) {
        return names.stream().map(name -> new Entry(name, "")).toList();
    }

    private static <P> List<Entry> found(Class<P> type, Function<P, String> key, Function<P, String> description) {
        return ServiceLoader.load(type).stream()
                .map(ServiceLoader.Provider::get)
                .map(p -> new Entry(key.apply(p), description.apply(p)))
                .sorted(Comparator.comparing(Entry::name))
                .toList();
    }
}
