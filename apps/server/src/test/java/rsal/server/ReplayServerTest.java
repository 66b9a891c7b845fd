package rsal.server;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.Optional;
import java.util.concurrent.CompletionStage;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import rsal.engine.report.Answer;
import rsal.scenario.RunOptions;
import rsal.scenario.RunPlan;
import rsal.scenario.Scenario;
import rsal.server.RawHttp.Response;
import rsal.server.history.RecordedPastTest;
import rsal.server.message.Messages.PastNumbers;
import rsal.server.message.Messages.Trails;
import tools.jackson.databind.ObjectMapper;

class ReplayServerTest {
    private static final String TOKEN = "a-token-of-a-test";
    private static final String WITH_TOKEN = "Authorization: Bearer " + TOKEN;

    /// Made once for all tests, which only look at them.
    @TempDir
    static Path recordings;

    @TempDir
    Path folder;

    private ReplayServer server;
    private int port;
    private String host;

    @BeforeEach
    void start() throws Exception {
        show("hunt-and-prey", 5);
    }

    private void show(String scenario, int seconds) throws Exception {
        Path file = recordings.resolve("%s-%d.mcap".formatted(scenario, seconds));
        if (Files.notExists(file)) {
            RecordedPastTest.record(RecordedPastTest.plan(scenario, seconds), file);
        }
        show(file);
    }

    private void show(Path file) throws Exception {
        Path page = Files.createDirectories(folder.resolve("page"));
        Files.writeString(page.resolve("index.html"), "<p>the page</p>");
        server = ReplayServer.start(RecordedPastTest.open(file), "run.mcap", 0, TOKEN, page);
        port = server.url().getPort();
        host = "Host: 127.0.0.1:" + port;
    }

    @AfterEach
    void stop() throws Exception {
        server.close();
        server.close(); // does nothing
    }

    private Response get(String path) throws Exception {
        return RawHttp.get(port, path, host);
    }

    @Test
    void reportsWhatItIs() throws Exception {
        assertThat(get("/").body()).isEqualTo("<p>the page</p>");
        assertThat(get("/api/run").body())
                .contains("\"scenario\":\"hunt-and-prey\"", "\"recording\":{\"name\":\"run.mcap\"", "\"whole\":true");
        assertThat(get("/api/map/1").status()).isEqualTo(200);
        assertThat(get("/api/map/2").status()).isEqualTo(404);
    }

    @ParameterizedTest
    @ValueSource(
            strings = {
                "pause",
                "resume",
                "step",
                "speed",
                "stop",
                "place",
                "add",
                "remove",
                "goal",
                "drive",
                "estop",
                "restart",
                "behavior",
                "motors"
            })
    void nothingCanBeChanged(String command) throws Exception {
        Response refused = RawHttp.post(port, "/api/run/" + command, "{}", host, WITH_TOKEN);
        assertThat(refused.status()).isEqualTo(409);
        assertThat(refused.body()).contains("This is a recording");
        assertThat(RawHttp.post(port, "/api/run/" + command, "{}", host).status())
                .isEqualTo(401);
    }

    @Test
    void whatWasNotRecordedIsRefused() throws Exception {
        for (String what : new String[] {"abilities", "topics", "status"}) {
            assertThat(get("/api/" + what).status()).as(what).isEqualTo(409);
        }
        for (String what : new String[] {"drawn/1?robot=prey-1", "readings?robot=nobody", "numbers?robot=nobody"}) {
            assertThat(get("/api/" + what).status()).as(what).isEqualTo(404);
        }
        assertThat(get("/api/agent?name=nobody").status()).isEqualTo(404);
        for (String noTime : new String[] {"soon", "NaN", "Infinity", "-Infinity"}) {
            assertThat(get("/api/agent?name=escape-1&time=" + noTime).status())
                    .as(noTime)
                    .isEqualTo(400);
        }
        assertThat(get("/api/agent?name=escape-1&time=2").body()).contains("\"agent\":\"escape-1\"");
    }

    @Test
    void reportsWhatDevicesReported() throws Exception {
        assertThat(get("/api/readings?robot=hunter-1&time=3").body())
                .contains(
                        "{\"device\":\"base\"", "\"name\":\"velocity\"", "{\"device\":\"laser\"", "\"name\":\"hits\"");
        assertThat(get("/api/numbers?robot=hunter-1&time=3").body())
                .contains("{\"device\":\"laser\"", "\"name\":\"velocity.vx\"", "\"name\":\"ranges.least\"");
        assertThat(get("/api/numbers?robot=hunter-1&time=3").body())
                .isNotEqualTo(get("/api/numbers?robot=hunter-1&time=4").body())
                .isEqualTo(get("/api/numbers?robot=hunter-1&time=3").body());
    }

