package rsal.server;

import static org.assertj.core.api.Assertions.assertThat;
import static rsal.server.Errand.TOKEN;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFilePermissions;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.EnabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;
import rsal.engine.LiveRun;
import rsal.scenario.RunOptions;
import rsal.scenario.Scenario;
import rsal.server.RawHttp.Response;
import rsal.server.http.Http;
import rsal.server.message.Json;
import rsal.server.message.Messages.Restart;
import rsal.server.message.Messages.ScenarioText;
import rsal.server.message.Messages.TextCheck;
import rsal.server.message.Messages.TextError;
import rsal.server.message.Messages.TextToCheck;
import rsal.server.message.Messages.TextToSave;
import rsal.testkit.LongTest;

class TextApiTest {
    private static final String WITH_TOKEN = "Authorization: Bearer " + TOKEN;
    private static final String OWN = """
            rsal: 1
            scenario: own
            title: My own
            world: {map: office}
            robots:
              one: {model: pioneer2dx, pose: [0, -1, 0]}
            configurations:
              plain: {title: As it is}
              many:
                robots: {one: {count: 2, pose: {free: true}}}
            """;

    @TempDir
    private Path directory;

    private Path own;
    private RunServer server;
    private int port;
    private String host;

    @BeforeEach
    void start() throws IOException, PortInUse {
        own = Files.writeString(directory.resolve("own.yaml"), OWN);
        Files.writeString(directory.resolve("index.html"), "<!doctype html><title>The page</title>");
        var options = new RunServer.Options(
                0,
                TOKEN,
                directory,
                List.of(own.toString(), "patrol"),
                run -> {},
                LiveRun::start,
                Optional::empty,
                Optional.empty());
        server = RunServer.start(Scenario.load(own.toString()).plan(RunOptions.NONE), options);
        port = server.url().getPort();
        host = "Host: 127.0.0.1:" + port;
    }

    @AfterEach
    void stop() {
        server.close();
    }

    private Response get(String path) throws IOException {
        return RawHttp.get(port, path, host);
    }

    private ScenarioText text(String query) throws IOException {
        return Json.read(get("/api/scenarios/text" + query).body(), ScenarioText.class);
    }

    private TextCheck check(Optional<String> scenario, String text) throws IOException {
        String wish = Json.write(new TextToCheck(scenario, text));
        Response response = RawHttp.post(port, "/api/scenarios/check", wish, host, WITH_TOKEN);
        assertThat(response.status()).as(response.text()).isEqualTo(200);
        return Json.read(response.body(), TextCheck.class);
    }

    private Response save(String scenario, String before, String text) throws IOException {
        String wish = Json.write(new TextToSave(scenario, before, text));
        return RawHttp.put(port, "/api/scenarios/text", wish, host, WITH_TOKEN);
    }

    private Response restart(Optional<String> scenario, Optional<String> text) throws IOException {
        var none = Optional.<String>empty();
        var wish = new Restart(scenario, none, Optional.empty(), none, none, none, text);
        return RawHttp.post(port, "/api/run/restart", Json.write(wish), host, WITH_TOKEN);
    }

    @Test
    void showsTextsAsTheirAuthorsWroteThem() throws IOException {
        var mine = new ScenarioText(own.toString(), own.toString(), OWN, Optional.of(OWN));
        assertThat(text("")).isEqualTo(mine);
        assertThat(text("?scenario=" + own)).isEqualTo(mine);
        assertThat(text("?scenario=patrol"))
                .isEqualTo(new ScenarioText(
                        "patrol", "patrol/scenario.yaml", Scenario.written("patrol"), Optional.empty()));
        assertThat(get("/api/scenarios/text?scenario=swarm").status()).isEqualTo(404); // which was not named
        assertThat(get("/api/scenarios/text?scenario=/etc/passwd").status()).isEqualTo(404);
        assertThat(get("/api/scenarios/schema").text()).contains("application/schema+json", "RSAL scenario");
    }

