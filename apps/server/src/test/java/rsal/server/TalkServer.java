package rsal.server;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import java.util.List;
import java.util.function.Predicate;
import java.util.stream.StreamSupport;
import rsal.engine.LiveRun;
import rsal.engine.report.Snapshot;
import rsal.server.RawHttp.Response;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.ObjectMapper;

/// A server of a paused run whose agents talk, and what it tells those who ask.
final class TalkServer implements AutoCloseable {
    private static final ObjectMapper JSON = new ObjectMapper();
    private static final double STEP = 0.1; // [s]

    private final RunServer server;
    private final int port;
    private final String host;

    /// @param directory of the page
    TalkServer(Path directory) throws Exception {
        server = Errand.serve("talk.yaml", directory, 0);
        server.run().pause();
        port = server.url().getPort();
        host = "Host: 127.0.0.1:" + port;
    }

    LiveRun run() {
        return server.run();
    }

    int port() {
        return port;
    }

    /// The line of a request that names it.
    String host() {
        return host;
    }

    JsonNode get(String path) throws Exception {
        Response response = RawHttp.get(port, path, host);
        assertThat(response.status()).as(response.body()).isEqualTo(200);
        return JSON.readTree(response.body());
    }

    /// Lets the run come so far, step by step, and stand still there.
    void advanceTo(double seconds) {
        Snapshot before = reached(Snapshot::paused);
        double left = seconds - before.time().toMillis() / 1000.0;
        for (int i = 0; i < left / STEP - 1e-6; i++) { // not one more, by rounding
            server.run().step();
        }
        reached(now -> now.time().toMillis() >= 1000 * seconds);
    }

    private Snapshot reached(Predicate<Snapshot> wanted) {
        return server.run().when(wanted).toCompletableFuture().join();
    }

    static List<JsonNode> each(JsonNode list) {
        return StreamSupport.stream(list.spliterator(), false).toList();
    }

    @Override
    public void close() {
        server.close();
    }
}
