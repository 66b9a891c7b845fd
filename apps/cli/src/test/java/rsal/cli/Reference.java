package rsal.cli;

import java.util.List;
import java.util.Set;
import java.util.function.Function;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import rsal.agent.AgentHostProvider;
import rsal.agent.AgentType;
import rsal.cli.show.InstalledKind;
import rsal.cli.show.ShownMap;
import rsal.cli.show.ShownPart;
import rsal.engine.OperatorCommands;
import rsal.engine.report.Answer;
import rsal.map.Maps;
import rsal.metric.MetricType;
import rsal.model.RobotModels;
import rsal.navigation.control.ControllerType;
import rsal.navigation.control.GoalCheckerType;
import rsal.navigation.control.PlannerType;
import rsal.navigation.control.ProgressCheckerType;
import rsal.navigation.recovery.RecoveryType;
import rsal.navigation.traffic.TrafficType;
import rsal.robot.DeviceDriver;
import rsal.robot.DeviceKind;
import rsal.scenario.installed.Providers;
import rsal.settings.Parameter;
import rsal.system.BridgeProvider;
import rsal.system.RobotSystemProvider;

/// What the code says of itself, as Markdown for the pages of the reference.
final class Reference {
    /// Agents of one's own, fakes of tests, and what is built along only when somebody asks for it.
    private static final String NOT_SHIPPED = "(own|rsal\\.testkit|rsal\\.jadex)\\..*";

    private Reference() {}

    /// Of the sections that must be somewhere.
    static List<String> names() {
        return Stream.concat(
                        Stream.of(
                                "agents",
                                "devices",
                                "drivers",
                                "controllers",
                                "planners",
                                "goalCheckers",
                                "progressCheckers",
                                "recoveries",
                                "trafficRules",
                                "deviceKinds",
                                "topics",
                                "readings",
                                "metrics",
                                "mas",
                                "mrs",
                                "bridges",
                                "operatorCommands",
                                "models",
                                "parts",
                                "maps"),
                        CommandReference.names())
                .toList();
    }

    /// @param name one of [#names], or a part of a schema: `scenario.schema.json#/properties/communication`
    static String section(String name) {
        return switch (name) {
            case "agents" -> kinds(InstalledKind.agents(), AgentType.class, AgentType::key);
            case "drivers" -> kinds(InstalledKind.drivers(), DeviceDriver.class, DeviceDriver::key);
            case "controllers" -> kinds(InstalledKind.plugins("controller"), ControllerType.class, ControllerType::key);
            case "planners" -> kinds(InstalledKind.plugins("planner"), PlannerType.class, PlannerType::key);
            case "goalCheckers" ->
                kinds(InstalledKind.plugins("goalChecker"), GoalCheckerType.class, GoalCheckerType::key);
            case "progressCheckers" ->
                kinds(InstalledKind.plugins("progressChecker"), ProgressCheckerType.class, ProgressCheckerType::key);
            case "recoveries" -> kinds(InstalledKind.plugins("recovery"), RecoveryType.class, RecoveryType::key);
            case "trafficRules" -> kinds(InstalledKind.plugins("traffic"), TrafficType.class, TrafficType::key);
            case "deviceKinds" -> kinds(InstalledKind.devices(), DeviceKind.class, DeviceKind::key);
            case "topics" -> MessageTypes.topics();
            case "readings" -> MessageTypes.readings();
            case "metrics" -> kinds(InstalledKind.metrics(), MetricType.class, MetricType::key);
            case "mas" -> kinds(InstalledKind.hosts(), AgentHostProvider.class, AgentHostProvider::key);
            case "mrs" -> kinds(InstalledKind.systems(), RobotSystemProvider.class, RobotSystemProvider::key);
            case "bridges" -> bridges();
            case "operatorCommands" -> operatorCommands();
            case "devices" -> DeviceTypes.all();
            case "models" -> models();
            case "parts" -> DeviceTypes.parts();
            case "maps" -> maps();
            default -> name.startsWith("rsal") ? CommandReference.of(name) : SchemaTable.of(name);
        };
    }

    static boolean isShipped(Class<?> provider) {
        return !provider.getName().matches(NOT_SHIPPED);
    }

