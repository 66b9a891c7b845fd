package rsal.cli;

import java.io.OutputStream;
import java.lang.reflect.Field;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import picocli.CommandLine;
import picocli.CommandLine.Model.ArgSpec;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Model.OptionSpec;
import picocli.CommandLine.Model.PositionalParamSpec;
import rsal.cli.terminal.Subcommand;

/// What the command line knows of its commands.
final class CommandReference {
    private static final CommandSpec ALL =
            Main.commandLine(OutputStream.nullOutputStream()).getCommandSpec();

    private CommandReference() {}

    /// `rsal`, and each command that does something: `rsal run`, `rsal agent mind`.
    static Stream<String> names() {
        return Stream.concat(Stream.of(ALL.qualifiedName()), leaves(ALL).map(CommandSpec::qualifiedName));
    }

    private static Stream<CommandSpec> leaves(CommandSpec of) {
        return of.subcommands().isEmpty()
                ? Stream.of(of)
                : of.subcommands().values().stream()
                        .map(CommandLine::getCommandSpec)
                        .filter(command -> !command.usageMessage().hidden())
                        .flatMap(CommandReference::leaves);
    }

    static String of(String name) {
        if (name.equals(ALL.qualifiedName())) {
            return overview();
        }
        CommandSpec command = leaves(ALL)
                .filter(leaf -> leaf.qualifiedName().equals(name))
                .findAny()
                .orElseThrow(() -> new IllegalArgumentException("There is no command '%s'.".formatted(name)));
        List<ArgSpec> own = own(command);
        String text = "```\n%s\n```\n\n%s\n".formatted(synopsis(command, own), description(command));
        if (!own.isEmpty()) {
            var table = new Markdown.Table("", "");
            own.forEach(arg -> table.row(
                    label(arg),
                    Markdown.text(
                            String.format(String.join(" ", arg.description())).replaceAll("\\s+", " "))));
            text += "\n" + table;
        }
        return text + footer(command);
    }

    private static String overview() {
        var table = new Markdown.Table("", "");
        leaves(ALL)
                .forEach(command -> table.row(
                        "[`%s`](#%s)".formatted(command.qualifiedName(), Markdown.anchor(command.qualifiedName())),
                        Markdown.firstSentence(description(command))));
        return table.toString();
    }

    private static String description(CommandSpec command) {
        return Markdown.text(
                String.format(String.join(" ", command.usageMessage().description()))
                        .replaceAll("\\s+", " "));
    }

    /// Without what all commands take.
    private static List<ArgSpec> own(CommandSpec command) {
        return Stream.<ArgSpec>concat(command.positionalParameters().stream(), command.options().stream())
                .filter(arg ->
                        !(arg.userObject() instanceof Field field && field.getDeclaringClass() == Subcommand.class))
                .filter(arg -> !arg.hidden())
                .toList();
    }

    private static String synopsis(CommandSpec command, List<ArgSpec> own) {
        var words = new ArrayList<>(List.of(command.qualifiedName()));
        own.stream()
                .filter(PositionalParamSpec.class::isInstance)
                .map(CommandReference::place)
                .forEach(words::add);
        command.argGroups().stream()
                .filter(group -> group.multiplicity().min() > 0)
                .map(CommandLine.Model.ArgGroupSpec::synopsis)
                .forEach(words::add);
        own.stream()
                .filter(arg -> arg instanceof OptionSpec && arg.required() && arg.group() == null)
                .map(CommandReference::plain)
                .forEach(words::add);
        if (own.stream().anyMatch(arg -> arg instanceof OptionSpec && !arg.required())) {
            words.add("[OPTION…]");
        }
        return String.join(" ", words);
    }

    private static String place(ArgSpec parameter) {
        String label = parameter.paramLabel() + (parameter.arity().max() > 1 ? "…" : "");
        return parameter.required() ? label : "[" + label + "]";
    }

    private static String label(ArgSpec arg) {
        return Markdown.code(plain(arg));
    }

    private static String plain(ArgSpec arg) {
        return switch (arg) {
            case OptionSpec option when option.arity().max() == 0 -> option.longestName();
            case OptionSpec option -> option.longestName() + " " + option.paramLabel();
            default -> arg.paramLabel();
        };
    }

    /// Lines that are indented are examples.
    private static String footer(CommandSpec command) {
        List<String> lines = List.of(command.usageMessage().footer());
        String words = lines.stream()
                .filter(line -> !line.startsWith("  "))
                .collect(Collectors.joining(" "))
                .strip();
        String examples = lines.stream()
                .filter(line -> line.startsWith("  "))
                .map(line -> line.strip() + "\n")
                .collect(Collectors.joining());
        return (words.isEmpty() ? "" : "\n" + Markdown.text(words) + "\n")
                + (examples.isEmpty() ? "" : "\n```\n" + examples + "```\n");
    }
}
