package rsal.server;

import static org.assertj.core.api.Assertions.assertThat;
import static rsal.server.Errand.TOKEN;

import io.prometheus.metrics.expositionformats.PrometheusTextFormatWriter;
import io.prometheus.metrics.model.snapshots.MetricSnapshots;
import java.io.ByteArrayOutputStream;
import java.net.URI;
import java.net.http.HttpClient;
import java.net.http.WebSocket;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.CountDownLatch;
import java.util.function.Function;
import java.util.function.Predicate;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.Timeout.ThreadMode;
import org.junit.jupiter.api.io.TempDir;
import rsal.agent.bdi.Mind;
import rsal.engine.LiveRun;
import rsal.engine.report.RunEvent;
import rsal.engine.report.RunObserver;
import rsal.engine.report.SentMessage;
import rsal.engine.report.Snapshot;
import rsal.recording.Recorder;
import rsal.scenario.RunOptions;
import rsal.scenario.RunPlan;
import rsal.server.RawHttp.Response;
import rsal.server.live.Viewer;
import rsal.server.monitor.Family;
import rsal.server.monitor.Family.Sample;
import rsal.testkit.LongTest;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.ObjectMapper;

/// What monitors are shown at `/metrics`.
@Timeout(value = 120, threadMode = ThreadMode.SEPARATE_THREAD) // who spins is not interrupted
class ExpositionTest {
    private static final String WITH_TOKEN = "Authorization: Bearer " + TOKEN;

    @TempDir
    private Path directory;

    private static Response get(RunServer server, String path, String... more) throws Exception {
        int port = server.url().getPort();
        var headers = new ArrayList<>(List.of("Host: 127.0.0.1:" + port));
        headers.addAll(List.of(more));
        return RawHttp.get(port, path, headers.toArray(String[]::new));
    }

    private static PrometheusText scrape(RunServer server) throws Exception {
        Response response = get(server, "/metrics");
        assertThat(response.status()).as(response.body()).isEqualTo(200);
        return PrometheusText.read(response.body());
    }

    private static PrometheusText await(RunServer server, Predicate<PrometheusText> wanted) throws Exception {
        PrometheusText metrics;
        do {
            metrics = scrape(server);
        } while (!wanted.test(metrics));
        return metrics;
    }

    private static void post(RunServer server, String command, String body) throws Exception {
        int port = server.url().getPort();
        Response response = RawHttp.post(port, "/api/run/" + command, body, "Host: 127.0.0.1:" + port, WITH_TOKEN);
        assertThat(response.status()).as(response.body()).isEqualTo(200);
    }

    @Test
    void isTextThatPrometheusReadsWithoutAToken() throws Exception {
        try (var server = Errand.serve(directory, 0)) {
            PrometheusText metrics = await(server, text -> text.value("rsal_robots{state=\"present\"}") == 1);
            assertThat(get(server, "/metrics").text())
                    .contains("\r\nContent-Type: text/plain; version=0.0.4; charset=utf-8\r\n");
            assertThat(metrics.types())
                    .containsEntry("rsal_step_duration_seconds", "histogram")
                    .containsEntry("rsal_phase_seconds_total", "counter")
                    .containsEntry("rsal_phase_cpu_seconds_total", "counter")
                    .containsEntry("rsal_run_speed_ratio", "gauge")
                    .containsEntry("rsal_viewers", "gauge")
                    .containsEntry("rsal_history_bytes", "gauge")
                    .containsEntry("process_cpu_seconds_total", "counter")
                    .containsEntry("jvm_gc_collection_seconds", "summary")
                    .doesNotContainKey("rsal_recording_bytes_total");
            assertThat(metrics.values())
                    .containsEntry(
                            "rsal_run_info{clock=\"simulated\",configuration=\"one\",run=\"1\",scenario=\"errand\",seed=\"7\"}",
                            1.0)
                    .containsEntry("rsal_runs_total", 1.0)
                    .containsEntry("rsal_run_wanted_speed_ratio", 1.0)
                    .containsEntry("rsal_run_paused", 0.0)
                    .containsEntry("rsal_run_ended", 0.0)
                    .containsEntry("rsal_robots{state=\"gone\"}", 0.0)
                    .containsEntry("rsal_agents{status=\"running\"}", 1.0)
                    .containsEntry("rsal_agents{status=\"failed\"}", 0.0)
                    .containsEntry("rsal_events_total{kind=\"fault\"}", 0.0)
                    .containsEntry("rsal_viewers_let_go_total{reason=\"full\"}", 0.0);
            assertThat(List.of(
                            "process_cpu_seconds_total", "jvm_threads_current", "jvm_memory_used_bytes{area=\"heap\"}"))
                    .allSatisfy(name -> assertThat(metrics.value(name)).isPositive());
        }
    }

