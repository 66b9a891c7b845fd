package rsal.server;

import static org.assertj.core.api.Assertions.assertThat;
import static rsal.server.Errand.TOKEN;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Optional;
import java.util.stream.Stream;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import rsal.engine.report.RunEvent;
import rsal.server.RawHttp.Response;
import rsal.server.http.AccessControl;
import rsal.server.message.Json;
import rsal.server.message.Messages.Control;
import rsal.server.message.Messages.ControlWish;

/// Who has control of a server, of several who have its token.
@Timeout(60)
class ControlApiTest {
    private static final String WITH_TOKEN = "Authorization: Bearer " + TOKEN;
    private static final String CONTROL = "/api/control";

    @TempDir
    private Path directory;

    private RunServer server;
    private int port;
    private String host;

    @BeforeEach
    void start() throws Exception {
        Files.writeString(directory.resolve("index.html"), "<!doctype html><title>The page</title>");
        server = RunServer.start(Errand.plan(), new RunServer.Options(0, TOKEN, directory, _ -> {}));
        port = server.url().getPort();
        host = "Host: 127.0.0.1:" + port;
    }

    @AfterEach
    void stop() {
        server.close();
    }

    private static String as(String operator) {
        return AccessControl.OPERATOR + ": " + operator;
    }

    private Response post(String path, String body, String... more) throws IOException {
        String[] headers =
                Stream.concat(Stream.of(host, WITH_TOKEN), Stream.of(more)).toArray(String[]::new);
        return RawHttp.post(port, path, body, headers);
    }

    private Response take(String operator, String name, boolean over) throws IOException {
        return post(CONTROL, Json.write(new ControlWish(name, over)), as(operator));
    }

    private Control seenBy(String operator) throws IOException {
        return Json.read(RawHttp.get(port, CONTROL, host, as(operator)).body(), Control.class);
    }

    @Test
    void isNobodysAtFirst() throws IOException {
        Control control = Json.read(RawHttp.get(port, CONTROL, host).body(), Control.class);
        assertThat(control.holder()).isEmpty();
        assertThat(control.mine()).isFalse();
        assertThat(post("/api/run/pause", "").status()).isEqualTo(200);
    }

    @ParameterizedTest
    @ValueSource(strings = {"/api/run/pause", "/api/run/restart", "/api/run/goal", "/api/beside", "/api/sweeps"})
    void keepsAllOthersOut(String path) throws IOException {
        assertThat(take("a", "Ann", false).status()).isEqualTo(200);
        for (Response refused : new Response[] {post(path, "{}"), post(path, "{}", as("b"))}) {
            assertThat(refused.status()).isEqualTo(409);
            assertThat(refused.body()).contains("Ann has control");
        }
        assertThat(post(path, "{}", as("a")).body()).doesNotContain("has control");
    }

    @Test
    void isKeptByWhoeverHasItOnly() throws IOException {
        take("a", "Ann", false);
        assertThat(RawHttp.put(port, CONTROL, "{}", host, as("a")).status())
                .as("without the token")
                .isEqualTo(401);
        Response kept = RawHttp.put(port, CONTROL, "{}", host, WITH_TOKEN, as("a"));
        assertThat(Json.read(kept.body(), Control.class).mine()).isTrue();
        Response reported = RawHttp.put(port, CONTROL, "{}", host, WITH_TOKEN, as("b"));
        assertThat(Json.read(reported.body(), Control.class)).isEqualTo(new Control(Optional.of("Ann"), false));
        RawHttp.delete(port, CONTROL, host, WITH_TOKEN, as("a"));
        RawHttp.put(port, CONTROL, "{}", host, WITH_TOKEN, as("a"));
        assertThat(seenBy("a").holder())
                .as("as what was said later came sooner")
                .isEmpty();
    }

