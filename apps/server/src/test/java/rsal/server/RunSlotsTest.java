package rsal.server;

import static org.assertj.core.api.Assertions.assertThat;
import static rsal.server.Errand.TOKEN;

import java.io.IOException;
import java.net.http.HttpClient;
import java.net.http.WebSocket;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionStage;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import java.util.function.Predicate;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import rsal.engine.LiveRun;
import rsal.engine.report.Snapshot;
import rsal.scenario.RunOptions;
import rsal.scenario.RunPlan;
import rsal.scenario.Scenario;
import rsal.server.RawHttp.Response;
import rsal.server.live.Live;
import rsal.server.message.Json;
import rsal.server.message.Messages.SeatInfo;
import rsal.server.message.Messages.SideBySide;

@Timeout(120)
class RunSlotsTest {
    private static final String WITH_TOKEN = "Authorization: Bearer " + TOKEN;
    private static final String GUARD = """
            rsal: 1
            scenario: guard
            title: Robots wander
            arguments:
              guards: {type: integer, default: 2, min: 1, max: 4, description: How many robots wander.}
            world: {map: office}
            robots:
              guard: {count: $guards, model: pioneer2dx, pose: {free: true}, devices: {laser: urg04lx, pilot: {}}}
            agents: {wander: {type: wander, robot: guard}}
            run: {seed: 11, clock: {mode: simulated, speed: max}, stop: [{when: time > 60, outcome: success}]}
            configurations:
              pair: {}
              alone: {arguments: {guards: 1}}
              real: {run: {clock: {mode: wall}}}
            """;

    @TempDir
    private Path directory;

    private RunServer server;
    private int port;
    private String host;

    @BeforeEach
    void start() throws IOException, PortInUse {
        serve(Errand.plan());
    }

    @AfterEach
    void stop() {
        server.close();
    }

    private void serve(RunPlan plan) throws IOException, PortInUse {
        if (server != null) {
            server.close();
        }
        Files.writeString(directory.resolve("index.html"), "<!doctype html><title>The page</title>");
        Files.writeString(directory.resolve("beside.html"), "<!doctype html><title>All of them</title>");
        server = RunServer.start(plan, new RunServer.Options(0, TOKEN, directory, _ -> {}));
        port = server.url().getPort();
        host = "Host: 127.0.0.1:" + port;
    }

    private Response get(String path) throws IOException {
        return RawHttp.get(port, path, host);
    }

    private Response post(String path, String body) throws IOException {
        return RawHttp.post(port, path, body, host, WITH_TOKEN);
    }

    private Response close(int number) throws IOException {
        return RawHttp.delete(port, "/api/beside/" + number, host, WITH_TOKEN);
    }

    /// @return its number
    private int open(String wish) throws IOException {
        Response response = post("/api/beside", wish);
        assertThat(response.status()).as(response.body()).isEqualTo(200);
        return Json.read(response.body(), SeatInfo.class).number();
    }

    private List<SeatInfo> all() throws IOException {
        return Json.read(get("/api/beside").body(), SideBySide.class).runs();
    }

    private LiveRun run(int number) {
        return server.seats().all().stream()
                .filter(seat -> seat.number() == number)
                .findFirst()
                .orElseThrow()
                .now()
                .run();
    }

    private static Snapshot await(LiveRun run, Predicate<Snapshot> wanted) throws InterruptedException {
        while (true) {
            var news = new CountDownLatch(1);
            try (var _ = run.onSnapshot(news::countDown)) {
                Snapshot snapshot = run.snapshot();
                if (wanted.test(snapshot)) {
                    return snapshot;
                }
                news.await();
            }
        }
    }

    @Test
    void isAloneAtFirst() throws IOException {
        SideBySide alone = Json.read(get("/api/beside").body(), SideBySide.class);
        assertThat(alone.most()).isEqualTo(4);
        assertThat(alone.runs()).singleElement().satisfies(first -> {
            assertThat(first.number()).isEqualTo(1);
            assertThat(first.title()).isEqualTo("Robots wait for errands");
            assertThat(first.outcome()).isEmpty();
        });
    }

