package rsal.foxglove;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.net.BindException;
import java.net.URI;
import java.nio.ByteBuffer;
import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.Optional;
import java.util.Random;
import java.util.Set;
import java.util.concurrent.CompletionException;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import rsal.data.Pose2d;
import rsal.engine.LiveRun;
import rsal.engine.report.RunResult;
import rsal.recording.Origin;
import rsal.scenario.RunOptions;
import rsal.scenario.RunPlan;
import rsal.scenario.Scenario;
import tools.jackson.databind.JsonNode;

class FoxgloveServerTest {
    private static final String TOKEN = "a-token_1";
    private static final String POSE = """
            {"header": {"frame_id": "map"}, "pose": {"position": {"x": %s, "y": %s, "z": 0}, "orientation": {"z": 0, "w": 1}}}""";

    private final FoxgloveServer server;

    FoxgloveServerTest() throws Exception {
        server = FoxgloveServer.start(0, TOKEN);
    }

    @AfterEach
    void close() {
        server.close();
    }

    @Test
    void showsWhatHappensToWhoComesLate() throws Exception {
        RunPlan plan = plan(Double.POSITIVE_INFINITY, 5);
        RunResult watched = end(start(plan));
        try (var watcher = new Watcher(server.url(), "https://app.foxglove.dev", "foxglove.sdk.v1")) {
            assertThat(watcher.protocol()).isEqualTo("foxglove.sdk.v1");
            JsonNode info = watcher.await("serverInfo");
            assertThat(info.path("capabilities").toString()).contains("time", "clientPublish");
            assertThat(info.path("supportedEncodings").toString()).contains("json");
            assertThat(info.path("metadata").path("seed").asString()).isEqualTo("7");

            String robot = plan.robots().getFirst().spec().id();
            watcher.subscribe(10, "/map");
            watcher.subscribe(11, "/world");
            watcher.subscribe(12, "/" + robot + "/scan");
            ByteBuffer time = watcher.await(next -> next.get(0) == 2);
            assertThat(time.remaining()).isEqualTo(9);
            assertThat(time.getLong(1)).isBetween(0L, Duration.ofSeconds(5).toNanos());
            assertThat(watcher.await(10).remaining()).isGreaterThan(1000);
            var wanted = new HashSet<>(Set.of(10));
            while (wanted.size() < 3) {
                ByteBuffer message = watcher.await(next -> next.get(0) == 1);
                wanted.add(message.getInt(1));
                assertThat(message.getInt(1)).isBetween(10, 12); // nothing that it does not want
            }
        }
        assertThat(watched.eventHash()).isEqualTo(end(LiveRun.start(plan)).eventHash());
    }

    @Test
    void whatHappenedBeforeItCameIsSentToWhoComesAfterTheEnd() throws Exception {
        LiveRun run = start(plan(Double.POSITIVE_INFINITY, 30));
        end(run);
        int happened = run.events(0).size();
        assertThat(happened).isPositive();
        for (int time = 0; time < 2; time++) { // all who come
            try (var watcher = new Watcher(server.url())) {
                watcher.subscribe(1, "/events");
                for (int i = 0; i < happened; i++) {
                    watcher.await(1);
                }
                watcher.subscribe(2, "/log");
                for (int i = 0; i < happened; i++) {
                    watcher.await(next -> next.get(0) == 1 && isNotAgain(next)); // what was told is not told again
                }
            }
        }
    }

    private static boolean isNotAgain(ByteBuffer message) {
        assertThat(message.getInt(1)).isEqualTo(2);
        return true;
    }

    @Test
    void eventsAreOfferedBeforeAnyHappens() throws Exception {
        LiveRun run = LiveRun.start(plan(1, 60)); // which tells the server nothing
        server.next(new Origin(run.plan(), "rsal test", "rsal run", Instant.EPOCH));
        server.began(run);
        try (var watcher = new Watcher(server.url())) {
            watcher.channel("/events");
            watcher.channel("/log");
        }
        run.close();
    }

    @Test
    void aRunThatIsWatchedIsTheSame() throws Exception {
        RunPlan plan = plan(4, 6);
        LiveRun run = start(plan);
        try (var watcher = new Watcher(server.url())) {
            watcher.subscribe(1, "/state");
            watcher.subscribe(2, "/messages");
            watcher.await(1);
            assertThat(run.result().toCompletableFuture()).isNotDone();
            RunResult watched = end(run);
            watcher.await(2);
            assertThat(watched.eventHash()).isEqualTo(end(LiveRun.start(plan)).eventHash());
        }
    }

    @Test
    void whatIsNoLongerWantedDoesNotCome() throws Exception {
        start(plan(1, 60));
        try (var watcher = new Watcher(server.url())) {
            watcher.subscribe(1, "/tf");
            watcher.subscribe(2, "/state");
            watcher.await(1);
            watcher.await(2);
            watcher.send("{\"op\": \"unsubscribe\", \"subscriptionIds\": [1]}");
            watcher.send("{\"op\": \"nonsense\"}");
            watcher.await("status"); // it was read
            watcher.await(2);
            watcher.bytes.clear();
            for (int i = 0; i < 5; i++) {
                assertThat(watcher.await(next -> next.get(0) == 1).getInt(1)).isEqualTo(2);
            }
        }
    }

