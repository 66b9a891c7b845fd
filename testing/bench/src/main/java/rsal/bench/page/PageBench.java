package rsal.bench.page;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.lang.management.ManagementFactory;
import java.lang.management.ThreadInfo;
import java.lang.management.ThreadMXBean;
import java.net.URI;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.Arrays;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import java.util.concurrent.locks.LockSupport;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import java.util.zip.GZIPOutputStream;
import rsal.bench.measurement.Bench;
import rsal.bench.measurement.BenchmarkRequest;
import rsal.bench.measurement.Result;
import rsal.bench.measurement.Stopwatch;
import rsal.engine.LiveRun;
import rsal.engine.report.Snapshot;
import rsal.scenario.RunOptions;
import rsal.scenario.Scenario;
import rsal.server.PortInUse;
import rsal.server.RunServer;
import rsal.server.RunServer.Options;
import rsal.time.AllowedToReadWallClock;

/// The page in a browser that draws without a GPU, on robots with lasers of 180 beams that wander about a cave.
///
/// Names are `page.<robots>.<what>`. What: `fps`, frames drawn per second at the speed of real time; `states`, new
/// states of the run drawn per second while it has 20, at twice that speed; `first`, from the call of the page until
/// its map shows the run (as it was when the page began to be loaded), after which the lists beside it follow;
/// `cost.percent`, how much slower the run is while the
/// page is open, both as fast as they can, and `cost.run.percent`, how much more processor time
/// the run's own threads take meanwhile, as the browser draws on the run's cores where there are few; `heap.mb.min`, by
/// how much the page's memory grows in a minute. `page.gzip.kb` is what a
/// browser loads before it draws, `page.whole.gzip.kb` also what it loads when somebody wants it, as the
/// editor. Of all medians count. What a page costs is held against the mean of the run without one just before and just
/// after, as machines are now slower and now faster; the first page that is opened doesn't count, as Java compiles
/// then.
@AllowedToReadWallClock("Benchmarks measure real time.")
public final class PageBench implements Bench {
    private static final List<Integer> TEAMS = List.of(100, 1000);
    private static final int COSTS = 100;
    private static final String SIZE = "page.gzip.kb";
    private static final String WHOLE = "page.whole.gzip.kb";
    /// What a page's text names as a script or style, and a script's as an import, but for those that are imported
    /// when they are needed: `import("…")`.
    private static final Pattern AT_ONCE = Pattern.compile("(?:src=|href=|from ?|import ?)[\"'`]([^\"'`]+)[\"'`]");
    private static final Duration WARM = Duration.ofSeconds(10);
    private static final Duration SETTLED = Duration.ofSeconds(3);
    private static final Duration WINDOW = Duration.ofSeconds(10);
    private static final Duration LONGEST_FIRST = Duration.ofSeconds(60);
    /// Counts states that are drawn. A frame has been drawn when the page sends its receipt; it is a new
    /// state where the run's time (`docs/reference/live-protocol.md`) is another one than in the frame
    /// before.
    private static final String STATES = """
            globalThis.rsalStates = 0;
            globalThis.rsalFirst = 0;
            const times = new Map();
            let shown;
            globalThis.WebSocket = class extends WebSocket {
              constructor(...where) {
                super(...where);
                this.addEventListener('message', ({ data }) => {
                  if (data instanceof ArrayBuffer) {
                    const frame = new DataView(data);
                    times.set(frame.getUint32(8, true), frame.getFloat64(16, true));
                  }
                });
              }
              send(data) {
                const number = JSON.parse(data).frame;
                if (Number.isInteger(number)) {
                  if (times.get(number) !== shown) globalThis.rsalStates++;
                  shown = times.get(number);
                  for (const before of times.keys()) if (before <= number) times.delete(before);
                  globalThis.rsalFirst ||= performance.now();
                }
                super.send(data);
              }
            };
            """;

    /// Counts pictures of the screen, which keeps the browser busy with them.
    private static final String FRAMES = """
            globalThis.rsalFrames = 0;
            requestAnimationFrame(function draw() {
              globalThis.rsalFrames++;
              requestAnimationFrame(draw);
            });
            """;

    private static String name(int robots, String what) {
        return "page.%d.%s".formatted(robots, what);
    }

    @Override
    public List<String> names() {
        return Stream.concat(
                        TEAMS.stream()
                                .flatMap(robots -> Stream.of("fps", "states", "first", "heap.mb.min")
                                        .map(what -> name(robots, what))),
                        Stream.of(name(COSTS, "cost.percent"), name(COSTS, "cost.run.percent"), SIZE, WHOLE))
                .toList();
    }