    @Test
    void beginsAnotherBesideAsAskedForAndLeavesTheFirstAlone() throws Exception {
        LiveRun first = server.run();
        assertThat(open("{\"configuration\":\"pair\",\"arguments\":{\"couriers\":\"3\"}}"))
                .isEqualTo(2);
        assertThat(all()).extracting(SeatInfo::configuration).containsExactly("one", "pair");
        assertThat(all()).extracting(SeatInfo::seed).containsExactly("7", "7");
        assertThat(all().getLast().typed()).containsEntry("couriers", "3");
        assertThat(server.run()).isSameAs(first);
        await(run(1), snapshot -> snapshot.robots().size() == 1);
        await(run(2), snapshot -> snapshot.robots().size() == 3);
    }

    @Test
    void takesWhatIsLeftOutFromTheRunThatIsAsked() throws IOException {
        open("{\"configuration\":\"pair\",\"seed\":\"12\"}");
        Response response = post("/beside/2/api/beside", "{\"seed\":\"13\"}");
        assertThat(response.body()).contains("\"number\":3", "\"configuration\":\"pair\"", "\"seed\":\"13\"");
    }

    @Test
    void servesThePageAndAllThatItAsksForBelowItsAddress() throws Exception {
        open("{\"configuration\":\"pair\"}");
        assertThat(get("/beside/2/").body()).contains("The page");
        assertThat(get("/beside.html").body()).contains("All of them");
        assertThat(get("/beside/2/api/run").body()).contains("\"configuration\":\"pair\"");
        assertThat(get("/api/run").body()).contains("\"configuration\":\"one\"");
        assertThat(get("/beside/2/api/map/1").status()).isEqualTo(200);
        assertThat(get("/beside/2/api/sweeps").status()).isEqualTo(200);
        await(run(2), snapshot -> snapshot.robots().size() == 2);
        assertThat(get("/beside/2/api/status").body()).contains("courier-2", "\"agents\":[{\"name\":\"");
        assertThat(get("/beside/2/api/abilities?robot=courier-2").status()).isEqualTo(200);
        assertThat(get("/api/abilities?robot=courier-2").status()).isEqualTo(409);
        for (String path : List.of(
                "/beside/2",
                "/beside/3/",
                "/beside/1/",
                "/beside/x/",
                "/beside/2/nothing",
                "/beside/2/../../secret",
                "/beside/-1/api/run",
                "/beside/3/api/run",
                "/beside/%s/".formatted("9".repeat(300)))) {
            assertThat(get(path).status()).as(path).isBetween(400, 404);
        }
    }

    @Test
    void asksEachOfThemWhatItIsToDo() throws Exception {
        open("{}");
        assertThat(post("/beside/2/api/run/pause", "").status()).isEqualTo(200);
        await(run(2), Snapshot::paused);
        assertThat(run(1).freshSnapshot().toCompletableFuture().get().paused()).isFalse();
        assertThat(post("/beside/2/api/run/restart", "{\"configuration\":\"pair\"}")
                        .body())
                .contains("\"number\":2", "\"configuration\":\"pair\"");
        assertThat(all()).extracting(SeatInfo::configuration).containsExactly("one", "pair");
    }

    @Test
    void stopsTheRobotsOfAllWhereverItIsAsked() throws Exception {
        open("{}");
        open("{}");
        assertThat(post("/beside/3/api/run/estop", "").status()).isEqualTo(200);
        assertThat(List.of(isStopped(1), isStopped(2), isStopped(3))).containsOnly(true);
        assertThat(post("/beside/2/api/run/rearm", "").status()).isEqualTo(200);
        assertThat(List.of(isStopped(1), isStopped(2), isStopped(3))).containsExactly(true, false, true);
        assertThat(all()).extracting(SeatInfo::stopped).containsExactly(true, false, true);

        post("/beside/2/api/run/stop", "");
        run(2).result().toCompletableFuture().get();
        post("/api/run/rearm", "");
        assertThat(post("/beside/2/api/run/estop", "").status()).isEqualTo(200);
        assertThat(isStopped(1)).isTrue();

        post("/api/run/stop", "");
        post("/beside/3/api/run/stop", "");
        run(1).result().toCompletableFuture().get();
        run(3).result().toCompletableFuture().get();
        assertThat(post("/api/run/estop", "").status()).isEqualTo(200); // nothing moves: that is what was asked for
    }