    @Test
    void takesGoalsAndPosesFromWhoKnowsTheToken() throws Exception {
        RunPlan plan = plan(1, 60);
        String robot = plan.robots().getFirst().spec().id();
        LiveRun run = start(plan);
        try (var watcher = new Watcher(server.url())) {
            watcher.send("""
                    {"op": "advertise", "channels": [
                        {"id": 3, "topic": "/%s/initialpose", "encoding": "json", "schemaName": "geometry_msgs/PoseStamped"},
                        {"id": 4, "topic": "/nobody/goal", "encoding": "json", "schemaName": ""},
                        {"id": 5, "topic": "/goal_pose", "encoding": "json", "schemaName": ""}]}""".formatted(robot));
            watcher.channel("/state");
            run.pause();
            Pose2d there = truth(run);
            watcher.publish(3, POSE.formatted(there.x() + 0.25, there.y()));
            assertThat(status(watcher)).contains(robot, "is at");
            assertThat(truth(run).x()).isCloseTo(there.x() + 0.25, within(0.2));
            watcher.publish(4, POSE.formatted(0, 0));
            assertThat(status(watcher)).contains("nobody");
            watcher.publish(5, POSE.formatted(0, 0));
            assertThat(status(watcher)).contains("robots", "/" + robot + "/goal");
            watcher.publish(3, POSE.formatted(0, "\"far\""));
            assertThat(status(watcher)).contains("position.y");
            server.heed(() -> Optional.of("Anna has control."));
            Pose2d now = truth(run);
            watcher.publish(3, POSE.formatted(now.x() + 0.25, now.y()));
            assertThat(status(watcher)).contains("Anna has control.");
            assertThat(truth(run)).isEqualTo(now);
            server.heed(Optional::empty);
            watcher.publish(99, POSE.formatted(0, 0));
            assertThat(status(watcher)).contains("advertise");
        }
        URI withoutToken =
                URI.create("ws://localhost:%d/".formatted(server.url().getPort()));
        try (var watcher = new Watcher(withoutToken)) {
            assertThat(watcher.await("serverInfo").path("capabilities").toString())
                    .doesNotContain("clientPublish");
            watcher.send("""
                    {"op": "advertise", "channels": [{"id": 3, "topic": "/%s/goal", "encoding": "json"}]}""".formatted(robot));
            assertThat(status(watcher)).contains("token");
            watcher.publish(3, POSE.formatted(0, 0));
            assertThat(status(watcher)).contains("advertise");
        }
    }

    @Test
    void pagesWithoutTheTokenAndOtherProtocolsAreNotLetIn() throws Exception {
        start(plan(1, 60));
        URI withoutToken =
                URI.create("ws://localhost:%d/".formatted(server.url().getPort()));
        URI withAnother = URI.create(
                "ws://localhost:%d/?token=guessed".formatted(server.url().getPort()));
        assertThatThrownBy(() -> new Watcher(withoutToken, "https://evil.example", "foxglove.websocket.v1"))
                .isInstanceOf(CompletionException.class);
        assertThatThrownBy(() -> new Watcher(withAnother, null, "foxglove.websocket.v1"))
                .isInstanceOf(CompletionException.class);
        assertThatThrownBy(() -> new Watcher(server.url(), null, "chat")).isInstanceOf(CompletionException.class);
    }

    @Test
    void nonsenseIsReportedAndHarmsNobody() throws Exception {
        start(plan(1, 60));
        var random = new Random(1);
        try (var other = new Watcher(server.url());
                var watcher = new Watcher(server.url())) {
            other.subscribe(1, "/state");
            int channel = watcher.channel("/state");
            watcher.texts.clear();
            for (int i = 0; i < 300; i++) {
                byte[] bytes = new byte[random.nextInt(40)];
                random.nextBytes(bytes);
                watcher.send(bytes);
                watcher.send(nonsense(random, channel));
            }
            assertThat(status(watcher)).isNotBlank();
            watcher.send("""
                    {"op": "unsubscribe", "subscriptionIds": [1, 2, 3, 4, 5, 6, 7]}""");
            watcher.subscribe(77, "/tf");
            watcher.await(77);
            other.bytes.clear();
            other.await(1);
        }
    }

    private static String nonsense(Random random, int channel) {
        String[] pieces = {
            "{",
            "}",
            "[",
            "]",
            "\"op\":",
            "\"subscribe\"",
            "\"subscriptions\":",
            "\"id\":",
            "-1",
            "1e99",
            ",",
            "null",
            "\"channelId\":",
            "\"advertise\"",
            "\"channels\":",
            "{\"id\":1}",
            "\"topic\":",
            "\"/r/goal\""
        };
        if (random.nextInt(4) == 0) {
            return """
                    {"op": "subscribe", "subscriptions": [{"id": %d, "channelId": %d}, 7, null, {"id": "x"}]}""".formatted(random.nextInt(8), channel + random.nextInt(3) - 1);
        }
        var text = new StringBuilder();
        for (int i = random.nextInt(12); i >= 0; i--) {
            text.append(pieces[random.nextInt(pieces.length)]);
        }
        return text.toString();
    }