    @Override
    public void measure(BenchmarkRequest assignment) {
        Optional<Path> page =
                Optional.ofNullable(System.getProperty("rsal.page")).map(Path::of);
        Optional<Path> program = Browser.find();
        if (page.isEmpty() || program.isEmpty()) {
            assignment
                    .notes()
                    .accept("Skipped the page: it needs the built page, which './rsal bench page' has, and Chromium.");
            return;
        }
        if (assignment.wants(SIZE)) {
            assignment.report(Result.less(SIZE, "kB", firstSize(page.get())));
        }
        if (assignment.wants(WHOLE)) {
            assignment.report(Result.less(WHOLE, "kB", wholeSize(page.get())));
        }
        for (int robots : TEAMS) {
            List<String> drawing = Stream.of("fps", "states", "first", "heap.mb.min")
                    .map(what -> name(robots, what))
                    .toList();
            if (assignment.wantsAny(drawing)) {
                drawing(robots, page.get(), program.get(), assignment);
            }
        }
        if (assignment.wantsAny(List.of(name(COSTS, "cost.percent"), name(COSTS, "cost.run.percent")))) {
            costs(page.get(), program.get(), assignment);
        }
    }

    private static void drawing(int robots, Path page, Path program, BenchmarkRequest assignment) {
        int repeats = assignment.repeats();
        var frames = new double[repeats];
        var states = new double[repeats];
        var first = new double[repeats];
        var heap = new double[repeats];
        try (var server = start(robots, 1, page)) {
            pause(WARM); // of the run
            for (int i = 0; i < repeats; i++) {
                assignment.reach(name(robots, "fps"), i, repeats);
                try (var browser = watching(program, STATES + FRAMES)) {
                    first[i] = open(browser, server.url());
                    pause(WARM);
                    double bytes = browser.heap();
                    double framesBefore = browser.number("rsalFrames");
                    var watch = new Stopwatch();
                    pause(WINDOW);
                    frames[i] = (browser.number("rsalFrames") - framesBefore) / watch.wall();
                    heap[i] = (browser.heap() - bytes) * 1e-6 / watch.wall() * 60;
                    server.run().speed(2);
                    states[i] = statesPerSecond(browser);
                    server.run().speed(1);
                }
            }
        }
        assignment.report(
                Result.more(name(robots, "fps"), "1/s", frames),
                Result.more(name(robots, "states"), "1/s", states),
                Result.less(name(robots, "first"), "s", first),
                Result.less(name(robots, "heap.mb.min"), "MB/min", heap));
    }

    private static double statesPerSecond(Browser browser) {
        pause(SETTLED);
        double before = browser.number("rsalStates");
        var watch = new Stopwatch();
        pause(WINDOW);
        return (browser.number("rsalStates") - before) / watch.wall();
    }

    private static void costs(Path page, Path program, BenchmarkRequest assignment) {
        int repeats = assignment.repeats();
        var slower = new double[repeats];
        var more = new double[repeats];
        try (var server = start(COSTS, Double.POSITIVE_INFINITY, page)) {
            pause(WARM);
            watched(server, program); // compiles what shows a run
            Pace before = alone(server);
            for (int i = 0; i < repeats; i++) {
                assignment.reach(name(COSTS, "cost.percent"), i, repeats);
                Pace watched = watched(server, program);
                Pace after = alone(server);
                slower[i] = 100 * (1 - 2 * watched.speed / (before.speed + after.speed));
                more[i] = 100 * (2 * watched.cpu / (before.cpu + after.cpu) - 1);
                before = after;
            }
        }
        assignment.report(
                Result.less(name(COSTS, "cost.percent"), "%", slower),
                Result.less(name(COSTS, "cost.run.percent"), "%", more));
    }

    private static Pace alone(RunServer server) {
        pause(WARM); // as with a page, and until the browser before is gone
        return Pace.of(server.run());
    }

    private static Pace watched(RunServer server, Path program) {
        try (var browser = watching(program, STATES)) {
            open(browser, server.url());
            pause(WARM);
            return Pace.of(server.run());
        }
    }

    private static Browser watching(Path program, String counters) {
        var browser = Browser.start(program);
        try {
            browser.begin(counters);
            return browser;
        } catch (RuntimeException e) {
            browser.close();
            throw e;
        }
    }