    /// The old run holds the restart up, as its end waits for whoever looks at it.
    @Test
    void beginsNoRunThatWasAskedForBeforeAnEmergencyStop() throws Exception {
        var blocked = new CountDownLatch(1);
        var released = new CountDownLatch(1);
        try (ExecutorService people = Executors.newVirtualThreadPerTaskExecutor();
                var _ = run(1).onSnapshot(() -> {
                    blocked.countDown();
                    awaitQuietly(released);
                })) {
            blocked.await();
            Future<Response> restarted = people.submit(() -> post("/api/run/restart", "{}"));
            LiveRun old = run(1);
            ServerClock.await().until(RunSlotsTest::isEnding);
            Future<Response> stopped = people.submit(() -> post("/api/run/estop", ""));
            ServerClock.await().until(() -> server.seats().stops() > 0);
            released.countDown();
            stopped.get();
            assertThat(restarted.get().status()).isEqualTo(409);
            assertThat(restarted.get().body()).contains("An emergency stop came after this was asked for");
            assertThat(run(1)).isSameAs(old);
            assertThat(old.result().toCompletableFuture()).isCompleted();
        }
        assertThat(post("/api/run/restart", "{}").status()).isEqualTo(200);
        assertThat(isStopped(1)).isFalse();
    }

    /// Whether somebody has begun to end a run.
    private static boolean isEnding() {
        return Thread.getAllStackTraces().values().stream()
                .flatMap(Arrays::stream)
                .anyMatch(frame -> frame.getClassName().equals(LiveRun.class.getName())
                        && frame.getMethodName().equals("close"));
    }

    @Test
    void saysWhichRunDoesNotConfirmAnEmergencyStop() throws Exception {
        open("{}");
        var blocked = new CountDownLatch(1);
        var released = new CountDownLatch(1);
        try (var _ = run(2).onSnapshot(() -> {
            blocked.countDown();
            awaitQuietly(released);
        })) {
            blocked.await();
            Response late = post("/api/run/estop", "");
            assertThat(late.status()).isEqualTo(409);
            assertThat(late.body()).contains("Run 2 was asked to stop and has not confirmed it within 1 s");
            assertThat(isStopped(1)).isTrue();
            released.countDown();
        }
        await(run(2), Snapshot::stopped);
    }

    private static void awaitQuietly(CountDownLatch latch) {
        try {
            latch.await();
        } catch (InterruptedException e) {
            throw new AssertionError(e);
        }
    }

    private boolean isStopped(int number) throws Exception {
        return run(number).freshSnapshot().toCompletableFuture().get().stopped();
    }

    @Test
    void isBoundedAndUsesNoNumberTwice() throws IOException {
        assertThat(List.of(open("{}"), open("{}"), open("{}"))).containsExactly(2, 3, 4);
        Response refused = post("/api/beside", "{}");
        assertThat(refused.status()).isEqualTo(409);
        assertThat(refused.body()).contains("4 runs are side by side already");
        assertThat(close(3).status()).isEqualTo(200);
        assertThat(open("{}")).isEqualTo(5);
        assertThat(all()).extracting(SeatInfo::number).containsExactly(1, 2, 4, 5);
        assertThat(get("/beside/3/api/run").status()).isEqualTo(404);
        assertThat(get("/beside/3/api/control").status()).isEqualTo(404);
        assertThat(get("/beside/3/api/costs?robot=courier-1&run=1").status()).isEqualTo(404);
    }

    @Test
    void endsTheRunThatIsClosedAndInformsItsViewers() throws Exception {
        open("{}");
        LiveRun second = run(2);
        var reported = new CompletableFuture<String>();
        try (HttpClient http = HttpClient.newHttpClient()) {
            WebSocket viewer = http.newWebSocketBuilder()
                    .buildAsync(java.net.URI.create("ws://127.0.0.1:" + port + "/beside/2/api/live"), closing(reported))
                    .get();
            assertThat(close(2).status()).isEqualTo(200);
            assertThat(reported.get()).isEqualTo(Live.CLOSED + " This run was closed.");
            assertThat(second.result().toCompletableFuture().get().outcome()).isEqualTo("stopped");
            viewer.abort();
        }
        assertThat(close(2).status()).isEqualTo(404);
        assertThat(close(1).body()).contains("The first run can't be closed");
        assertThat(server.run().result().toCompletableFuture()).isNotDone();
    }