    @Test
    void reportsWhatANumberHasBeen() throws Exception {
        String speed = "/api/numbers/past?robot=hunter-1&device=base&number=velocity.vx";
        PastNumbers past = pastNumbers(speed);
        assertThat(past.times()).hasSize(50).isSorted().endsWith(4.9, 5.0);
        assertThat(past.values().stream().distinct()).hasSizeGreaterThan(5);
        int at = past.times().indexOf(3.0);
        assertThat(get("/api/numbers?robot=hunter-1&time=3").body())
                .contains("\"name\":\"velocity.vx\",\"title\":\"speed ahead\",\"unit\":\"m/s\",\"value\":"
                        + past.values().get(at).orElseThrow());
        assertThat(pastNumbers("/api/numbers/past?robot=nobody&device=base&number=velocity.vx")
                        .times())
                .isEmpty();
        assertThat(pastNumbers("/api/numbers/past?robot=hunter-1&device=base&number=nothing")
                        .values())
                .hasSize(50)
                .allMatch(Optional::isEmpty);
    }

    private PastNumbers pastNumbers(String path) throws Exception {
        return new ObjectMapper().readValue(get(path).body(), PastNumbers.class);
    }

    @Test
    void reportsWhereRobotsWent() throws Exception {
        Trails trails = new ObjectMapper().readValue(get("/api/trails?time=3").body(), Trails.class);
        assertThat(trails.robots())
                .hasSameSizeAs(RecordedPastTest.plan("hunt-and-prey", 5).robots());
        assertThat(trails.robots()).anySatisfy(trail -> {
            assertThat(trail.times()).hasSizeGreaterThan(5).isSorted();
            assertThat(trail.times().getLast()).isBetween(2.5, 3.0);
            assertThat(trail.driven()).startsWith(false, true).hasSameSizeAs(trail.xs());
            assertThat(trail.driven().subList(1, trail.driven().size())).containsOnly(true);
        });
        assertThat(get("/api/trails?time=soon").status()).isEqualTo(400);
    }

    @Test
    void reportsWhoHeardWhom() throws Exception {
        assertThat(get("/api/links?time=4").body())
                .contains("\"ofChosen\":false", "\"one\":\"prey-1\"")
                .containsPattern("\"said(There|Back)\":true");
        assertThat(get("/api/links?time=soon").status()).isEqualTo(400);
    }

    @Test
    void reportsWhatCamerasMadeOut() throws Exception {
        server.close();
        show("find-and-collect", 5);
        assertThat(get("/api/blobs?robot=explorer-1&time=5").body()).contains("{\"cameras\":[{\"name\":\"camera\"");
    }

    @Test
    void reportsWhatIsSaidAllTheTime() throws Exception {
        assertThat(get("/api/routine?time=3").body()).isEqualTo("{\"topics\":[\"pose\",\"pose-request\"],\"said\":[]}");
        assertThat(get("/api/routine?time=3&topic=pose").body())
                .contains("prey-1 is at (", "\"topic\":\"pose\"")
                .doesNotContain("\"time\":4");
    }

    @Test
    void reportsWhatAnAgentCameToBelieve() throws Exception {
        String belief = "\"kind\":\"BELIEVES\",\"name\":\"prey\",\"words\":\"prey-1\"";
        assertThat(get("/api/agent?name=follow-1&time=0").body()).doesNotContain(belief);
        assertThat(get("/api/agent?name=follow-1&time=5").body()).containsOnlyOnce(belief);
    }

    @Test
    void reportsAgentsThatPeopleStarted() throws Exception {
        server.close();
        Path file = folder.resolve("by-hand.mcap");
        RunPlan plan =
                Scenario.load("hunt-and-prey").plan(RunOptions.NONE.withSpeed(1).withLimit(Duration.ofSeconds(2)));
        RecordedPastTest.record(plan, file, run -> {
            run.pause(); // else it might be over
            CompletionStage<Answer> added = run.operator().addAgent("escape-1", "prey-1");
            run.step();
            assertThat(added.toCompletableFuture().join()).isEqualTo(new Answer.Added("escape-2"));
            run.resume();
        });
        show(file);
        assertThat(get("/api/agent?name=escape-2&time=2").body())
                .contains("\"agent\":\"escape-2\"", "\"arguments\":[]", "\"status\":\"RUNNING\"");
    }

    @Test
    void reportsWhatAnAgentTalkedAboutAndWhatWasSaidToIt() throws Exception {
        server.close();
        show("distribution", 15);
        String agent =
                RecordedPastTest.plan("distribution", 15).agents().getFirst().name();
        String early = get("/api/agent?name=" + agent + "&time=0").body();
        String late = get("/api/agent?name=" + agent + "&time=15").body();
        assertThat(early).contains("\"mail\":[]", "\"talks\":[]");
        assertThat(late)
                .contains("\"mail\":[{", "\"words\":\"request: ")
                .contains("\"talks\":[{", "\"to\":\"" + agent + "\"", "\"act\":\"agree\",\"words\":\"\"");
    }

    @Test
    void answersNobodyElsesPages() throws Exception {
        assertThat(RawHttp.get(port, "/api/run", "Host: evil.example").status()).isEqualTo(421);
        assertThat(RawHttp.get(port, "/api/run", host, "Origin: http://evil.example")
                        .status())
                .isEqualTo(403);
        assertThat(RawHttp.upgrade(port, host, "Origin: http://evil.example").status())
                .isEqualTo(403);
        assertThat(RawHttp.upgrade(port, host, "Origin: http://127.0.0.1:" + port)
                        .status())
                .isEqualTo(101);
    }
}