    private static <P> String kinds(Stream<InstalledKind> kinds, Class<P> type, Function<P, String> key) {
        Set<String> shipped = Providers.byKey(type, key).values().stream()
                .filter(provider -> isShipped(provider.getClass()))
                .map(key)
                .collect(Collectors.toSet());
        return kinds.filter(kind -> shipped.contains(kind.name()))
                .map(Reference::kind)
                .collect(Collectors.joining("\n"));
    }

    private static String kind(InstalledKind kind) {
        var text = new StringBuilder("### %s%n%n%s".formatted(heading(kind), Markdown.text(kind.description())));
        kind.makes()
                .filter(_ -> kind.kind().equals("driver"))
                .ifPresent(type -> text.append(" Makes a ").append(link(type)).append('.'));
        if (!kind.needs().isEmpty()) {
            text.append(" Needs a robot with ")
                    .append(kind.needs().stream().map(Reference::link).collect(Collectors.joining(", ")))
                    .append('.');
        }
        text.append('\n');
        if (!kind.quantities().isEmpty()) {
            var offered = new Markdown.Table("quantity or signal", "", "");
            kind.quantities()
                    .forEach(offer -> offered.row(
                            Markdown.code(offer.written()),
                            offer.unit().isEmpty() ? "" : Markdown.text("[" + offer.unit() + "]"),
                            Markdown.text(offer.description())));
            text.append('\n').append(offered);
        }
        if (!kind.settings().isEmpty()) {
            var table = new Markdown.Table("parameter", "", "default", "");
            kind.settings()
                    .forEach(setting -> table.row(
                            Markdown.code(setting.name()),
                            Markdown.text(setting.expected()),
                            setting.value().map(Markdown::value).orElse("must be given"),
                            Markdown.text(setting.description())));
            text.append('\n').append(table);
        }
        return text.toString();
    }

    /// A driver's says what it is, as some are called like the type that they make.
    private static String heading(InstalledKind kind) {
        return kind.kind().equals("driver") ? "type: " + kind.name() : kind.name();
    }

    private static String link(String device) {
        return "[%s](devices.md#%s)".formatted(device, Markdown.anchor(device));
    }

    private static String operatorCommands() {
        var table = new Markdown.Table("command", "", "parameters", "answer");
        OperatorCommands.ALL.forEach(command -> table.row(
                Markdown.code(command.name()),
                Markdown.text(command.description()),
                command.parameters().stream().map(Reference::parameter).collect(Collectors.joining("; ")),
                command.answer() == Answer.Done.class
                        ? ""
                        : Markdown.code(command.answer().getSimpleName())));
        return table.toString();
    }

    /// `kind`: what it is (BOX, BALL)
    private static String parameter(Parameter<?> parameter) {
        String unit = parameter.unit().isEmpty() ? "" : " [" + parameter.unit() + "]";
        String options = parameter.options().isEmpty() ? "" : " (" + String.join(", ", parameter.options()) + ")";
        String optional = parameter.fallback().isPresent() ? " 'optional'" : "";
        return Markdown.code(parameter.name())
                + ": "
                + Markdown.text(parameter.description() + unit + options + optional);
    }

    private static String bridges() {
        var table = new Markdown.Table("protocol", "", "first port");
        Providers.byKey(BridgeProvider.class, BridgeProvider::key)
                .values()
                .forEach(bridge -> table.row(
                        Markdown.code(bridge.key()),
                        Markdown.text(bridge.description()),
                        String.valueOf(bridge.defaultPort())));
        return table.toString();
    }

    private static String models() {
        var table = new Markdown.Table("model", "");
        RobotModels.builtIn()
                .forEach(name -> table.row(
                        Markdown.code(name),
                        Markdown.text(ShownPart.of(name).orElseThrow().title())));
        return table.toString();
    }

    private static String maps() {
        var table = new Markdown.Table("map", "");
        Maps.builtIn()
                .forEach(name -> table.row(
                        Markdown.code(name),
                        Markdown.text(ShownMap.of(name, ShownMap.find(name)).size())));
        return table.toString();
    }
}