    /// @return after how long it had drawn the run [s]
    private static double open(Browser browser, URI page) {
        browser.open(page);
        var watch = new Stopwatch();
        while (browser.number("globalThis.rsalFirst ?? 0") == 0) {
            if (watch.wall() > LONGEST_FIRST.toSeconds()) {
                throw new IllegalStateException("The page draws nothing.");
            }
            pause(Duration.ofMillis(20));
        }
        return browser.number("rsalFirst") / 1000;
    }

    private static RunServer start(int robots, double speed, Path page) {
        Map<String, byte[]> files = Map.of("crowd.yaml", resource("crowd.yaml"), "lidar.yaml", resource("lidar.yaml"));
        RunOptions options = RunOptions.NONE
                .withArguments(Map.of("robots", Integer.toString(robots)))
                .withSpeed(speed);
        try {
            return RunServer.start(
                    Scenario.again("crowd.yaml", files, true).plan(options),
                    new Options(0, RunServer.newToken(), page, _ -> {}));
        } catch (IOException e) {
            throw new UncheckedIOException("The page can't be shown.", e);
        } catch (PortInUse e) {
            throw new IllegalStateException(e);
        }
    }

    private static byte[] resource(String name) {
        try (InputStream file = Objects.requireNonNull(PageBench.class.getResourceAsStream(name), name)) {
            return file.readAllBytes();
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    /// What a browser loads before it can draw [kB].
    private static double firstSize(Path page) {
        var loaded = new LinkedHashSet<Path>();
        load(page.resolve("index.html"), loaded);
        return size(loaded.stream());
    }

    /// A file and all that it asks for at once.
    private static void load(Path file, Set<Path> loaded) {
        if (Files.isRegularFile(file) && loaded.add(file)) {
            Matcher asked = AT_ONCE.matcher(text(file));
            while (asked.find()) {
                load(file.resolveSibling(asked.group(1)).normalize(), loaded);
            }
        }
    }

    private static String text(Path file) {
        try {
            return Files.readString(file, StandardCharsets.ISO_8859_1); // icons, too
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    /// All of the page, with what is loaded when somebody wants it [kB].
    private static double wholeSize(Path page) {
        try (Stream<Path> files = Files.walk(page)) {
            return size(files.filter(Files::isRegularFile)
                    .filter(file -> !file.endsWith("plots.js")) // of pages of results
                    .filter(file -> !file.toString().endsWith(".gz"))); // of the others, packed
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    private static double size(Stream<Path> files) {
        return files.mapToLong(PageBench::compressed).sum() * 1e-3;
    }

    private static long compressed(Path file) {
        var bytes = new ByteArrayOutputStream();
        try (var gzip = new GZIPOutputStream(bytes)) {
            Files.copy(file, gzip);
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
        return bytes.size();
    }

    private static void pause(Duration length) {
        long end = System.nanoTime() + length.toNanos();
        for (long left = length.toNanos(); left > 0; left = end - System.nanoTime()) {
            LockSupport.parkNanos(left);
        }
    }

    /// How fast a run is.
    ///
    /// @param speed simulated over real time
    /// @param cpu processor time of its own threads for a simulated second [s]
    private record Pace(double speed, double cpu) {
        private static final ThreadMXBean THREADS = ManagementFactory.getThreadMXBean();
        private static final int PATIENCE_SECONDS = 10;

        /// Over the next [#WINDOW].
        static Pace of(LiveRun run) {
            double time = time(run);
            double cpu = threads();
            var watch = new Stopwatch();
            pause(WINDOW);
            double simulated = time(run) - time;
            double wall = watch.wall();
            return new Pace(simulated / wall, (threads() - cpu) / simulated);
        }

        private static double time(LiveRun run) {
            try {
                Snapshot now = run.freshSnapshot().toCompletableFuture().get(PATIENCE_SECONDS, TimeUnit.SECONDS);
                return now.time().toNanos() * 1e-9;
            } catch (InterruptedException e) {
                Thread.currentThread().interrupt();
                throw new IllegalStateException("Interrupted while a run was looked at.", e);
            } catch (ExecutionException | TimeoutException e) {
                throw new IllegalStateException("The run does not go on.", e);
            }
        }

        /// Of all runs' threads [s]; there is one run.
        private static double threads() {
            long[] ids = THREADS.getAllThreadIds();
            ThreadInfo[] infos = THREADS.getThreadInfo(ids);
            return Arrays.stream(infos)
                    .filter(Objects::nonNull)
                    .filter(info -> info.getThreadName().startsWith("run-"))
                    .mapToLong(info -> THREADS.getThreadCpuTime(info.getThreadId()))
                    .filter(nanos -> nanos > 0)
                    .mapToDouble(nanos -> nanos * 1e-9)
                    .sum();
        }
    }
}
