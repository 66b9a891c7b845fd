package rsal.bench;

import java.io.BufferedReader;
import java.io.File;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.net.URI;
import java.net.http.HttpClient;
import java.net.http.WebSocket;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Comparator;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionStage;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import rsal.time.AllowedToReadWallClock;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.ObjectMapper;
import tools.jackson.databind.json.JsonMapper;

/// A Chromium with one page and no window, told what to do by its DevTools protocol
/// (https://chromedevtools.github.io/devtools-protocol). It draws without a GPU. All methods wait; one thread calls
/// them.
@AllowedToReadWallClock("A browser that does not answer is given up.")
final class Browser implements AutoCloseable {
    private static final List<String> NAMES =
            List.of("chromium", "chromium-browser", "google-chrome", "google-chrome-stable");
    private static final Pattern LISTENS = Pattern.compile("DevTools listening on (ws://\\S+)");
    private static final int PATIENCE_SECONDS = 30;
    private static final int WIDTH = 1366;
    private static final int HEIGHT = 768;
    private static final ObjectMapper JSON = new JsonMapper();

    private final Process process;
    private final Path profile;
    private final WebSocket line;
    private final String session;

    private final Map<Integer, CompletableFuture<JsonNode>> asked;
    private final AtomicInteger questions = new AtomicInteger();

    private Browser(Process process, Path profile, WebSocket line, Map<Integer, CompletableFuture<JsonNode>> asked) {
        this.process = process;
        this.profile = profile;
        this.line = line;
        this.asked = asked;
        JsonNode target = ask("", "Target.createTarget", Map.of("url", "about:blank"));
        this.session = ask(
                        "",
                        "Target.attachToTarget",
                        Map.of("targetId", target.path("targetId").asString(), "flatten", true))
                .path("sessionId")
                .asString();
        ask("Page.enable", Map.of());
        ask(
                "Emulation.setDeviceMetricsOverride",
                Map.of("width", WIDTH, "height", HEIGHT, "deviceScaleFactor", 1, "mobile", false));
    }

    /// The program, when it is on this machine.
    static Optional<Path> find() {
        return Stream.of(Objects.requireNonNullElse(System.getenv("PATH"), "").split(File.pathSeparator, -1))
                .flatMap(folder -> NAMES.stream().map(name -> Path.of(folder).resolve(name)))
                .filter(Files::isExecutable)
                .findFirst();
    }

    /// @throws UncheckedIOException when it does not start
    static Browser start(Path program) {
        try {
            Path profile = Files.createTempDirectory("rsal-browser-");
            Process process = new ProcessBuilder(
                            program.toString(),
                            "--headless",
                            "--no-sandbox", // else it can't run in containers; it sees nothing but our page
                            "--disable-gpu",
                            "--disable-background-networking",
                            "--disable-component-update",
                            "--disable-sync",
                            "--no-first-run",
                            "--remote-debugging-port=0",
                            "--user-data-dir=" + profile)
                    .redirectOutput(ProcessBuilder.Redirect.DISCARD)
                    .start();
            try {
                return reach(process, profile);
            } catch (IOException | RuntimeException e) {
                end(process);
                throw e;
            }
        } catch (IOException e) {
            throw new UncheckedIOException("The browser (%s) does not start.".formatted(program), e);
        }
    }

    private static Browser reach(Process process, Path profile) throws IOException {
        URI address = address(process);
        var asked = new ConcurrentHashMap<Integer, CompletableFuture<JsonNode>>();
        WebSocket line = HttpClient.newHttpClient()
                .newWebSocketBuilder()
                .buildAsync(address, new Ear(asked))
                .join();
        return new Browser(process, profile, line, asked);
    }

    private static void end(Process process) {
        process.descendants().forEach(ProcessHandle::destroyForcibly);
        process.destroyForcibly();
    }

    private static URI address(Process process) throws IOException {
        BufferedReader said = process.errorReader();
        for (String text = said.readLine(); text != null; text = said.readLine()) {
            Matcher found = LISTENS.matcher(text);
            if (found.find()) {
                Thread.ofPlatform().daemon().start(() -> said.lines().forEach(_ -> {})); // else it waits for us
                return URI.create(found.group(1));
            }
        }
        throw new IOException("It ended before it could be reached.");
    }

    /// Has each page that is opened from now on begin with a script.
    void begin(String script) {
        ask("Page.addScriptToEvaluateOnNewDocument", Map.of("source", script));
    }

    void open(URI page) {
        ask("Page.navigate", Map.of("url", page.toString()));
    }

    /// The value of an expression of JavaScript, a number.
    double number(String expression) {
        return ask("Runtime.evaluate", Map.of("expression", expression, "returnByValue", true))
                .path("result")
                .path("value")
                .asDouble();
    }

    /// Bytes of the page's objects in use, once everything is gone that nobody holds.
    double heap() {
        ask("HeapProfiler.collectGarbage", Map.of());
        return ask("Runtime.getHeapUsage", Map.of()).path("usedSize").asDouble();
    }

    private JsonNode ask(String method, Map<String, Object> parameters) {
        return ask(session, method, parameters);
    }

    private JsonNode ask(String of, String method, Map<String, Object> parameters) {
        int id = questions.incrementAndGet();
        var answer = new CompletableFuture<JsonNode>();
        asked.put(id, answer);
        Map<String, Object> question = of.isEmpty()
                ? Map.of("id", id, "method", method, "params", parameters)
                : Map.of("id", id, "method", method, "params", parameters, "sessionId", of);
        line.sendText(JSON.writeValueAsString(question), true).join();
        try {
            JsonNode whole = answer.get(PATIENCE_SECONDS, TimeUnit.SECONDS);
            if (whole.has("error")) {
                throw new IllegalStateException("The browser refuses (%s): %s".formatted(method, whole.path("error")));
            }
            return whole.path("result");
        } catch (ExecutionException | TimeoutException e) {
            throw new IllegalStateException("The browser does not answer (%s).".formatted(method), e);
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
            throw new IllegalStateException("Interrupted while the browser was asked.", e);
        }
    }

    @Override
    public void close() {
        line.abort();
        end(process);
        try {
            process.waitFor();
        } catch (InterruptedException _) {
            Thread.currentThread().interrupt();
        }
        try (Stream<Path> files = Files.walk(profile)) {
            files.sorted(Comparator.reverseOrder())
                    .map(Path::toFile)
                    .forEach(File::deleteOnExit); // its processes may still write
        } catch (IOException | UncheckedIOException _) {
            // then they stay in the folder for temporary files
        }
    }

    /// Hears answers, which come in pieces, and leaves out what nobody asked.
    private static final class Ear implements WebSocket.Listener {
        private final Map<Integer, CompletableFuture<JsonNode>> asked;
        private final StringBuilder text = new StringBuilder();

        Ear(Map<Integer, CompletableFuture<JsonNode>> asked) {
            this.asked = asked;
        }

        @Override
        public CompletionStage<?> onText(WebSocket from, CharSequence piece, boolean last) {
            text.append(piece);
            if (last) {
                JsonNode whole = JSON.readTree(text.toString());
                text.setLength(0);
                CompletableFuture<JsonNode> answer =
                        asked.remove(whole.path("id").asInt(0));
                if (answer != null) {
                    answer.complete(whole);
                }
            }
            from.request(1);
            return CompletableFuture.completedFuture(null);
        }
    }
}
