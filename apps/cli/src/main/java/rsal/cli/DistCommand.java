package rsal.cli;

import java.util.List;
import java.util.stream.Collectors;
import picocli.CommandLine.Command;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import rsal.cli.terminal.Subcommand;
import rsal.cli.terminal.Unreachable;

/// Listed here for the help; the launcher does it, because it has the sources.
@Command(
        name = "dist",
        description = "Pack a release for each system: an archive with RSAL, its page and documentation, and a Java"
                + " runtime. Its users need neither Java nor a network. Or pack a Python wheel for all systems.")
final class DistCommand extends Subcommand {
    @Parameters(
            paramLabel = "SYSTEM",
            arity = "0..*",
            description = "linux-x64, linux-arm64, macos-arm64, macos-x64 or windows-x64. Default: all of them.")
    private List<String> systems = List.of();

    @Option(
            names = "--no-runtime",
            description = "Without a Java runtime: users then need Java 25. Packing then needs no network.")
    private boolean bare;

    @Option(
            names = "--wheel",
            description = "Pack only the Python wheel, for 'pip install'. It has RSAL and its page; pip brings the Java"
                    + " runtime. Packing needs Python 3.10 or newer.")
    private boolean wheel;

    @Option(names = "--out", paramLabel = "FOLDER", description = "Folder for the archives. Default: target/dist.")
    private String out = "";

    @Override
    protected int run() {
        throw new Unreachable("Releases are packed by the launcher in the project's folder: ./rsal dist"
                + systems.stream().map(system -> " " + system).collect(Collectors.joining())
                + (bare ? " --no-runtime" : "")
                + (wheel ? " --wheel" : "")
                + (out.isEmpty() ? "" : " --out " + out));
    }
}
