package rsal.server;

import static org.assertj.core.api.Assertions.assertThat;
import static rsal.server.Errand.TOKEN;

import java.io.IOException;
import java.nio.file.Path;
import java.util.concurrent.CountDownLatch;
import java.util.function.Predicate;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import rsal.engine.report.RobotView;
import rsal.engine.report.Snapshot;
import rsal.server.RawHttp.Response;

/// Driving robots and giving them behaviors over HTTP.
@Timeout(60)
class SteeringTest {
    @TempDir
    private Path directory;

    private RunServer server;
    private String host;

    @BeforeEach
    void start() throws IOException, PortInUse {
        server = Errand.serve(directory, 0);
        host = "Host: 127.0.0.1:" + server.url().getPort();
    }

    @AfterEach
    void stop() {
        server.close();
    }

    private Response get(String path) throws IOException {
        return RawHttp.get(server.url().getPort(), path, host);
    }

    private Response post(String command, String body) throws IOException {
        return RawHttp.post(
                server.url().getPort(), "/api/run/" + command, body, host, "Authorization: Bearer " + TOKEN);
    }

    private static String drive(String robot, String driver, Object vx) {
        return "{\"robot\":\"%s\",\"driver\":\"%s\",\"vx\":%s,\"vy\":0,\"omega\":0.2}".formatted(robot, driver, vx);
    }

    private Snapshot await(Predicate<RobotView> wanted) throws InterruptedException {
        while (true) {
            var news = new CountDownLatch(1);
            try (var _ = server.run().onSnapshot(news::countDown)) {
                Snapshot snapshot = server.run().snapshot();
                if (snapshot.robots().stream().anyMatch(wanted)) {
                    return snapshot;
                }
                news.await();
            }
        }
    }

    @Test
    void whoeverDrivesIsKnown() throws Exception {
        assertThat(post("drive", drive("courier-1", "page-1", 0.3)).body()).isEqualTo("{}");
        await(robot -> robot.driver().equals("page-1"));
        Response other = post("drive", drive("courier-1", "page-2", 0.3));
        assertThat(other.status()).isEqualTo(409);
        assertThat(other.body()).contains("Somebody else drives robot 'courier-1'");
        assertThat(post("release", "{\"robot\":\"courier-1\",\"driver\":\"page-1\"}")
                        .status())
                .isEqualTo(200);
        await(robot -> robot.driver().isEmpty());
    }

    @Test
    void aRobotStandsWhenItsDriverIsNotHeardAnyMore() throws Exception {
        assertThat(post("drive", drive("courier-1", "page-1", 0.3)).status()).isEqualTo(200);
        await(robot -> robot.odometry().orElseThrow().value().velocity().vx() > 0);
        await(robot -> robot.odometry().orElseThrow().value().velocity().speed() == 0);
        await(robot -> robot.driver().isEmpty());
    }

    @Test
    void aBehaviorIsGiven() throws Exception {
        assertThat(post("behavior", "{\"robot\":\"courier-1\",\"behavior\":\"wander\"}")
                        .status())
                .isEqualTo(200);
        await(robot -> robot.behavior().equals("wander") && !robot.inCharge().isEmpty());
        Response unknown = post("behavior", "{\"robot\":\"courier-1\",\"behavior\":\"dance\"}");
        assertThat(unknown.status()).isEqualTo(409);
        assertThat(unknown.body()).contains("There is no behavior 'dance'");
        assertThat(post("behavior", "{\"robot\":\"courier-1\",\"behavior\":\"\"}")
                        .status())
                .isEqualTo(200);
        await(robot -> robot.behavior().isEmpty());
    }

    @Test
    void abilitiesCanBeAskedFor() throws IOException {
        assertThat(get("/api/abilities?robot=courier-1").body())
                .contains("\"behaviors\":[\"stand\",\"wander\",\"wall-follow\"]")
                .contains("\"sideways\":0.0,", "\"noBehavior\":\"\"", "\"noGoal\":\"\"");
        for (String path : new String[] {"/api/abilities?robot=nobody", "/api/abilities"}) {
            assertThat(get(path).status()).as(path).isEqualTo(409);
        }
    }

    @Test
    void readingsCanBeAskedFor() throws IOException {
        assertThat(get("/api/readings?robot=courier-1").body()).startsWith("{\"readings\":[");
        for (String path : new String[] {"/api/readings?robot=nobody", "/api/readings"}) {
            assertThat(get(path).status()).as(path).isEqualTo(409);
        }
    }

    @ParameterizedTest
    @CsvSource(
            quoteCharacter = '`',
            delimiter = '|',
            value = {
                "courier-1 | me | 1e3   | 400 | from -100 to 100 [m/s]",
                "courier-1 | me | 1e999 | 400 | from -100 to 100 [m/s]",
                "courier-1 | me | NaN   | 400 | not JSON",
                "courier-1 | me | null  | 400 | vx",
                "courier-1 | me | \"1m\" | 400 | vx",
                "courier-1 | `` | 0.1   | 400 | 'driver' must have 1 to 64 characters",
                "courier-1 | 0123456789012345678901234567890123456789012345678901234567890123456789 | 0 | 400 | 'driver' must have 1 to 64 characters",
                "nobody    | me | 0.1   | 409 | nobody",
            })
    void whatMakesNoSenseIsRefusedWithASentence(String robot, String driver, String vx, int status, String words)
            throws IOException {
        Response response = post("drive", drive(robot, driver, vx));
        assertThat(response.status()).isEqualTo(status);
        assertThat(response.body()).startsWith("{\"message\":\"").contains(words);
        assertThat(server.run().snapshot().robots())
                .allMatch(view -> view.driver().isEmpty());
    }
}
