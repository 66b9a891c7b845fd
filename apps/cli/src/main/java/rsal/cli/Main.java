package rsal.cli;

import java.io.IOException;
import java.io.OutputStream;
import java.io.PrintWriter;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import picocli.CommandLine;
import picocli.CommandLine.Command;
import picocli.CommandLine.Help;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.ParseResult;
import picocli.CommandLine.Spec;
import picocli.CommandLine.UnmatchedArgumentException;
import rsal.cli.bench.BenchCommand;
import rsal.cli.bench.PatrolCommand;
import rsal.cli.grade.GradeCommand;
import rsal.cli.grade.TestAgentCommand;
import rsal.cli.log.ConvertCommand;
import rsal.cli.log.ExportCommand;
import rsal.cli.log.LocalizeCommand;
import rsal.cli.log.MapCommand;
import rsal.cli.page.AgentCommand;
import rsal.cli.page.CertificateCommand;
import rsal.cli.page.ControlCommands;
import rsal.cli.page.DoctorCommand;
import rsal.cli.page.LogsCommand;
import rsal.cli.page.TellCommand;
import rsal.cli.run.BridgeCommand;
import rsal.cli.run.EnvironmentsCommand;
import rsal.cli.run.ReplayCommand;
import rsal.cli.run.RunCommand;
import rsal.cli.run.ServeCommand;
import rsal.cli.show.ListCommand;
import rsal.cli.show.ShowCommand;
import rsal.cli.show.ValidateCommand;
import rsal.cli.start.Companion;
import rsal.cli.start.PrepareCommand;
import rsal.cli.start.StartCache;
import rsal.cli.sweep.ReportCommand;
import rsal.cli.sweep.SweepCommand;
import rsal.cli.terminal.Build;
import rsal.cli.terminal.CommandWords;
import rsal.cli.terminal.Exit;
import rsal.cli.terminal.OldLogs;
import rsal.cli.terminal.Stdout;
import rsal.cli.terminal.Terminal;
import rsal.cli.terminal.Unreachable;
import rsal.engine.report.RunBroken;
import rsal.settings.InvalidSettings;
import rsal.settings.OwnCode;
import rsal.settings.Suggestion;

/// The command line.
@Command(
        name = "rsal",
        versionProvider = Build.class,
        mixinStandardHelpOptions = true,
        description = "Runs teams of robots whose decisions agents make.",
        synopsisSubcommandLabel = "COMMAND",
        commandListHeading = "%nCommands:%n",
        footer = {
            "",
            "Start with 'rsal run'. 'rsal COMMAND --help' explains a command.",
            "Exit codes: 0 success, 1 internal error, 2 usage, 3 invalid input, 4 the scenario ended in failure or"
                    + " timeout or an agent failed, 5 something cannot be reached (a port, a JDK), 130 and 143 ended by a signal."
        })
public final class Main implements Runnable {
    /// In the order in which help lists them.
    private static final List<Class<?>> COMMANDS = List.of(
            RunCommand.class,
            ServeCommand.class,
            ReplayCommand.class,
            ExportCommand.class,
            SweepCommand.class,
            ReportCommand.class,
            TestAgentCommand.class,
            GradeCommand.class,
            BridgeCommand.class,
            AgentCommand.class,
            LogsCommand.class,
            ControlCommands.Status.class,
            ControlCommands.Goal.class,
            ControlCommands.Pose.class,
            ControlCommands.EmergencyStop.class,
            ControlCommands.Arm.class,
            ControlCommands.Stop.class,
            TellCommand.class,
            ListCommand.class,
            ShowCommand.class,
            ValidateCommand.class,
            NewCommand.class,
            ConvertCommand.class,
            LocalizeCommand.class,
            MapCommand.class,
            DoctorCommand.class,
            PrepareCommand.class,
            CertificateCommand.class,
            PatrolCommand.class,
            BenchCommand.class,
            TestCommand.class,
            DocsCommand.class,
            DistCommand.class,
            EnvironmentsCommand.class,
            HelpCommand.class);

    private static final Pattern ONE_OF = Pattern.compile(
            "Invalid value for option '([^']+)'.*: expected one of \\[(.*)] \\(case-(?:in)?sensitive\\) but was '(.*)'",
            Pattern.DOTALL);