    @Test
    void showsWhatIsDoneToAPausedRun() throws Exception {
        LiveRun run = start(plan(1, 60));
        try (var watcher = new Watcher(server.url())) {
            watcher.subscribe(1, "/tf");
            ByteBuffer before = payload(watcher.await(1));
            run.pause();
            for (ByteBuffer next = payload(watcher.await(1)); !next.equals(before); next = payload(watcher.await(1))) {
                before = next; // it has not yet paused
            }
            ByteBuffer still = before;
            Pose2d there = truth(run);
            String robot = run.plan().robots().getFirst().spec().id();
            run.operator()
                    .place(robot, new Pose2d(there.x() + 0.25, there.y(), there.theta()))
                    .toCompletableFuture()
                    .join();
            watcher.await(message -> message.get(0) == 1
                    && message.getInt(1) == 1
                    && !payload(message).equals(still));
        }
    }

    private static ByteBuffer payload(ByteBuffer message) {
        return message.slice(13, message.limit() - 13); // after its head
    }

    @Test
    void anotherRunLetsAllGo() throws Exception {
        LiveRun first = start(plan(1, 60));
        try (var watcher = new Watcher(server.url())) {
            String session = watcher.await("serverInfo").path("sessionId").asString();
            watcher.channel("/state");
            first.close();
            start(plan(1, 60));
            assertThat(watcher.closed.get(20, TimeUnit.SECONDS)).isEqualTo(1001);
            try (var again = new Watcher(server.url())) {
                assertThat(again.await("serverInfo").path("sessionId").asString())
                        .isNotEqualTo(session);
                again.subscribe(1, "/state");
                again.await(1);
            }
        }
    }

    @Test
    void whoKnowsTheTokenTakesAPlaceOfWhoDoesNot() throws Exception {
        start(plan(1, 60));
        URI withoutToken = URI.create(server.url().toString().replaceFirst("\\?.*", ""));
        var watchers = new ArrayList<Watcher>();
        try {
            for (int i = 0; i < FoxgloveServer.MAX_CLIENTS; i++) {
                watchers.add(watching(withoutToken));
            }
            var stranger = new Watcher(withoutToken);
            watchers.add(stranger);
            assertThat(stranger.closed.get(20, TimeUnit.SECONDS)).isEqualTo(1013);
            for (int i = 0; i < FoxgloveServer.MAX_CLIENTS; i++) {
                watchers.add(watching(server.url()));
                assertThat(watchers.get(i).closed.get(20, TimeUnit.SECONDS))
                        .as("who has been there longest without it leaves")
                        .isEqualTo(1013);
            }
            var first = watchers.get(FoxgloveServer.MAX_CLIENTS + 1);
            assertThat(first.closed).isNotDone();
            watchers.add(watching(server.url()));
            assertThat(first.closed.get(20, TimeUnit.SECONDS))
                    .as("all know it: who has been there longest leaves")
                    .isEqualTo(1013);
        } finally {
            watchers.forEach(Watcher::close);
        }
    }

    private static Watcher watching(URI url) throws Exception {
        var watcher = new Watcher(url);
        watcher.channel("/state");
        return watcher;
    }

    @Test
    void aPortIsNotSharedByTwo() {
        assertThatThrownBy(() -> FoxgloveServer.start(server.url().getPort(), TOKEN))
                .isInstanceOf(BindException.class);
    }

    private LiveRun start(RunPlan plan) {
        var origin = new Origin(plan, "rsal test", "rsal run", Instant.EPOCH);
        LiveRun run = LiveRun.of(plan).observer(server.next(origin)).start();
        server.began(run);
        return run;
    }

    private static RunPlan plan(double speed, int seconds) {
        return Scenario.load("hunt-and-prey")
                .plan(RunOptions.NONE.withSeed(7).withSpeed(speed).withLimit(Duration.ofSeconds(seconds)));
    }

    private static RunResult end(LiveRun run) throws Exception {
        return run.result().toCompletableFuture().get(100, TimeUnit.SECONDS);
    }

    /// Where the first robot is, from now on.
    private static Pose2d truth(LiveRun run) throws InterruptedException {
        var made = new CountDownLatch(1);
        try (var _ = run.onSnapshot(made::countDown)) {
            run.snapshot();
            assertThat(made.await(20, TimeUnit.SECONDS)).isTrue();
        }
        return run.snapshot().robots().getFirst().truth().orElseThrow();
    }

    private static String status(Watcher watcher) throws InterruptedException {
        return watcher.await("status").path("message").asString();
    }
}