    @Test
    void keepsAllOthersFromSaving() throws IOException {
        take("a", "Ann", false);
        String wish = "{\"scenario\":\"patrol\",\"before\":\"\",\"text\":\"\"}";
        Response refused = RawHttp.put(port, "/api/scenarios/text", wish, host, WITH_TOKEN, as("b"));
        assertThat(refused.body()).contains("Ann has control");
        Response own = RawHttp.put(port, "/api/scenarios/text", wish, host, WITH_TOKEN, as("a"));
        assertThat(own.body()).doesNotContain("has control");
    }

    @Test
    void letsAllStopInAnEmergency() throws IOException {
        take("a", "Ann", false);
        assertThat(post("/api/run/estop", "").status()).isEqualTo(200);
        assertThat(post("/api/run/rearm", "", as("b")).status()).isEqualTo(409);
        assertThat(post("/api/run/check", "{}").status()).as("asks only").isEqualTo(200);
    }

    @Test
    void reportsInEventsWhoDidWhat() throws IOException {
        post("/api/run/estop", "", as("b"));
        take("a", "Ann", false);
        post("/api/run/rearm", "", as("a"));
        post("/api/run/estop", "", as("b"));
        RawHttp.delete(port, CONTROL, host, WITH_TOKEN, as("a"));
        post("/api/run/rearm", "", as("a"));
        assertThat(server.run().events(0).stream()
                        .filter(event -> event.kind().equals("operator"))
                        .map(RunEvent::text))
                .containsExactly(
                        "emergency stop",
                        "motors on (by Ann)",
                        "emergency stop (by somebody without control)",
                        "motors on (by Ann)");
    }

    @Test
    void letsAllSwitchOffOneRobotsMotorsButNotOn() throws IOException {
        take("a", "Ann", false);
        String robot = "{\"robot\":\"courier-1\",\"on\":%s}";
        assertThat(post("/api/run/motors", robot.formatted(false), as("b")).status())
                .isEqualTo(200);
        Response refused = post("/api/run/motors", robot.formatted(true), as("b"));
        assertThat(refused.status()).isEqualTo(409);
        assertThat(refused.body()).contains("Ann has control");
        assertThat(post("/api/run/motors", robot.formatted(true), as("a")).status())
                .isEqualTo(200);
    }

    @Test
    void isTakenOverAndGivenBack() throws IOException {
        take("a", "Ann", false);
        assertThat(take("b", "Bob", false).status()).isEqualTo(409);
        assertThat(take("b", "Bob", true).status()).isEqualTo(200);
        assertThat(seenBy("b").mine()).isTrue();
        assertThat(seenBy("a").holder()).contains("Bob");
        assertThat(seenBy("a").mine()).isFalse();
        RawHttp.delete(port, CONTROL, host, WITH_TOKEN, as("a")); // which has none to give
        assertThat(seenBy("b").mine()).isTrue();
        RawHttp.delete(port, CONTROL, host, WITH_TOKEN, as("b"));
        assertThat(seenBy("b").holder()).isEmpty();
    }

    @Test
    void isOfAllRunsSideBySide() throws IOException {
        assertThat(post("/api/beside", "{}").status()).isEqualTo(200);
        take("a", "Ann", false);
        assertThat(post("/beside/2/api/run/pause", "", as("b")).status()).isEqualTo(409);
        assertThat(post("/beside/2/api/run/pause", "", as("a")).status()).isEqualTo(200);
    }

    @Test
    void takesTheTokenAndANameOfOnesOwn() throws IOException {
        assertThat(RawHttp.post(port, CONTROL, "{\"name\":\"Ann\",\"over\":true}", host, as("a"))
                        .status())
                .isEqualTo(401);
        assertThat(RawHttp.delete(port, CONTROL, host, as("a")).status()).isEqualTo(401);
        assertThat(take("a", " ", false).status()).isEqualTo(400);
        assertThat(post(CONTROL, "{\"name\":\"Ann\",\"over\":false}").status())
                .as("who asks")
                .isEqualTo(400);
        assertThat(seenBy("a").holder()).isEmpty();
    }
}