    @Test
    void reportsLineAndColumnOfEachErrorInAnyConfiguration() throws IOException {
        TextCheck good = check(Optional.of(own.toString()), OWN);
        assertThat(good.errors()).isEmpty();
        assertThat(good.configurations()).extracting(one -> one.name()).containsExactly("plain", "many");

        TextCheck bad =
                check(Optional.empty(), OWN.replace("pioneer2dx", "pioneer9").replace("count: 2", "count: 0"));
        assertThat(bad.configurations()).hasSize(2);
        assertThat(bad.errors()).extracting(TextError::line).contains(6, 10);
        TextError model = bad.errors().stream()
                .filter(error -> error.line() == 6)
                .findFirst()
                .orElseThrow();
        assertThat(model.file()).isEqualTo(own.toString());
        assertThat(model.column()).isEqualTo(16);
        assertThat(model.message()).contains("pioneer9");
        assertThat(model.remedy()).contains("pioneer");

        TextCheck broken = check(Optional.of("patrol"), "rsal: 1\nworld: {map: office");
        assertThat(broken.configurations()).isEmpty();
        assertThat(broken.errors())
                .singleElement()
                .satisfies(error -> assertThat(error.message()).contains("not YAML"));
    }

    @Test
    void runsWhatWasEditedAndStaysWithItUntilAnotherScenario() throws IOException {
        String two = OWN.replace("  one: {model", "  other: {model: pioneer3at, pose: {free: true}}\n  one: {model");
        assertThat(restart(Optional.of(own.toString()), Optional.of(two)).body())
                .contains("\"id\":\"other\"", "\"edited\":true");
        assertThat(restart(Optional.empty(), Optional.empty()).body()).contains("\"id\":\"other\"", "\"edited\":true");
        assertThat(text("")).isEqualTo(new ScenarioText(own.toString(), own.toString(), two, Optional.of(OWN)));
        assertThat(restart(Optional.empty(), Optional.of(two.replace("My own", "Mine")))
                        .body())
                .contains("\"title\":\"Mine\"", "\"edited\":true");
        assertThat(restart(Optional.of(own.toString()), Optional.empty()).body())
                .contains("\"edited\":false");
        assertThat(own).hasContent(OWN);

        Response refused = restart(Optional.of("patrol"), Optional.of("rsal: 9"));
        assertThat(refused.status()).isEqualTo(422);
        assertThat(refused.body()).contains("patrol/scenario.yaml:1:7");
    }

    @Test
    void isNoLongerEditedOnceItIsSaved() throws IOException {
        String mended = OWN.replace("My own", "Mended");
        assertThat(restart(Optional.empty(), Optional.of(mended)).body()).contains("\"edited\":true");
        save(own.toString(), OWN, mended);
        assertThat(get("/api/run").body()).contains("\"edited\":false");
    }

    @Test
    void showsTheTextOfTheRunAlsoWhenItsFileIsGone() throws IOException {
        Files.delete(own);
        assertThat(text("")).isEqualTo(new ScenarioText(own.toString(), own.toString(), OWN, Optional.empty()));
        assertThat(get("/api/scenarios/text?scenario=" + own).status()).isEqualTo(404);
    }

    @Test
    @LongTest
    void checksFewTextsAtOnceSoThatOthersAreAnswered() throws Exception {
        String many = IntStream.range(0, 150)
                .mapToObj(i -> "  many%d: {robots: {one: {count: 9, pose: {free: true}}}}\n".formatted(i))
                .collect(Collectors.joining("", OWN, ""));
        String wish = Json.write(new TextToCheck(Optional.empty(), many));
        try (ExecutorService people = Executors.newVirtualThreadPerTaskExecutor()) {
            List<Future<Response>> checks = Stream.generate(() ->
                            people.submit(() -> RawHttp.post(port, "/api/scenarios/check", wish, host, WITH_TOKEN)))
                    .limit(24) // more than there are threads that answer
                    .toList();
            assertThat(RawHttp.post(port, "/api/run/estop", "", host, WITH_TOKEN)
                            .status())
                    .isEqualTo(200);
            assertThat(checks).extracting(Future::isDone).contains(false); // it did not wait for them
            var refused = 0;
            for (Future<Response> check : checks) {
                Response response = check.get();
                if (response.status() != 200) {
                    assertThat(response.body()).contains("Other texts are being checked");
                    refused++;
                }
            }
            assertThat(refused).isBetween(1, 23);
        }
        assertThat(check(Optional.empty(), OWN).errors()).isEmpty();
    }

