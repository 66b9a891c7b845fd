package rsal.cli;

import java.util.Optional;
import picocli.CommandLine;
import picocli.CommandLine.Command;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.Parameters;
import rsal.cli.terminal.Exit;
import rsal.cli.terminal.Subcommand;
import rsal.settings.Suggestion;

/// `rsal help`
@Command(name = "help", description = "Show all commands, or the options of one.")
final class HelpCommand extends Subcommand {
    @Parameters(paramLabel = "COMMAND", arity = "0..1", description = "Default: all of them.")
    private Optional<String> command = Optional.empty();

    @Override
    protected int run() {
        CommandLine all = spec.commandLine().getParent();
        CommandLine asked = command.isEmpty() ? all : all.getSubcommands().get(command.get());
        if (asked == null) {
            String name = command.orElseThrow();
            throw new ParameterException(
                    spec.commandLine(),
                    "There is no command '%s'. %s"
                            .formatted(
                                    name,
                                    Suggestion.among(name, all.getSubcommands().keySet())));
        }
        asked.usage(out(), all.getColorScheme());
        out().flush();
        return Exit.SUCCESS;
    }
}
