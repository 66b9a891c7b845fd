package rsal.cli.page;

import java.io.IOException;
import java.net.ConnectException;
import java.net.URI;
import java.net.http.HttpClient;
import java.net.http.HttpRequest;
import java.net.http.HttpResponse;
import java.time.Duration;
import java.util.Locale;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import rsal.cli.terminal.Unreachable;
import tools.jackson.core.JacksonException;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.json.JsonMapper;

/// Talks to the page at a port of this machine, and waits no longer than some time for what it answers.
record PageClient(int port, Duration patience) {
    private static final int OK = 200;
    private static final int BUSY = 503; // the run did not answer the page in time, or all ends

    /// What a page answers.
    record Answer(int status, JsonNode said) {
        boolean isRefusal() {
            return status != OK;
        }
    }

    /// Its address.
    String address() {
        return "http://127.0.0.1:" + port;
    }

    /// The beginning of a request.
    HttpRequest.Builder at(String path) {
        return HttpRequest.newBuilder(URI.create(address() + path));
    }

    Answer get(String path) throws InterruptedException {
        return send(at(path));
    }

    /// @throws Unreachable when no page is there, or it doesn't answer in time
    Answer send(HttpRequest.Builder asked) throws InterruptedException {
        HttpRequest request = asked.build();
        String remedy = request.method().equals("GET")
                ? "Try again."
                : "It may be done nevertheless, or later: look with 'rsal status'.";
        try (var client = HttpClient.newHttpClient()) {
            HttpResponse<String> answer = exchange(client, request);
            JsonNode said = JsonMapper.shared().readTree(answer.body());
            if (answer.statusCode() == BUSY) {
                throw new Unreachable(said.path("message").asString("The page is busy.") + " " + remedy);
            }
            return new Answer(answer.statusCode(), said);
        } catch (TimeoutException e) {
            throw new Unreachable(String.format(
                    Locale.ROOT,
                    "The page at '%s' did not answer within %s s: its run, or this machine, has much to do, or its program is stopped. %s",
                    address(),
                    patience.toMillis() % 1000 == 0 ? patience.toSeconds() : patience.toMillis() / 1000.0,
                    remedy));
        } catch (ConnectException e) {
            throw new Unreachable(
                    "There is no run with a page at '%s'. Maybe it is at another port (--port P): 'rsal run' prints where."
                            .formatted(address()));
        } catch (JacksonException e) {
            throw new Unreachable(
                    "What answers at '%s' is not a page of a run. Maybe that is at another port (--port P): 'rsal run' prints where."
                            .formatted(address()));
        } catch (IOException e) {
            throw new Unreachable(
                    "The page at '%s' closed the connection before it answered; maybe its program just ended. %s"
                            .formatted(address(), remedy));
        }
    }

    /// All of the answer, in time: a request's own time-out ends with the answer's first lines.
    private HttpResponse<String> exchange(HttpClient client, HttpRequest request)
            throws IOException, InterruptedException, TimeoutException {
        CompletableFuture<HttpResponse<String>> answer =
                client.sendAsync(request, HttpResponse.BodyHandlers.ofString());
        try {
            return answer.get(patience.toMillis(), TimeUnit.MILLISECONDS);
        } catch (ExecutionException e) {
            throw e.getCause() instanceof IOException cause ? cause : new IOException(e.getCause());
        } finally {
            client.shutdownNow(); // to close it would wait for what is late
        }
    }
}
