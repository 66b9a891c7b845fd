package rsal.cli;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import com.sun.net.httpserver.HttpServer;
import java.io.IOException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.ServerSocket;
import java.net.http.HttpRequest;
import java.nio.charset.StandardCharsets;
import java.time.Duration;
import org.junit.jupiter.api.Test;

class PageClientTest {
    private static final Duration PATIENCE = Duration.ofMillis(200);

    @Test
    void whereNobodyListensThereIsNoRun() throws IOException {
        int free;
        try (var socket = listening()) {
            free = socket.getLocalPort();
        }
        var client = new PageClient(free, PATIENCE);
        assertThatThrownBy(() -> client.get("/api/status"))
                .isInstanceOf(Unreachable.class)
                .hasMessageContaining("There is no run with a page at (http://127.0.0.1:" + free + ").");
    }

    @Test
    void thatARunAnswersLateIsToldAsSuch() throws IOException {
        try (var mute = listening()) { // connections are made, and nobody reads from them
            var client = new PageClient(mute.getLocalPort(), PATIENCE);
            assertThatThrownBy(() -> client.get("/api/status"))
                    .isInstanceOf(Unreachable.class)
                    .hasMessageStartingWith("The page at (http://127.0.0.1:%d) did not answer within 0.2 s"
                            .formatted(mute.getLocalPort()))
                    .hasMessageNotContaining("no run");
        }
    }

    @Test
    void whetherALateCommandWasDoneIsNotClaimed() throws IOException {
        try (var mute = listening()) {
            var client = new PageClient(mute.getLocalPort(), PATIENCE);
            assertThatThrownBy(() ->
                            client.send(client.at("/api/run/estop").POST(HttpRequest.BodyPublishers.ofString("{}"))))
                    .hasMessageContaining("It may be done nevertheless, or later: look with 'rsal status'.");
        }
    }

    @Test
    void whatAnswersOtherwiseIsNoPageOfARun() throws IOException {
        HttpServer other = HttpServer.create(new InetSocketAddress(InetAddress.getLoopbackAddress(), 0), 0);
        other.createContext("/", asked -> {
            byte[] body = "<html>Hello</html>".getBytes(StandardCharsets.UTF_8);
            asked.sendResponseHeaders(200, body.length);
            asked.getResponseBody().write(body);
            asked.close();
        });
        other.start();
        try {
            var client = new PageClient(other.getAddress().getPort(), Duration.ofMinutes(1));
            assertThatThrownBy(() -> client.get("/api/status"))
                    .isInstanceOf(Unreachable.class)
                    .hasMessageContaining("is no page of a run");
        } finally {
            other.stop(0);
        }
    }

    @Test
    void theRefusalOfAPageIsAnAnswer() throws Exception {
        HttpServer page = HttpServer.create(new InetSocketAddress(InetAddress.getLoopbackAddress(), 0), 0);
        page.createContext("/api/status", asked -> {
            byte[] body = "{\"message\": \"No run has begun.\"}".getBytes(StandardCharsets.UTF_8);
            asked.sendResponseHeaders(409, body.length);
            asked.getResponseBody().write(body);
            asked.close();
        });
        page.start();
        try {
            PageClient.Answer answer =
                    new PageClient(page.getAddress().getPort(), Duration.ofMinutes(1)).get("/api/status");
            assertThat(answer.isRefusal()).isTrue();
            assertThat(answer.said().path("message").asString()).isEqualTo("No run has begun.");
        } finally {
            page.stop(0);
        }
    }

    private static ServerSocket listening() throws IOException {
        return new ServerSocket(0, 1, InetAddress.ofLiteral("127.0.0.1"));
    }
}
