package rsal.cli;

import picocli.CommandLine;
import picocli.CommandLine.Command;

/// The command line.
@Command(
        name = "rsal",
        version = "rsal 0.1.0",
        mixinStandardHelpOptions = true,
        description = "Joins agents with robots: runs teams of robots that agents decide for.")
public final class Main {
    private Main() {}

    public static void main(String[] args) {
        System.exit(new CommandLine(new Main()).execute(args));
    }
}
