package rsal.cli.page;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import com.sun.net.httpserver.HttpServer;
import java.io.IOException;
import java.io.OutputStream;
import java.io.UncheckedIOException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.ServerSocket;
import java.net.http.HttpRequest;
import java.nio.charset.StandardCharsets;
import java.time.Duration;
import org.junit.jupiter.api.Test;
import rsal.cli.terminal.Unreachable;

class PageClientTest {
    private static final Duration PATIENCE = Duration.ofMillis(200);

    @Test
    void whereNobodyListensThereIsNoRun() throws IOException {
        int free;
        try (var socket = listening()) {
            free = socket.getLocalPort();
        }
        var client = new PageClient(free, Duration.ofMinutes(1));
        assertThatThrownBy(() -> client.get("/api/status"))
                .isInstanceOf(Unreachable.class)
                .hasMessageContaining("There is no run with a page at 'http://127.0.0.1:" + free + "'.");
    }

    @Test
    void thatARunAnswersLateIsReportedAsSuch() throws IOException {
        try (var mute = listening()) { // connections are made, and nobody reads from them
            var client = new PageClient(mute.getLocalPort(), PATIENCE);
            assertThatThrownBy(() -> client.get("/api/status"))
                    .isInstanceOf(Unreachable.class)
                    .hasMessageStartingWith("The page at 'http://127.0.0.1:%d' did not answer within 0.2 s"
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
    void anAnswerThatDoesNotEndIsLate() throws Exception {
        try (var slow = listening()) {
            Thread.ofVirtual().start(() -> {
                try (var line = slow.accept()) {
                    line.getOutputStream()
                            .write("HTTP/1.1 200 OK\r\nContent-Length: 5\r\n\r\n{".getBytes(StandardCharsets.UTF_8));
                    line.getInputStream().transferTo(OutputStream.nullOutputStream()); // until the client hangs up
                } catch (IOException e) {
                    throw new UncheckedIOException(e);
                }
            });
            var client = new PageClient(slow.getLocalPort(), PATIENCE);
            assertThatThrownBy(() -> client.get("/api/status")).hasMessageContaining("did not answer within 0.2 s");
        }
    }

    @Test
    void thatARunIsBusyIsNoErrorInTheCommand() throws IOException {
        try (var page = new Answering(503, "{\"message\": \"The run did not answer in time.\"}")) {
            assertThatThrownBy(() -> page.client().get("/api/robots"))
                    .isInstanceOf(Unreachable.class)
                    .hasMessage("The run did not answer in time. Try again.");
        }
    }

    @Test
    void whatAnswersOtherwiseIsNoPageOfARun() throws IOException {
        try (var other = new Answering(200, "<html>Hello</html>")) {
            assertThatThrownBy(() -> other.client().get("/api/status"))
                    .isInstanceOf(Unreachable.class)
                    .hasMessageContaining("is not a page of a run");
        }
    }

    @Test
    void theRefusalOfAPageIsAnAnswer() throws Exception {
        try (var page = new Answering(409, "{\"message\": \"No run has begun.\"}")) {
            PageClient.Answer answer = page.client().get("/api/status");
            assertThat(answer.isRefusal()).isTrue();
            assertThat(answer.said().path("message").asString()).isEqualTo("No run has begun.");
        }
    }

    /// Answers everything alike.
    private static final class Answering implements AutoCloseable {
        private final HttpServer server;

        Answering(int status, String words) throws IOException {
            byte[] body = words.getBytes(StandardCharsets.UTF_8);
            server = HttpServer.create(new InetSocketAddress(InetAddress.getLoopbackAddress(), 0), 0);
            server.createContext("/", asked -> {
                asked.sendResponseHeaders(status, body.length);
                asked.getResponseBody().write(body);
                asked.close();
            });
            server.start();
        }

        PageClient client() {
            return new PageClient(server.getAddress().getPort(), Duration.ofMinutes(1));
        }

        @Override
        public void close() {
            server.stop(0);
        }
    }

    private static ServerSocket listening() throws IOException {
        return new ServerSocket(0, 1, InetAddress.ofLiteral("127.0.0.1"));
    }
}
