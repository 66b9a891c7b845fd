package rsal.cli.show;

import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Collectors;
import rsal.cli.terminal.TextTable;
import rsal.scenario.Configuration;

/// A scenario as `rsal show` puts it to people.
final class ScenarioText {
    private static final int MOST_TARGETS = 5;

    private ScenarioText() {}

    static String of(ShownScenario shown) {
        var text = new StringBuilder();
        text.append("%s: %s%n".formatted(shown.scenario(), shown.title()));
        text.append("read from %s%n".formatted(shown.file()));
        if (!shown.description().isEmpty()) {
            text.append('\n').append(shown.description().strip()).append('\n');
        }
        section(text, "Configurations", configurations(shown));
        section(
                text,
                "Arguments of %s (--set NAME=VALUE)".formatted(shown.configuration()),
                arguments(shown.arguments()));
        section(text, "World", world(shown.world(), shown.run()));
        section(text, "Robots, with their devices in the order in which these are made", robots(shown.robots()));
        section(text, "Where they start with seed " + shown.run().seed(), starts(shown.robots()));
        String joined =
                shown.with().map(" and those of %s, which joins it"::formatted).orElse("");
        section(text, "Agents" + joined, agents(shown.agents()));
        shown.communication().ifPresent(limits -> section(text, "How agents hear each other", communication(limits)));
        section(text, "What goes wrong", faults(shown.faults()));
        section(text, "Ends when", ends(shown.ends()));
        section(text, "Metrics", metrics(shown.metrics()));
        return text.toString();
    }

    private static void section(StringBuilder text, String heading, TextTable table) {
        if (!table.isEmpty()) {
            text.append('\n').append(heading).append('\n').append(table);
        }
    }

    private static TextTable configurations(ShownScenario shown) {
        var table = new TextTable("  ");
        for (Configuration configuration : shown.configurations()) {
            boolean isShown = configuration.name().equals(shown.configuration());
            table.row(configuration.name(), isShown ? "shown here" : "", configuration.title());
        }
        return table;
    }

    private static TextTable arguments(List<ShownScenario.Argument> arguments) {
        var table = new TextTable("  ");
        arguments.forEach(a -> table.row(a.name(), a.value().toString(), a.expected(), a.description()));
        return table;
    }

    private static TextTable world(ShownScenario.World world, ShownScenario.Run run) {
        return new TextTable("  ")
                .row(
                        "map",
                        String.format(Locale.ROOT, "%s, %.2f m × %.2f m", world.map(), world.width(), world.height()))
                .row("mrs", world.mrs() + ", in steps of " + world.step() + " s")
                .row("mas", world.mas())
                .row("clock", run.clock());
    }

    private static TextTable robots(List<ShownScenario.Role> roles) {
        var table = new TextTable("  ");
        for (var role : roles) {
            table.row(role.role(), role.ids().size() + " × " + role.model(), String.join(", ", role.sensors()));
            String proxy = role.proxy() ? ", with a proxy in the simulated world" : "";
            String overlay = role.overlay() ? ", seeing what is simulated" : "";
            role.mrs().ifPresent(mrs -> table.row("", "mrs: " + mrs, String.join(", ", role.ids()) + proxy + overlay));
            role.devices().forEach(device -> table.row("", device.name() + ": " + device.driver(), made(device)));
        }
        return table;
    }

    private static String made(ShownScenario.Role.Made device) {
        String from = device.needs().isEmpty() ? "" : " from " + String.join(", ", device.needs());
        String options = settings(device.options());
        return device.makes() + from + (options.isEmpty() ? "" : ": " + options);
    }

    private static TextTable starts(List<ShownScenario.Role> roles) {
        var table = new TextTable("  ");
        for (var role : roles) {
            role.starts().forEach(start -> table.row(start.robot(), place(start.pose())));
        }
        return table;
    }

    private static String place(Optional<List<Double>> pose) {
        return pose.map(p -> String.format(Locale.ROOT, "[%.2f, %.2f, %.0f]", p.toArray()))
                .orElse("where the robot system puts it");
    }

    private static TextTable agents(List<ShownScenario.ShownAgent> agents) {
        var table = new TextTable("  ");
        agents.forEach(a ->
                table.row(a.name(), a.type(), a.robot().map(r -> "for " + r).orElse(""), settings(a.arguments())));
        return table;
    }

    private static TextTable communication(ShownScenario.Limits limits) {
        var table = new TextTable("  ");
        limits.range().ifPresent(range -> table.row("range", range + " m"));
        limits.behindWalls().ifPresent(range -> table.row("behind walls", range + " m"));
        double least = limits.delay().getFirst();
        double most = limits.delay().getLast();
        return table.row("loss", String.format(Locale.ROOT, "%.1f %%", 100 * limits.loss()))
                .row("delay", least == most ? most + " s" : least + " to " + most + " s")
                .row(
                        "bandwidth",
                        limits.bandwidth()
                                .map("%s messages/s of each agent"::formatted)
                                .orElse("as much as wanted"));
    }

    private static TextTable faults(List<ShownScenario.Fault> faults) {
        var table = new TextTable("  ");
        faults.forEach(f -> table.row(f.kind(), f.words(), whom(f), when(f)));
        return table;
    }

    private static String whom(ShownScenario.Fault fault) {
        int all = fault.targets().size();
        String some = fault.targets().stream().limit(MOST_TARGETS).collect(Collectors.joining(", "));
        String rest = all > MOST_TARGETS ? " and %d more".formatted(all - MOST_TARGETS) : "";
        return fault.pick().filter(n -> n < all).map("%d of "::formatted).orElse("") + some + rest;
    }

    private static String when(ShownScenario.Fault fault) {
        String begins = fault.every()
                .map(mean ->
                        "about every %s s".formatted(mean) + (fault.at() > 0 ? " from %s s".formatted(fault.at()) : ""))
                .orElse("at %s s".formatted(fault.at()));
        String lasts = fault.lasts()
                .map(span -> span.getFirst().equals(span.getLast())
                        ? " for %s s".formatted(span.getFirst())
                        : " for %s to %s s".formatted(span.getFirst(), span.getLast()))
                .orElse(" for good");
        return begins + lasts;
    }

    private static TextTable ends(List<ShownScenario.End> ends) {
        var table = new TextTable("  ");
        ends.forEach(end -> table.row(
                end.outcome(),
                end.when(),
                end.after() > 0 ? String.format(Locale.ROOT, "and %.1f s later", end.after()) : ""));
        return table;
    }

    private static TextTable metrics(List<ShownScenario.MetricDefinition> metrics) {
        var table = new TextTable("  ");
        metrics.forEach(m -> table.row(
                m.name(),
                m.unit(),
                m.from() + (m.perRobot() ? ", per robot" : ""),
                m.better().equals("neither") ? "" : m.better() + " is better",
                bound(m)));
        return table;
    }

    private static String bound(ShownScenario.MetricDefinition measured) {
        return measured.min().map(min -> "at least " + min + " ").orElse("")
                + measured.max().map(max -> "at most " + max).orElse("");
    }

    private static String settings(Map<String, Object> settings) {
        return settings.entrySet().stream()
                .map(s -> s.getKey() + "=" + s.getValue())
                .collect(Collectors.joining(" "));
    }
}