    @Test
    void saysThatTheProcessIsAliveAndTheRunGoesOn() throws Exception {
        try (var server = Errand.serve(directory, 0)) {
            assertThat(get(server, "/healthz").body()).isEqualTo("{\"status\":\"ok\"}");
            Response ready = get(server, "/readyz");
            assertThat(ready.status()).isEqualTo(200);
            JsonNode said = new ObjectMapper().readTree(ready.body());
            assertThat(said.path("run").asString()).isEqualTo("errand:one");
            assertThat(said.path("seed").asLong()).isEqualTo(7);
            assertThat(said.path("ended").asBoolean()).isFalse();
            assertThat(RawHttp.get(server.url().getPort(), "/healthz", "Host: example.org:1")
                            .status())
                    .isEqualTo(421);
        }
    }

    @Test
    void aRunThatBrokeIsNotReady() throws Exception {
        RunObserver breaking = new Onlooker(() -> {
            throw new IllegalStateException("no more");
        });
        try (var server =
                serve(Errand.plan(), plan -> LiveRun.of(plan).observer(breaking).start(), Optional.empty())) {
            server.run().result().toCompletableFuture().handle((_, _) -> true).join();
            Response ready = get(server, "/readyz");
            assertThat(ready.status()).isEqualTo(503);
            assertThat(ready.body()).contains("The run broke:").contains("no more");
            assertThat(get(server, "/healthz").status()).isEqualTo(200);
        }
    }

    @Test
    void isNotForPagesAndNamesOfOthers() throws Exception {
        try (var server = Errand.serve(directory, 0)) {
            int port = server.url().getPort();
            assertThat(RawHttp.get(port, "/metrics", "Host: example.org:" + port)
                            .status())
                    .isEqualTo(421);
            assertThat(get(server, "/metrics", "Origin: http://example.org").status())
                    .isEqualTo(403);
            assertThat(get(server, "/metrics", "Origin: null").status()).isEqualTo(403);
            assertThat(RawHttp.post(port, "/metrics", "", "Host: 127.0.0.1:" + port, WITH_TOKEN)
                            .status())
                    .isEqualTo(404);
        }
    }

