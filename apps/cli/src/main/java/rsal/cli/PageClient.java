package rsal.cli;

import java.io.IOException;
import java.net.ConnectException;
import java.net.URI;
import java.net.http.HttpClient;
import java.net.http.HttpConnectTimeoutException;
import java.net.http.HttpRequest;
import java.net.http.HttpResponse;
import java.net.http.HttpTimeoutException;
import java.time.Duration;
import java.util.Locale;
import tools.jackson.core.JacksonException;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.json.JsonMapper;

/// Talks to the page at a port of this machine, and waits no longer than some time for what it answers.
record PageClient(int port, Duration patience) {
    private static final int OK = 200;

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
        HttpRequest request = asked.timeout(patience).build();
        try (var client = HttpClient.newBuilder().connectTimeout(patience).build()) {
            HttpResponse<String> answer = client.send(request, HttpResponse.BodyHandlers.ofString());
            return new Answer(answer.statusCode(), JsonMapper.shared().readTree(answer.body()));
        } catch (HttpTimeoutException e) {
            throw late(!request.method().equals("GET") && !(e instanceof HttpConnectTimeoutException));
        } catch (ConnectException e) {
            throw new Unreachable(
                    "There is no run with a page at (%s). Maybe it is at another port (--port P): 'rsal run' prints where."
                            .formatted(address()));
        } catch (JacksonException e) {
            throw new Unreachable(
                    "What answers at (%s) is no page of a run. Maybe that is at another port (--port P): 'rsal run' prints where."
                            .formatted(address()));
        } catch (IOException e) {
            throw new Unreachable("The page at (%s) hung up before it answered; maybe its program was ended just then."
                    .formatted(address()));
        }
    }

    /// @param wasSent whether something was to be done, which the page may know of
    private Unreachable late(boolean wasSent) {
        String late = String.format(
                Locale.ROOT,
                "The page at (%s) did not answer within %s s: its run, or this machine, has much to do, or its program is stopped.",
                address(),
                patience.toMillis() % 1000 == 0 ? patience.toSeconds() : patience.toMillis() / 1000.0);
        return new Unreachable(
                late + (wasSent ? " It may be done nevertheless, or later: look with 'rsal status'." : " Try again."));
    }
}