    @Spec
    @SuppressWarnings("NullAway.Init") // picocli fills it in
    private CommandSpec spec;

    public static void main(String[] args) {
        Locale.setDefault(Locale.Category.FORMAT, Locale.ROOT); // files and results have points in numbers anywhere
        if (isLong(args)) {
            try {
                Companion.watch(System.getenv());
            } catch (IllegalArgumentException e) {
                System.err.println("rsal: " + e.getMessage());
                System.exit(Exit.USAGE);
            }
            StartCache.ofThisProcess().filter(cache -> !cache.wasTried()).ifPresent(StartCache::makeInBackground);
        }
        var stdout = new Stdout();
        CommandLine commandLine = commandLine(stdout, args);
        int code = execute(commandLine, args);
        commandLine.getOut().flush();
        stdout.failure()
                .ifPresent(e -> commandLine
                        .getErr()
                        .println("rsal: The result could not be written to stdout: " + e.getMessage()));
        System.exit(code == Exit.SUCCESS && stdout.failure().isPresent() ? Exit.UNREACHABLE : code);
    }

    /// Whether a line is for something that goes on for a while, beside which the cache for the next start can be made.
    private static boolean isLong(String[] line) {
        return line.length > 0 && List.of("run", "serve", "sweep", "replay").contains(line[0]);
    }

    private static int execute(CommandLine commandLine, String[] args) {
        try {
            return commandLine.execute(args);
        } catch (OutOfMemoryError lack) { // what took it is not held any more
            return printNoMemory(commandLine.getErr(), lack);
        }
    }

    /// @param stdout where results go
    public static CommandLine commandLine(OutputStream stdout) {
        return commandLine(stdout, COMMANDS);
    }

    /// What a line needs: to make all commands takes half a second, which an operator who stops robots does not have.
    private static CommandLine commandLine(OutputStream stdout, String[] line) {
        if (line.length == 1 && List.of("-V", "--version").contains(line[0])) {
            return commandLine(stdout, List.of());
        }
        return commandLine(
                stdout,
                COMMANDS.stream()
                        .filter(command -> line.length > 0 && name(command).equals(line[0]))
                        .filter(command -> command != HelpCommand.class) // which tells of all
                        .findFirst()
                        .<List<Class<?>>>map(List::of)
                        .orElse(COMMANDS));
    }

    private static String name(Class<?> command) {
        return command.getAnnotation(Command.class).name();
    }

    private static CommandLine commandLine(OutputStream stdout, List<Class<?>> commands) {
        var commandLine = new CommandLine(new Main());
        commands.forEach(commandLine::addSubcommand);
        CommandWords.register(commandLine);
        commandLine.registerConverter(
                ListCommand.What.class, word -> CommandWords.oneOf(word, ListCommand.What.values()));
        return commandLine
                .setOut(new PrintWriter(stdout, false, StandardCharsets.UTF_8))
                .setErr(new PrintWriter(System.err, true, StandardCharsets.UTF_8))
                .setColorScheme(Help.defaultColorScheme(Terminal.colors()))
                .setUsageHelpWidth(110)
                .setUsageHelpLongOptionsMaxWidth(30)
                .setExitCodeExceptionMapper(_ -> Exit.INTERNAL)
                .setParameterExceptionHandler((error, _) -> printError(error))
                .setExecutionExceptionHandler(Main::printFailure);
    }

    /// @param lack of the heap, or of something else that more of it would not help, as of threads
    private static int printNoMemory(PrintWriter err, OutOfMemoryError lack) {
        String what = String.valueOf(lack.getMessage());
        if (what.contains("heap") || what.contains("GC overhead")) {
            long most = Runtime.getRuntime().maxMemory() >> 20;
            err.println(
                    "rsal: The %,d MiB of memory that it may have are not enough. Maybe give it more: JAVA_TOOL_OPTIONS=-Xmx%dm rsal …"
                            .formatted(most, 2 * most));
        } else {
            err.println("rsal: This machine does not have enough resources: " + what);
        }
        return Exit.UNREACHABLE;
    }