    @Test
    @LongTest
    void agreesWithTheApi() throws Exception {
        try (var server = Errand.serve("talk.yaml", directory, 0)) {
            server.run()
                    .when(now -> now.time().compareTo(Duration.ofSeconds(3)) >= 0)
                    .toCompletableFuture()
                    .join();
            server.run().pause();
            PrometheusText metrics = await(server, text -> text.value("rsal_run_paused") == 1);
            Snapshot snapshot = server.run().snapshot();
            assertThat(metrics.value("rsal_run_time_seconds"))
                    .isEqualTo(metrics.value("rsal_simulated_seconds_total"))
                    .isEqualTo(snapshot.time().toNanos() / 1e9);
            assertThat(metrics.value("rsal_step_duration_seconds_count")).isEqualTo((double)
                    snapshot.time().dividedBy(server.run().plan().step()));
            assertThat(metrics.value("rsal_robots{state=\"present\"}")).isEqualTo(3);
            assertThat(metrics.value("rsal_agents{status=\"running\"}")).isEqualTo(4);
            JsonNode topics = new ObjectMapper()
                    .readTree(get(server, "/api/topics").body())
                    .get("topics");
            assertThat(topics.size()).isGreaterThan(2);
            for (JsonNode topic : topics) {
                String label = "{topic=\"" + topic.get("topic").asString() + "\"}";
                assertThat(metrics.value("rsal_messages_said_total" + label))
                        .isEqualTo(topic.get("said").asDouble());
                assertThat(metrics.value("rsal_messages_heard_total" + label))
                        .isEqualTo(topic.get("heard").asDouble());
                Map.of("chance", "byChance", "range", "outOfRange")
                        .forEach((reason, member) -> assertThat(metrics.value("rsal_messages_lost_total"
                                        + label.replace("{", "{reason=\"%s\",".formatted(reason))))
                                .isEqualTo(topic.get(member).asDouble()));
            }
            assertThat(metrics.value("rsal_messages_lost_total{reason=\"chance\",topic=\"pose\"}"))
                    .isPositive();
            long agentEvents = server.run().events(0).stream()
                    .filter(event -> event.kind().equals("agent"))
                    .count();
            assertThat(metrics.value("rsal_events_total{kind=\"agent\"}")).isEqualTo((double) agentEvents);
        }
    }

    @Test
    @LongTest
    void countersGoOnFromRunToRun() throws Exception {
        try (var server = Errand.serve(directory, 0)) {
            PrometheusText before = await(server, text -> text.value("rsal_run_time_seconds") > 1);
            for (int i = 0; i < 20; i++) {
                before = grown(before, scrape(server));
            }
            post(server, "restart", "{\"seed\":\"8\"}");
            post(server, "restart", "{\"seed\":\"9\"}"); // nobody has looked at the one between
            PrometheusText after = grown(before, scrape(server));
            assertThat(after.value("rsal_runs_total")).isEqualTo(3);
            assertThat(after.value("rsal_simulated_seconds_total"))
                    .isGreaterThanOrEqualTo(before.value("rsal_run_time_seconds"));
            assertThat(after.values())
                    .containsKey(
                            "rsal_run_info{clock=\"simulated\",configuration=\"one\",run=\"3\",scenario=\"errand\",seed=\"9\"}");
            server.run().stop();
            PrometheusText end = grown(after, await(server, text -> text.value("rsal_run_ended") == 1));
            assertThat(end.value("rsal_run_time_seconds")).isLessThan(end.value("rsal_simulated_seconds_total"));
        }
    }

    private static PrometheusText grown(PrometheusText before, PrometheusText after) {
        Map<String, Double> now = after.growing();
        assertThat(before.growing())
                .allSatisfy((series, value) ->
                        assertThat(now.get(series)).as(series).isNotNull().isGreaterThanOrEqualTo(value));
        return after;
    }

    @Test
    void doesNotWaitForARunThatIsHeldUp() throws Exception {
        var held = new CountDownLatch(1);
        var free = new CountDownLatch(1);
        RunObserver holding = new Onlooker(() -> {
            held.countDown();
            free.await();
        });
        try (var server =
                serve(Errand.plan(), plan -> LiveRun.of(plan).observer(holding).start(), Optional.empty())) {
            held.await();
            assertThat(get(server, "/healthz").status()).isEqualTo(200);
            assertThat(get(server, "/readyz").status()).isEqualTo(503);
            PrometheusText metrics = scrape(server);
            assertThat(metrics.value("rsal_run_ended")).isZero();
            assertThat(metrics.value("rsal_phase_seconds_total{phase=\"world\"}"))
                    .isPositive();
            free.countDown();
            await(server, text -> text.value("rsal_run_time_seconds") > metrics.value("rsal_run_time_seconds"));
        }
    }

