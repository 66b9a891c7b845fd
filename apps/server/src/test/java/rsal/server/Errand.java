package rsal.server;

import java.io.IOException;
import java.net.URISyntaxException;
import java.nio.file.Files;
import java.nio.file.Path;
import rsal.scenario.RunOptions;
import rsal.scenario.RunPlan;
import rsal.scenario.Scenario;

/// A small scenario, and a server that shows it.
final class Errand {
    static final String TOKEN = "the-token";

    private Errand() {}

    static RunPlan plan() {
        return plan("errand.yaml", RunOptions.NONE);
    }

    static RunPlan plan(String name, RunOptions options) {
        try {
            Path file = Path.of(Errand.class.getResource(name).toURI());
            return Scenario.load(file.toString()).plan(options);
        } catch (URISyntaxException e) {
            throw new AssertionError(e);
        }
    }

    static RunServer serve(Path directory, int port) throws IOException, PortInUse {
        return serve("errand.yaml", directory, port);
    }

    static RunServer serve(String name, Path directory, int port) throws IOException, PortInUse {
        Files.writeString(directory.resolve("index.html"), "<!doctype html><title>The page</title>");
        Path assets = Files.createDirectories(directory.resolve("assets"));
        Files.writeString(assets.resolve("index-1a2b.js"), "/* the page's code */");
        return RunServer.start(plan(name, RunOptions.NONE), new RunServer.Options(port, TOKEN, directory, run -> {}));
    }
}
