package rsal.cli;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.stream.Collectors;
import picocli.CommandLine.Command;
import picocli.CommandLine.Parameters;
import rsal.data.OccupancyGrid;
import rsal.scenario.Configuration;
import rsal.scenario.RunOptions;
import rsal.scenario.RunPlan;
import rsal.scenario.RunPlan.PlannedAgent;
import rsal.scenario.RunPlan.PlannedRobot;
import rsal.scenario.Scenario;
import rsal.settings.Parameter;

/// `rsal show`
@Command(
        name = "show",
        description = "Show what is in a scenario: arguments, configurations, robots and their devices, agents, ends"
                + " and measures.")
final class ShowCommand extends Subcommand {
    @Parameters(paramLabel = "SCENARIO[:CONFIGURATION]", description = "A built-in scenario ('rsal list') or a file.")
    private String scenario = "";

    @Override
    int run() {
        ScenarioReference reference = ScenarioReference.parse(scenario);
        Scenario loaded = reference.load();
        RunPlan plan = loaded.plan(reference
                .configuration()
                .map(RunOptions.NONE::withConfiguration)
                .orElse(RunOptions.NONE));
        var shown = new Shown(
                loaded.name(),
                loaded.title(),
                loaded.description(),
                loaded.location().file(),
                plan.configuration(),
                loaded.configurations(),
                loaded.arguments().stream().map(a -> Argument.of(a, plan)).toList(),
                world(plan),
                roles(plan),
                agents(plan),
                plan.stops().stream()
                        .map(s -> new End(s.outcome().word(), s.when().toString()))
                        .toList(),
                plan.measures().stream()
                        .map(m -> new Measured(m.name(), m.unit(), m.from().toString(), m.perRobot()))
                        .toList());
        if (json) {
            printJson(shown);
        } else {
            out().print(text(shown));
            out().flush();
        }
        return Exit.SUCCESS;
    }

    /// All of it, as `--json` prints it.
    record Shown(
            String scenario,
            String title,
            String description,
            String file,
            String configuration,
            List<Configuration> configurations,
            List<Argument> arguments,
            World world,
            List<Role> robots,
            List<Role.Agent> agents,
            List<End> ends,
            List<Measured> measures) {}

    record Argument(String name, Object value, String expected, String description) {
        static Argument of(Parameter parameter, RunPlan plan) {
            Object value = Objects.requireNonNull(plan.arguments().get(parameter.name()), "a plan has all arguments");
            return new Argument(parameter.name(), value, parameter.expected(), parameter.description());
        }
    }

    /// @param width and height of the map [m]
    /// @param step of simulated time [s]
    record World(String map, double width, double height, String mrs, String mas, double step) {}

    record Role(String role, List<String> ids, String model, List<String> sensors, List<Device> devices) {
        record Device(String name, String driver, Map<String, Object> options) {}

        record Agent(String name, String type, Optional<String> robot, Map<String, Object> arguments) {}
    }

    record End(String outcome, String when) {}

    record Measured(String name, String unit, String from, boolean perRobot) {}

    private static World world(RunPlan plan) {
        OccupancyGrid map = plan.map();
        return new World(
                plan.mapName(),
                rounded(map.width() * map.resolution()),
                rounded(map.height() * map.resolution()),
                plan.mrs().provider().key(),
                plan.mas().provider().key(),
                plan.step().toNanos() / 1e9);
    }

    private static double rounded(double meters) {
        return Math.round(meters * 1e3) / 1e3;
    }

    /// Robots of one role are alike.
    private static List<Role> roles(RunPlan plan) {
        var byRole = new LinkedHashMap<String, List<PlannedRobot>>();
        for (PlannedRobot robot : plan.robots()) {
            byRole.computeIfAbsent(robot.spec().role(), _ -> new ArrayList<>()).add(robot);
        }
        return byRole.entrySet().stream()
                .map(entry -> role(entry.getKey(), entry.getValue()))
                .toList();
    }

    private static Role role(String name, List<PlannedRobot> robots) {
        PlannedRobot first = robots.getFirst();
        return new Role(
                name,
                robots.stream().map(r -> r.spec().id()).toList(),
                first.spec().model().name(),
                first.spec().model().sensors().entrySet().stream()
                        .map(sensor -> sensor.getKey() + " " + sensor.getValue().name())
                        .toList(),
                first.drivers().stream()
                        .map(d -> new Role.Device(
                                d.name(), d.driver().key(), d.options().asMap()))
                        .toList());
    }

    private static List<Role.Agent> agents(RunPlan plan) {
        return plan.agents().stream().map(ShowCommand::agent).toList();
    }

    private static Role.Agent agent(PlannedAgent agent) {
        return new Role.Agent(
                agent.name(),
                agent.type().key(),
                agent.robot(),
                agent.arguments().asMap());
    }

    private static String text(Shown shown) {
        var text = new StringBuilder();
        text.append("%s: %s%n".formatted(shown.scenario, shown.title));
        text.append("read from %s%n".formatted(shown.file));
        if (!shown.description.isEmpty()) {
            text.append('\n').append(shown.description.strip()).append('\n');
        }
        section(text, "Configurations", configurations(shown));
        section(text, "Arguments of %s (--set NAME=VALUE)".formatted(shown.configuration), arguments(shown.arguments));
        section(text, "World", world(shown.world));
        section(text, "Robots", robots(shown.robots));
        section(text, "Agents", agents(shown.agents));
        section(text, "Ends when", ends(shown.ends));
        section(text, "Measures", measures(shown.measures));
        return text.toString();
    }

    private static void section(StringBuilder text, String heading, Table table) {
        if (!table.isEmpty()) {
            text.append('\n').append(heading).append('\n').append(table);
        }
    }

    private static Table configurations(Shown shown) {
        var table = new Table("  ");
        for (Configuration configuration : shown.configurations) {
            boolean isShown = configuration.name().equals(shown.configuration);
            table.row(configuration.name(), isShown ? "shown here" : "", configuration.title());
        }
        return table;
    }

    private static Table arguments(List<Argument> arguments) {
        var table = new Table("  ");
        arguments.forEach(a -> table.row(a.name, a.value.toString(), a.expected, a.description));
        return table;
    }

    private static Table world(World world) {
        return new Table("  ")
                .row("map", String.format(Locale.ROOT, "%s, %.2f m × %.2f m", world.map, world.width, world.height))
                .row("mrs", world.mrs + ", in steps of " + world.step + " s")
                .row("mas", world.mas);
    }

    private static Table robots(List<Role> roles) {
        var table = new Table("  ");
        for (Role role : roles) {
            table.row(role.role, role.ids.size() + " × " + role.model, String.join(", ", role.sensors));
            role.devices.forEach(d -> table.row("", d.name + ": " + d.driver, settings(d.options)));
        }
        return table;
    }

    private static Table agents(List<Role.Agent> agents) {
        var table = new Table("  ");
        agents.forEach(
                a -> table.row(a.name, a.type, a.robot.map(r -> "for " + r).orElse(""), settings(a.arguments)));
        return table;
    }

    private static Table ends(List<End> ends) {
        var table = new Table("  ");
        ends.forEach(end -> table.row(end.outcome, end.when));
        return table;
    }

    private static Table measures(List<Measured> measures) {
        var table = new Table("  ");
        measures.forEach(m -> table.row(m.name, m.unit, m.from + (m.perRobot ? ", per robot" : "")));
        return table;
    }

    private static String settings(Map<String, Object> settings) {
        return settings.entrySet().stream()
                .map(s -> s.getKey() + "=" + s.getValue())
                .collect(Collectors.joining(" "));
    }
}