    @Test
    @LongTest
    void doesNotChangeTheRun() throws Exception {
        RunPlan plan = Errand.plan(
                "talk.yaml", RunOptions.NONE.withLimit(Duration.ofSeconds(8)).withSpeed(Double.POSITIVE_INFINITY));
        String alone;
        try (var run = LiveRun.start(plan)) {
            alone = run.result().toCompletableFuture().join().eventHash();
        }
        try (var server = serve(plan, LiveRun::start, Optional.empty())) {
            int scrapes = 0;
            while (scrape(server).value("rsal_run_ended") == 0) {
                scrapes++;
            }
            assertThat(scrapes).isPositive();
            assertThat(server.run().result().toCompletableFuture().join().eventHash())
                    .isEqualTo(alone);
        }
    }

    @Test
    void countsWhatViewersAreSent() throws Exception {
        try (var server = Errand.serve(directory, 0);
                var http = HttpClient.newHttpClient()) {
            var url = URI.create("ws://127.0.0.1:" + server.url().getPort() + "/api/live");
            var silent = http.newWebSocketBuilder()
                    .buildAsync(url, new WebSocket.Listener() {})
                    .join();
            PrometheusText metrics =
                    await(server, text -> text.value("rsal_viewer_messages_total{kind=\"frame\"}") == Viewer.FRAMES);
            assertThat(metrics.value("rsal_viewers")).isEqualTo(1);
            assertThat(metrics.value("rsal_viewer_connections_total")).isEqualTo(1);
            assertThat(metrics.value("rsal_viewer_messages_total{kind=\"run\"}"))
                    .isEqualTo(1);
            assertThat(metrics.value("rsal_viewer_bytes_total{kind=\"frame\"}"))
                    .isGreaterThan(40 * Viewer.FRAMES); // its header alone
            assertThat(metrics.value("rsal_history_bytes")).isPositive();
            silent.sendText("nonsense", true).join();
            PrometheusText after = await(server, text -> text.value("rsal_viewers") == 0);
            assertThat(after.value("rsal_viewers_let_go_total{reason=\"nonsense\"}"))
                    .isEqualTo(1);
        }
    }

    @Test
    void reportsWhatCameOfRecordings() throws Exception {
        var tally = new Recorder.Tally(3_000_000_000L, 12, 1);
        try (var server = serve(Errand.plan(), LiveRun::start, Optional.of(tally))) {
            PrometheusText metrics = scrape(server);
            assertThat(metrics.value("rsal_recording_bytes_total")).isEqualTo(3e9);
            assertThat(metrics.value("rsal_recording_dropped_states_total")).isEqualTo(12);
            assertThat(metrics.value("rsal_recordings_failed_total")).isEqualTo(1);
        }
    }

    @Test
    void namesOfTopicsMayBeAnyText() throws Exception {
        var text = new ByteArrayOutputStream();
        var odd = Sample.of(1, "topic", "a \"b\" \\ c\n…{}=,");
        PrometheusTextFormatWriter.create()
                .write(text, MetricSnapshots.of(Family.counter("odd_total", "Odd.", List.of(odd))));
        assertThat(PrometheusText.read(text.toString(StandardCharsets.UTF_8)).values())
                .containsOnlyKeys("odd_total{topic=\"a \\\"b\\\" \\\\ c\\n…{}=,\"}");
    }

    private RunServer serve(RunPlan plan, Function<RunPlan, LiveRun> starter, Optional<Recorder.Tally> tally)
            throws Exception {
        Files.writeString(directory.resolve("index.html"), "");
        var options = new RunServer.Options(
                0, TOKEN, directory, List.of(), run -> {}, starter, () -> tally, Optional.empty());
        return RunServer.start(plan, options);
    }

    private interface Held {
        void look() throws InterruptedException;
    }

    /// Holds the run up whenever it is shown how everything stands.
    private record Onlooker(Held held) implements RunObserver {
        @Override
        public Duration period() {
            return Duration.ofMillis(500);
        }

        @Override
        public void sees(Snapshot now, String hash) {
            try {
                held.look();
            } catch (InterruptedException e) {
                throw new AssertionError(e);
            }
        }

        @Override
        public void looksInto(Duration time, Map<String, Mind.View> minds) {}

        @Override
        public void happened(RunEvent event, String hash) {}

        @Override
        public void heard(SentMessage message, Object content) {}
    }
}
