package rsal.server;

import static org.assertj.core.api.Assertions.assertThat;
import static rsal.server.Errand.TOKEN;
import static rsal.server.ServerClock.await;

import java.net.URI;
import java.net.http.HttpClient;
import java.net.http.HttpRequest;
import java.net.http.HttpRequest.BodyPublishers;
import java.net.http.HttpResponse.BodyHandlers;
import java.nio.file.Path;
import java.util.List;
import java.util.Queue;
import java.util.concurrent.ConcurrentLinkedQueue;
import java.util.concurrent.Executors;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.concurrent.atomic.AtomicInteger;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/// A page goes on asking while runs begin, end and are replaced, and robots come and go.
class RunsThatChangeTest {
    private static final int RUNS = 8;
    private static final int PAGES = 4;
    private static final List<String> ASKED = List.of(
            "numbers?robot=courier-1",
            "numbers/past?robot=courier-1&device=base&number=velocity.vx",
            "numbers?robot=courier-2",
            "numbers/past?robot=courier-2&device=base&number=velocity.vx",
            "numbers?robot=courier-1&time=0.5",
            "readings?robot=courier-1",
            "readings?robot=courier-2&time=0.2",
            "trails?time=1",
            "routine?topic=pose",
            "run");

    private final HttpClient client = HttpClient.newHttpClient();

    @TempDir
    private Path directory;

    @Test
    void whoAsksMeanwhileIsNeverAnsweredThatTheServerFailed() throws Exception {
        Queue<String> failures = new ConcurrentLinkedQueue<>();
        var done = new AtomicBoolean();
        var answered = new AtomicInteger();
        try (RunServer server = Errand.serve(directory, 0);
                var pages = Executors.newVirtualThreadPerTaskExecutor()) {
            String home = "http://127.0.0.1:" + server.url().getPort() + "/api/";
            for (int page = 0; page < PAGES; page++) {
                int first = page;
                var _ = pages.submit(() -> {
                    for (int i = first; !done.get(); i++) {
                        String what = home + ASKED.get(i % ASKED.size());
                        var response = client.send(
                                HttpRequest.newBuilder(URI.create(what)).build(), BodyHandlers.ofString());
                        answered.incrementAndGet();
                        if (response.statusCode() >= 500) {
                            failures.add(response.statusCode() + " " + what + " " + response.body());
                        }
                    }
                    return null;
                });
            }
            try {
                for (int run = 0; run < RUNS; run++) {
                    command(home, "resume", "{}");
                    command(home, "speed", "{\"factor\": \"max\"}");
                    command(home, "add-robot", "{\"robot\": \"courier-1\", \"x\": 1, \"y\": 1, \"heading\": 0}");
                    command(home, "remove", "{\"name\": \"courier-1\"}");
                    int seen = answered.get();
                    await().until(() -> answered.get() >= seen + 40);
                    command(home, "restart", "{}");
                }
            } finally {
                done.set(true);
            }
        }
        assertThat(failures).isEmpty();
    }

    /// Whether it is taken is another matter. Has a connection of its own: on one that the server closes just then a
    /// command is lost, as the client sends nothing again but questions.
    private void command(String home, String what, String body) throws Exception {
        var request = HttpRequest.newBuilder(URI.create(home + "run/" + what))
                .header("Authorization", "Bearer " + TOKEN)
                .POST(BodyPublishers.ofString(body))
                .build();
        try (var own = HttpClient.newHttpClient()) {
            assertThat(own.send(request, BodyHandlers.ofString()).statusCode())
                    .as(what)
                    .isLessThan(500);
        }
    }
}
