package rsal.cli.start;

import java.io.IOException;
import java.nio.file.Path;
import java.util.Map;
import picocli.CommandLine.Command;
import rsal.cli.terminal.Exit;
import rsal.cli.terminal.Subcommand;
import rsal.cli.terminal.Unreachable;

/// `rsal prepare`
@Command(
        name = "prepare",
        description = "Make the cache for fast starts of an unpacked release, and print its folder. The first start of"
                + " a release does so in the background. Use this command when you prepare container"
                + " images, or the machines of a lab.")
public final class PrepareCommand extends Subcommand {
    @Override
    protected int run() throws InterruptedException {
        StartCache cache = StartCache.ofThisProcess().orElseThrow(() -> new Unreachable(whyNone()));
        try {
            if (!cache.make()) {
                throw new Unreachable("The cache '%s' was not made: another process makes it, or Java can't."
                        .formatted(cache.file()));
            }
        } catch (IOException e) {
            throw new Unreachable("The cache '%s' can't be written: %s.".formatted(cache.file(), e));
        }
        if (json) {
            printJson(Map.of("cache", cache.file().toString()));
        } else {
            out().println(cache.file());
            out().flush();
        }
        return Exit.SUCCESS;
    }

    /// Why the script of a release has named no cache.
    private static String whyNone() {
        String docs = System.getProperty("rsal.docs"); // only the script of a release names them
        if (docs == null && System.getProperty("rsal.python") != null) { // the command of a Python package names it
            return "off".equals(System.getenv("RSAL_CACHE"))
                    ? "There is no cache, since RSAL_CACHE is 'off'."
                    : "Your cache folder can't be written. RSAL_CACHE=FOLDER names another folder.";
        }
        if (docs == null) {
            return "This is not an unpacked release: a clone makes its cache when it builds.";
        }
        String chosen = System.getenv("RSAL_CACHE");
        if ("off".equals(chosen)) {
            return "There is no cache, since RSAL_CACHE is 'off'.";
        }
        return "Neither '%s' nor your cache folder can be written. RSAL_CACHE=FOLDER names another folder."
                .formatted(chosen == null || chosen.isEmpty() ? Path.of(docs).resolveSibling("cache") : chosen);
    }
}
