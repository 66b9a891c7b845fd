package rsal.cli.page;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Collectors;
import picocli.CommandLine.Command;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.Parameters;
import rsal.cli.terminal.Exit;
import rsal.cli.terminal.TextTable;
import rsal.engine.OperatorCommand;
import rsal.engine.OperatorCommands;
import rsal.settings.Arguments;
import rsal.settings.Parameter;
import rsal.settings.Suggestion;
import tools.jackson.databind.JsonNode;

/// `rsal tell`: any of the [OperatorCommands], with its parameters as the server takes them.
@Command(
        name = "tell",
        description = {
            "Give any command to a run with a page. 'rsal tell' alone lists the commands with their parameters.",
            "Lengths are in m, angles in rad."
        })
public final class TellCommand extends ControlCommands.Controlled {
    @Parameters(
            index = "0",
            paramLabel = "COMMAND",
            arity = "0..1",
            description = "Name of the command, as 'rsal tell' lists it.")
    private Optional<String> name = Optional.empty();

    @Parameters(
            index = "1..*",
            paramLabel = "NAME=VALUE",
            description = "A parameter of the command. For a parameter with several values, name each:"
                    + " arguments.speed=0.3.")
    private List<String> values = List.of();

    @Override
    protected int run() throws InterruptedException {
        if (name.isEmpty()) {
            list();
            return Exit.SUCCESS;
        }
        OperatorCommand command = OperatorCommands.of(name.get())
                .orElseThrow(() -> wrong("There is no command '%s'. %s"
                        .formatted(
                                name.get(),
                                Suggestion.among(
                                        name.get(),
                                        OperatorCommands.ALL.stream()
                                                .map(OperatorCommand::name)
                                                .toList()))));
        Arguments arguments = arguments(command);
        JsonNode answer = command.isSafe().test(arguments)
                ? timed(() -> printAtOnce(command.name(), arguments.written()))
                : command(command.name(), arguments.written());
        var reported = new LinkedHashMap<String, Object>();
        answer.properties().forEach(each -> reported.put(each.getKey(), each.getValue()));
        String facts = answer.properties().stream()
                .map(each -> ", %s %s"
                        .formatted(
                                each.getKey(),
                                each.getValue().isString()
                                        ? "'" + each.getValue().asString() + "'"
                                        : each.getValue()))
                .collect(Collectors.joining());
        confirm("'%s' is done%s".formatted(command.name(), facts), reported);
        return Exit.SUCCESS;
    }

    private void list() {
        if (json) {
            printJson(OperatorCommands.ALL.stream().map(TellCommand::described).toList());
            return;
        }
        var table = new TextTable("");
        for (OperatorCommand command : OperatorCommands.ALL) {
            table.row(command.name(), command.description());
            command.parameters().forEach(each -> table.row("  " + written(each), "  " + explained(each)));
        }
        out().print(table);
        out().flush();
    }

    private static Map<String, Object> described(OperatorCommand command) {
        var all = new LinkedHashMap<String, Object>();
        all.put("name", command.name());
        all.put("description", command.description());
        all.put(
                "parameters",
                command.parameters().stream()
                        .map(each -> Map.of("name", each.name(), "description", explained(each)))
                        .toList());
        return all;
    }

    /// `heading=`, or in brackets what may be left out.
    private static String written(Parameter<?> parameter) {
        String name = parameter.kind() == Parameter.Kind.TEXTS ? parameter.name() + ".NAME=" : parameter.name() + "=";
        return parameter.fallback().isEmpty() ? name : "[" + name + "]";
    }

    private static String explained(Parameter<?> parameter) {
        return parameter.description() + (parameter.unit().isEmpty() ? "" : " [" + parameter.unit() + "]");
    }

    private Arguments arguments(OperatorCommand command) {
        var given = new LinkedHashMap<String, Object>();
        for (String each : values) {
            int equals = each.indexOf('=');
            if (equals < 1) {
                throw wrong("A parameter is NAME=VALUE, not '%s'.".formatted(each));
            }
            put(given, command, each.substring(0, equals), each.substring(equals + 1));
        }
        try {
            return Arguments.parse(command.parameters(), given);
        } catch (IllegalArgumentException e) {
            throw wrong(String.valueOf(e.getMessage()));
        }
    }

    /// @param given takes the value; of a parameter that takes texts by name, the text among its others
    private static void put(Map<String, Object> given, OperatorCommand command, String name, String value) {
        int dot = name.indexOf('.');
        if (dot < 0 || !takesTexts(command, name.substring(0, dot))) {
            given.put(name, value);
            return;
        }
        var all = new LinkedHashMap<Object, Object>();
        if (given.get(name.substring(0, dot)) instanceof Map<?, ?> before) {
            all.putAll(before);
        }
        all.put(name.substring(dot + 1), value);
        given.put(name.substring(0, dot), all);
    }

    private static boolean takesTexts(OperatorCommand command, String name) {
        return command.parameters().stream()
                .anyMatch(each -> each.name().equals(name) && each.kind() == Parameter.Kind.TEXTS);
    }

    private ParameterException wrong(String message) {
        return new ParameterException(spec.commandLine(), message);
    }
}
