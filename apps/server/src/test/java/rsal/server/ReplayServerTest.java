package rsal.server;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import rsal.server.RawHttp.Response;

class ReplayServerTest {
    private static final String TOKEN = "a-token-of-a-test";
    private static final String WITH_TOKEN = "Authorization: Bearer " + TOKEN;

    @TempDir
    Path folder;

    private ReplayServer server;
    private int port;
    private String host;

    @BeforeEach
    void start() throws Exception {
        Path file = folder.resolve("run.mcap");
        RecordedPastTest.record(RecordedPastTest.plan("hunt-and-prey", 5), file);
        Path page = Files.createDirectory(folder.resolve("page"));
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
    void tellsWhatItIs() throws Exception {
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
        for (String what : new String[] {"readings?robot=prey-1", "numbers", "abilities", "topics", "status"}) {
            assertThat(get("/api/" + what).status()).as(what).isEqualTo(409);
        }
        assertThat(get("/api/drawn/1?robot=prey-1").status()).isEqualTo(404);
        assertThat(get("/api/agent?name=nobody").status()).isEqualTo(404);
        assertThat(get("/api/agent?name=escape-1&time=soon").status()).isEqualTo(400);
        assertThat(get("/api/agent?name=escape-1&time=2").body()).contains("\"agent\":\"escape-1\"");
        assertThat(get("/api/agent?name=escape-1&time=NaN").status()).isEqualTo(200);
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
