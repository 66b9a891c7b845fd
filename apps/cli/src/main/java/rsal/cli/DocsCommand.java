package rsal.cli;

import com.sun.net.httpserver.SimpleFileServer;
import com.sun.net.httpserver.SimpleFileServer.OutputLevel;
import java.io.UncheckedIOException;
import java.net.BindException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.nio.file.Path;
import java.util.Optional;
import picocli.CommandLine.Command;
import picocli.CommandLine.Option;
import rsal.cli.terminal.Exit;
import rsal.cli.terminal.Subcommand;
import rsal.cli.terminal.Unreachable;

/// `rsal docs`: in a release, which has the built site. In a clone, the launcher does it, because it has the sources.
@Command(
        name = "docs",
        description = "Print the folder of the documentation site, which has a search. In a clone, build it before.")
final class DocsCommand extends Subcommand {
    private static final int PORT = 8736;

    @Option(names = "--serve", description = "Serve the site on this machine, http://127.0.0.1:8736/, until Ctrl-C.")
    private boolean serve;

    @Override
    protected int run() throws InterruptedException {
        check(!json, "--json is not for this command: it prints a folder.");
        Path site = Optional.ofNullable(System.getProperty("rsal.docs"))
                .map(Path::of)
                .orElseThrow(() -> new Unreachable(
                        System.getProperty("rsal.python") != null
                                ? "The Python package has no documentation site. A release has one, and a clone builds it."
                                : "The documentation is built by the launcher in the project's folder: ./rsal docs"
                                        + (serve ? " --serve" : "")));
        out().println(site);
        out().flush();
        if (serve) {
            serve(site);
        }
        return Exit.SUCCESS;
    }

    private void serve(Path site) throws InterruptedException {
        var address = new InetSocketAddress(InetAddress.getLoopbackAddress(), PORT);
        try {
            SimpleFileServer.createFileServer(address, site, OutputLevel.NONE).start();
        } catch (UncheckedIOException e) {
            throw new Unreachable(
                    e.getCause() instanceof BindException
                            ? "Port %d is in use. Is the documentation served already?".formatted(PORT)
                            : "The documentation can't be served: %s.".formatted(e.getCause()));
        }
        err().println("rsal: the documentation is at http://127.0.0.1:%d/ until Ctrl-C".formatted(PORT));
        Thread.currentThread().join();
    }
}