    @Test
    void savesAFileWhole() throws IOException {
        String mended = OWN.replace("My own", "Mine, mended: ä");
        assertThat(save(own.toString(), OWN, mended).status()).isEqualTo(200);
        assertThat(own).hasContent(mended);
        assertThat(text("?scenario=" + own).saved()).contains(mended);
        try (Stream<Path> files = Files.list(directory)) {
            assertThat(files.map(file -> file.getFileName().toString()))
                    .containsExactlyInAnyOrder("own.yaml", "index.html");
        }
    }

    @Test
    @EnabledOnOs({OS.LINUX, OS.MAC})
    void leavesItsPermissionsAndWhatItIsALinkTo() throws IOException {
        Path real = directory.resolve("real.yaml");
        Files.move(own, real);
        Files.createSymbolicLink(own, real.getFileName());
        var permissions = PosixFilePermissions.fromString("rw-rw-r--");
        Files.setPosixFilePermissions(real, permissions);

        assertThat(save(own.toString(), OWN, OWN + "# more\n").status()).isEqualTo(200);
        assertThat(own).isSymbolicLink();
        assertThat(real).hasContent(OWN + "# more\n");
        assertThat(Files.getPosixFilePermissions(real)).isEqualTo(permissions);
    }

    @Test
    void savesNothingElse() throws IOException {
        Files.writeString(own, OWN + "# by another hand\n");
        Response changed = save(own.toString(), OWN, "rsal: 1\n");
        assertThat(changed.status()).isEqualTo(409);
        assertThat(changed.body()).contains("has changed since");
        assertThat(own).hasContent(OWN + "# by another hand\n");

        assertThat(save("patrol", Scenario.written("patrol"), "rsal: 1\n").status())
                .isEqualTo(409);
        Path other = Files.writeString(directory.resolve("other.yaml"), OWN);
        assertThat(save(other.toString(), OWN, "rsal: 1\n").status()).isEqualTo(404);
        assertThat(other).hasContent(OWN);
    }

    @Test
    void needsTheTokenAndTheOwnOriginForAllButLooking() throws IOException {
        String wish = Json.write(new TextToCheck(Optional.empty(), OWN));
        String saving = Json.write(new TextToSave(own.toString(), OWN, "rsal: 1\n"));
        String foreign = "Origin: http://example.org";
        assertThat(RawHttp.post(port, "/api/scenarios/check", wish, host).status())
                .isEqualTo(401);
        assertThat(RawHttp.put(port, "/api/scenarios/text", saving, host).status())
                .isEqualTo(401);
        assertThat(RawHttp.post(port, "/api/scenarios/check", wish, host, WITH_TOKEN, foreign)
                        .status())
                .isEqualTo(403);
        assertThat(RawHttp.put(port, "/api/scenarios/text", saving, host, WITH_TOKEN, foreign)
                        .status())
                .isEqualTo(403);
        assertThat(own).hasContent(OWN);
    }

    @Test
    void takesNoTextThatIsTooLong() throws IOException {
        String wish = Json.write(new TextToCheck(Optional.empty(), "#".repeat(Http.MAX_TEXT)));
        assertThat(RawHttp.post(port, "/api/scenarios/check", wish, host, WITH_TOKEN)
                        .status())
                .isEqualTo(413);
        String large = OWN + "#".repeat(Http.MAX_TEXT - 2 * OWN.length());
        assertThat(check(Optional.empty(), large).errors()).isEmpty();
        assertThat(save(own.toString(), OWN, large).status()).isEqualTo(200);
        assertThat(save(own.toString(), large, large + "#").status()).isEqualTo(200);
    }
}
