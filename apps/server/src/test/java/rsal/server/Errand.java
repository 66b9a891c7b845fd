package rsal.server;

import java.io.IOException;
import java.net.URISyntaxException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.zip.GZIPOutputStream;
import rsal.engine.LiveRun;
import rsal.scenario.RunOptions;
import rsal.scenario.RunPlan;
import rsal.scenario.Scenario;

/// A small scenario, and a server that shows it.
public final class Errand {
    static final String TOKEN = "the-token";
    private static final List<String> SCENARIOS = List.of("hunt-and-prey", "teleop");

    private Errand() {}

    public static RunPlan plan() {
        return plan("errand.yaml", RunOptions.NONE);
    }

    public static RunPlan plan(String name, RunOptions options) {
        try {
            Path file = Path.of(Errand.class.getResource(name).toURI());
            return Scenario.load(file.toString()).plan(options);
        } catch (URISyntaxException e) {
            throw new AssertionError(e);
        }
    }

    public static RunServer serve(Path directory, int port) throws IOException, PortInUse {
        return serve("errand.yaml", directory, port);
    }

    /// Where sweeps are kept that are begun in the page.
    static Path sweeps(Path directory) {
        return directory.resolve("sweeps");
    }

    public static RunServer serve(String name, Path directory, int port) throws IOException, PortInUse {
        Files.writeString(directory.resolve("index.html"), "<!doctype html><title>The page</title>");
        Path assets = Files.createDirectories(directory.resolve("assets"));
        Files.writeString(assets.resolve("index-1a2b.js"), "/* the page's code */");
        try (var packed = new GZIPOutputStream(Files.newOutputStream(assets.resolve("index-1a2b.js.gz")))) {
            packed.write("/* the page's code */".getBytes(StandardCharsets.UTF_8));
        }
        var options = new RunServer.Options(
                port,
                TOKEN,
                directory,
                SCENARIOS,
                run -> {},
                LiveRun::start,
                Optional::empty,
                Optional.of(new RunServer.Sweeping(sweeps(directory), "test")));
        return RunServer.start(plan(name, RunOptions.NONE), options);
    }
}
