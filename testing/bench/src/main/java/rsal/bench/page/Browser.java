package rsal.bench.page;

import java.io.File;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.net.URI;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import java.util.stream.Stream;
import rsal.time.AllowedToReadWallClock;
import tools.jackson.databind.JsonNode;

/// A Chromium with one page and no window, which draws without a GPU. Only this process can tell it anything, by a
/// pipe with which it ends, too. All methods wait; one thread calls them.
@AllowedToReadWallClock("A browser that does not end is waited for no longer than seconds.")
final class Browser implements AutoCloseable {
    private static final List<String> NAMES =
            List.of("chromium", "chromium-browser", "google-chrome", "google-chrome-stable", "chromium-headless-shell");
    /// A browser has its pipe at 3 (what it is asked) and 4 (what it says), where Java can't put one.
    private static final List<String> PIPED =
            List.of("/bin/sh", "-c", "exec \"$0\" \"$@\" 3<&0 4>&1 </dev/null >/dev/null 2>&1");
    private static final int WIDTH = 1366;
    private static final int HEIGHT = 768;
    private static final int PATIENCE_SECONDS = 10;

    private final Process process;
    private final Path profile;
    private final Thread end;
    private final DevTools tools;
    private String page = ""; // its session

    private Browser(Process process, Path profile) {
        this.process = process;
        this.profile = profile;
        this.end = new Thread(this::end, "browser-end"); // when nobody closes it
        this.tools = new DevTools(process.getOutputStream(), process.getInputStream());
    }

    /// The program, when it is on this machine.
    static Optional<Path> find() {
        return Stream.of(Objects.requireNonNullElse(System.getenv("PATH"), "").split(File.pathSeparator, -1))
                .flatMap(folder -> NAMES.stream().map(name -> Path.of(folder).resolve(name)))
                .filter(Files::isExecutable)
                .findFirst();
    }

    /// @throws UncheckedIOException when it can't be started
    /// @throws IllegalStateException when it does not answer
    static Browser start(Path program) {
        Browser browser;
        try {
            Path profile = Files.createTempDirectory("rsal-browser-");
            var command = new ArrayList<>(PIPED);
            command.addAll(List.of(
                    program.toString(),
                    "--headless",
                    "--no-sandbox", // else it can't run in containers; it sees nothing but our page
                    "--disable-gpu",
                    "--disable-background-networking",
                    "--disable-component-update",
                    "--disable-sync",
                    "--no-first-run",
                    "--remote-debugging-pipe",
                    "--user-data-dir=" + profile));
            browser = new Browser(new ProcessBuilder(command).start(), profile);
        } catch (IOException e) {
            throw new UncheckedIOException("The browser '%s' does not start.".formatted(program), e);
        }
        Runtime.getRuntime().addShutdownHook(browser.end);
        try {
            browser.attach();
        } catch (RuntimeException e) {
            browser.close();
            throw new IllegalStateException("The browser '%s' can't be used.".formatted(program), e);
        }
        return browser;
    }

    private void attach() {
        JsonNode target = tools.ask("", "Target.createTarget", Map.of("url", "about:blank"));
        page = tools.ask(
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
        return tools.ask(page, method, parameters);
    }

    /// Ends it with all that it has written.
    @Override
    public void close() {
        end();
        try {
            Runtime.getRuntime().removeShutdownHook(end);
        } catch (IllegalStateException _) {
            // everything ends
        }
    }

    private void end() {
        List<ProcessHandle> all = Stream.concat(process.descendants(), Stream.of(process.toHandle()))
                .toList();
        all.forEach(ProcessHandle::destroyForcibly);
        all.forEach(Browser::await); // else they go on writing
        try (Stream<Path> files = Files.walk(profile)) {
            for (Path file : files.sorted(Comparator.reverseOrder()).toList()) {
                Files.deleteIfExists(file);
            }
        } catch (IOException | UncheckedIOException _) {
            // then they stay in the folder for temporary files
        }
    }

    private static void await(ProcessHandle process) {
        try {
            process.onExit().get(PATIENCE_SECONDS, TimeUnit.SECONDS);
        } catch (InterruptedException _) {
            Thread.currentThread().interrupt();
        } catch (ExecutionException | TimeoutException _) {
            // then its files stay
        }
    }
}