    @Override
    public void run() {
        throw new ParameterException(
                spec.commandLine(), "Name a command: %s.".formatted(String.join(", ", commands())));
    }

    private List<String> commands() {
        return spec.subcommands().entrySet().stream()
                .filter(command ->
                        !command.getValue().getCommandSpec().usageMessage().hidden())
                .map(Map.Entry::getKey)
                .toList();
    }

    private static int printError(ParameterException error) {
        CommandLine command = error.getCommandLine();
        String message = error instanceof UnmatchedArgumentException unmatched
                ? aboutUnmatched(command, unmatched.getUnmatched().getFirst())
                : inOurWords(String.valueOf(error.getMessage()));
        command.getErr().println("rsal: " + message);
        command.getErr().println("Try '" + command.getCommandSpec().qualifiedName() + " --help'.");
        return Exit.USAGE;
    }

    /// What picocli says of an option that takes one of some words.
    private static String inOurWords(String message) {
        Matcher found = ONE_OF.matcher(message);
        return found.matches()
                ? "%s must be one of %s, not '%s'.".formatted(found.group(1), found.group(2), found.group(3))
                : message;
    }

    private static String aboutUnmatched(CommandLine command, String word) {
        CommandSpec spec = command.getCommandSpec();
        if (word.startsWith("-")) {
            return "There is no option '%s'. %s"
                    .formatted(word, Suggestion.among(word, spec.optionsMap().keySet()));
        }
        if (!spec.subcommands().isEmpty()) {
            return "There is no command '%s'. %s"
                    .formatted(word, Suggestion.among(word, spec.subcommands().keySet()));
        }
        return "'%s' is more than '%s' accepts.".formatted(word, spec.qualifiedName());
    }

    private static int printFailure(Exception failure, CommandLine command, ParseResult typed) throws IOException {
        PrintWriter err = command.getErr();
        return switch (failure) {
            case InvalidSettings errors -> {
                err.println(errors.getMessage());
                yield Exit.INVALID;
            }
            case Unreachable unreachable -> {
                err.println("rsal: " + unreachable.getMessage());
                yield Exit.UNREACHABLE;
            }
            case RunBroken broken
            when unreachable(broken).isPresent() -> {
                err.println("rsal: " + unreachable(broken).get());
                yield Exit.UNREACHABLE;
            }
            case RunBroken broken
            when RunBroken.lackOfMemory(broken).isPresent() ->
                printNoMemory(err, RunBroken.lackOfMemory(broken).get());
            case RunBroken broken
            when OwnCode.hasFailed(broken) && !typed.originalArgs().contains("--debug") -> {
                err.println("rsal: The run ended, because code of yours failed. " + broken.getMessage());
                err.println("With --debug, the whole trace is printed.");
                yield Exit.INTERNAL;
            }
            case RunBroken broken
            when broken.getCause() == null -> { // it says all, and is no error of ours
                err.println("rsal: The run broke: " + broken.getMessage());
                yield Exit.INTERNAL;
            }
            default -> {
                printInternal(failure, command, typed.originalArgs());
                yield Exit.INTERNAL;
            }
        };
    }

    /// What the robot systems of a run could not reach or have, if it is that.
    private static Optional<String> unreachable(RunBroken broken) {
        return Stream.<Throwable>iterate(broken, Objects::nonNull, Throwable::getCause)
                .filter(IOException.class::isInstance)
                .findFirst()
                .map(Throwable::getMessage);
    }

    private static void printInternal(Exception failure, CommandLine command, List<String> typed) throws IOException {
        PrintWriter err = command.getErr();
        String what = failure instanceof RunBroken broken ? String.valueOf(broken.getMessage()) : failure.toString();
        err.println("rsal: Something went wrong: " + what);
        if (typed.contains("--debug")) {
            failure.printStackTrace(err);
            return;
        }
        Path log = OldLogs.next();
        try (var file = new PrintWriter(Files.newBufferedWriter(log))) {
            file.println("rsal " + String.join(" ", typed));
            Stream.of("java.vm.version", "os.name", "os.arch")
                    .map(System::getProperty)
                    .forEach(file::println);
            failure.printStackTrace(file);
        }
        err.println("Where it went wrong is in " + log + "; please send that file with a report.");
    }
}
