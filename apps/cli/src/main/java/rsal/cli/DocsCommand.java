package rsal.cli;

import picocli.CommandLine.Command;
import picocli.CommandLine.Option;
import rsal.cli.terminal.Subcommand;
import rsal.cli.terminal.Unreachable;

/// Listed here for the help; the launcher does it, because it has the sources.
@Command(
        name = "docs",
        description = "Build the documentation as a site, with a search, and print the folder that it is in.")
final class DocsCommand extends Subcommand {
    @Option(names = "--serve", description = "Serve it on this machine, http://127.0.0.1:8736/, until Ctrl-C.")
    private boolean serve;

    @Override
    protected int run() {
        check(!json, "--json is not for this command: it prints a folder.");
        throw new Unreachable("The documentation is built by the launcher in the project's folder: ./rsal docs"
                + (serve ? " --serve" : ""));
    }
}