    private static WebSocket.Listener closing(CompletableFuture<String> reported) {
        return new WebSocket.Listener() {
            @Override
            public CompletionStage<?> onClose(WebSocket socket, int status, String reason) {
                reported.complete(status + " " + reason);
                return CompletableFuture.completedFuture(null);
            }
        };
    }

    @Test
    void isOpenToChangesOnlyWithTheTokenAndToNoPageOfOthers() throws IOException {
        open("{}");
        String foreign = "Origin: http://evil.example";
        assertThat(RawHttp.post(port, "/api/beside", "{}", host).status()).isEqualTo(401);
        assertThat(RawHttp.delete(port, "/api/beside/2", host).status()).isEqualTo(401);
        assertThat(RawHttp.post(port, "/beside/2/api/run/pause", "", host).status())
                .isEqualTo(401);
        assertThat(RawHttp.post(port, "/api/beside", "{}", host, WITH_TOKEN, foreign)
                        .status())
                .isEqualTo(403);
        assertThat(RawHttp.get(port, "/beside/2/", host, foreign).status()).isEqualTo(403);
        for (String path : List.of("/beside/2/api/live", "/beside/9/api/live", "/beside/2/x")) {
            assertThat(RawHttp.upgradeAt(port, path, host, foreign).status())
                    .as(path)
                    .isEqualTo(403);
        }
        assertThat(RawHttp.upgradeAt(port, "/beside/2/api/live", host).status()).isEqualTo(101);
        assertThat(RawHttp.upgradeAt(port, "/beside/9/api/live", host).status()).isEqualTo(404);
        assertThat(RawHttp.upgradeAt(port, "/beside/2/x", host).status()).isEqualTo(404);
        assertThat(all()).hasSize(2);
    }

    @ParameterizedTest
    @ValueSource(strings = {"{\"seed\":\"x\"}", "{\"configuration\":\"trio\"}", "{\"speed\":\"fast\"}"})
    void changesNothingWhenItIsInvalid(String wish) throws IOException {
        assertThat(post("/api/beside", wish).status()).isEqualTo(422);
        assertThat(all()).hasSize(1);
    }

    @Test
    void hasNothingBesideWhatGoesInRealTime() throws Exception {
        serve(guards());
        open("{}");
        String real = "{\"configuration\":\"real\"}";
        assertThat(post("/api/beside", real).body()).contains("would delay it. Restart instead");
        for (String path : List.of("/api/run/restart", "/beside/2/api/run/restart")) {
            Response refused = post(path, real);
            assertThat(refused.status()).isEqualTo(409);
            assertThat(refused.body()).contains("would delay it. Close those first");
        }
        assertThat(all()).extracting(SeatInfo::configuration).containsExactly("pair", "pair");

        close(2);
        assertThat(post("/api/run/restart", real).status()).isEqualTo(200);
        Response refused = post("/api/beside", "{\"configuration\":\"pair\"}");
        assertThat(refused.status()).isEqualTo(409);
        assertThat(refused.body()).contains("The run is in real time");
        assertThat(all()).hasSize(1);

        post("/api/run/stop", "");
        run(1).result().toCompletableFuture().get();
        open("{\"configuration\":\"pair\"}");
    }

    @Test
    void goesAsItWouldAlone() throws Exception {
        RunPlan plan = guards();
        String alone;
        try (LiveRun run = LiveRun.start(plan)) {
            alone = run.result().toCompletableFuture().get().eventHash();
        }
        serve(plan);
        open("{}");
        open("{\"configuration\":\"alone\"}");
        assertThat(List.of(hash(1), hash(2))).containsOnly(alone);
        assertThat(hash(3)).isNotEqualTo(alone);
    }

    private RunPlan guards() throws IOException {
        Path file = Files.writeString(directory.resolve("guard.yaml"), GUARD);
        return Scenario.load(file.toString()).plan(RunOptions.NONE);
    }

    private String hash(int number) throws Exception {
        return run(number).result().toCompletableFuture().get().eventHash();
    }

    @Test
    void endsAllWithTheServer() throws Exception {
        open("{}");
        open("{}");
        List<LiveRun> runs = List.of(run(1), run(2), run(3));
        server.close();
        for (LiveRun run : runs) {
            assertThat(run.result().toCompletableFuture().get().outcome()).isEqualTo("stopped");
        }
    }
}
