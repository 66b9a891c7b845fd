package rsal.server;

import static org.assertj.core.api.Assertions.assertThat;
import static rsal.server.Errand.TOKEN;

import java.io.IOException;
import java.net.URLEncoder;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.nio.file.attribute.FileTime;
import java.time.Instant;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Predicate;
import java.util.stream.Stream;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import rsal.engine.LiveRun;
import rsal.engine.report.RunResult;
import rsal.experiment.Findings;
import rsal.experiment.Row;
import rsal.experiment.SweepFolder;
import rsal.experiment.statistics.Mean;
import rsal.scenario.RunOptions;
import rsal.scenario.RunPlan;
import rsal.server.RawHttp.Response;
import rsal.server.message.Json;
import rsal.server.message.Messages.EarlierSweep;
import rsal.server.message.Messages.SweepCombination;
import rsal.server.message.Messages.SweepInfo;
import rsal.server.message.Messages.SweepInfo.SweepStatus;
import rsal.server.message.Messages.SweepRunAgain;
import rsal.server.message.Messages.SweepRunInfo;
import rsal.server.message.Messages.SweepRuns;
import rsal.server.message.Messages.SweepState;
import rsal.server.message.Messages.SweepWish;
import rsal.server.message.Messages.SweepsBefore;
import rsal.server.sweep.SweepReader;
import rsal.testkit.Rounds;

@Timeout(120)
class SweepApiTest {
    private static final String WITH_TOKEN = "Authorization: Bearer " + TOKEN;
    private static final String GUARD = """
            rsal: 1
            scenario: guard
            title: Robots wander
            arguments:
              guards: {type: integer, default: 1, min: 1, max: 4, description: How many robots wander.}
            world: {map: office}
            robots:
              guard: {count: $guards, model: pioneer2dx, pose: {free: true}, devices: {laser: scanner.yaml, pilot: {}}}
            agents: {wander: {type: wander, robot: guard}}
            run: {stop: [{when: time > 2, outcome: success}]}
            metrics:
              - {name: way, unit: m, from: distance, better: more}
            configurations:
              long: {}
              short: {run: {stop: [{when: time > 1, outcome: timeout}]}}
              slow: {run: {stop: [{when: time > 600, outcome: timeout}]}}
              real: {run: {clock: {mode: wall}}}
            """;

    private static final String SCANNER = """
            type: laser
            fieldOfView: 240
            samples: 60
            range: [0.02, 5.6]
            noise: 0.01
            period: 0.1
            """;

    @TempDir
    private Path directory;

    private Path scenario;
    private Path scanner;
    private RunServer server;
    private int port;
    private String host;

    @BeforeEach
    void start() throws IOException, PortInUse {
        scenario = Files.writeString(directory.resolve("guard.yaml"), GUARD);
        scanner = Files.writeString(directory.resolve("scanner.yaml"), SCANNER);
        serve(Errand.plan());
    }

    @AfterEach
    void stop() {
        server.close();
    }

    private void serve(RunPlan plan) throws IOException, PortInUse {
        Files.writeString(directory.resolve("index.html"), "<!doctype html><title>The page</title>");
        server = RunServer.start(
                plan,
                new RunServer.Options(
                        0,
                        TOKEN,
                        directory,
                        List.of(scenario.toString()),
                        _ -> {},
                        LiveRun::start,
                        Optional::empty,
                        Optional.of(new RunServer.Sweeping(Errand.sweeps(directory), "test"))));
        port = server.url().getPort();
        host = "Host: 127.0.0.1:" + port;
    }

    private Response post(String what, Object body) throws IOException {
        return RawHttp.post(port, "/api/sweeps" + what, Json.write(body), host, WITH_TOKEN);
    }

    private SweepState state() throws IOException {
        return Json.read(RawHttp.get(port, "/api/sweeps", host).body(), SweepState.class);
    }

    private SweepInfo await(Predicate<SweepInfo> wanted) throws Exception {
        return ServerClock.await().until(() -> state().newest().orElseThrow(), wanted);
    }

    private SweepInfo awaitEnd() throws Exception {
        return await(sweep -> sweep.status() != SweepStatus.RUNS);
    }

    private SweepWish wish(List<String> configurations, Map<String, String> arguments, String seeds) {
        return new SweepWish(scenario.toString(), configurations, arguments, seeds, "", Optional.of(1));
    }

    @Test
    void growsToItsEndAndIsWhatTheReportSays() throws Exception {
        SweepWish wish = wish(List.of("long", "short"), Map.of("guards", "1:2"), "3");
        assertThat(state().newest()).isEmpty();
        assertThat(RawHttp.get(port, "/api/sweeps/report", host).status()).isEqualTo(404);
        assertThat(post("/check", wish).body()).isEqualTo("{\"combinations\":4,\"seeds\":3,\"runs\":12}");

        assertThat(post("", wish).status()).isEqualTo(200);
        assertThat(post("", wish).body()).contains("A sweep is running already");
        SweepInfo growing = await(sweep -> sweep.ended() > 0);
        assertThat(growing.runs()).isEqualTo(12);
        SweepInfo ended = awaitEnd();

        assertThat(ended.status()).isEqualTo(SweepStatus.ENDED);
        assertThat(ended.ended()).isEqualTo(12);
        assertThat(ended.left()).isEmpty();
        assertThat(ended.command())
                .contains("rsal sweep ", "--configuration long,short --vary guards=1,2 --seeds=1-3 --jobs 1 --out ");
        Findings findings = Findings.read(Errand.sweeps(directory).resolve("guard-1"));
        for (int i = 0; i < 4; i++) {
            SweepCombination reported = ended.combinations().get(i);
            Mean mean = findings.measurements(findings.manifest().metrics().getFirst())
                    .mean(findings.design().combinations().get(i))
                    .orElseThrow();
            assertThat(reported.ended()).isEqualTo(3);
            assertThat(reported.metrics().get("way").mean()).isEqualTo(mean.value());
            assertThat(reported.metrics().get("way").low())
                    .hasValue(mean.interval().orElseThrow().low());
            assertThat(reported.outcomes())
                    .extracting(share -> share.outcome() + " " + share.count())
                    .containsExactly(i < 2 ? "success 3" : "success 0", i < 2 ? "timeout 0" : "timeout 3");
        }
        Response report = RawHttp.get(port, "/api/sweeps/report", host);
        assertThat(report.text()).contains("text/html", "default-src 'none'; style-src 'unsafe-inline'");
        assertThat(report.body()).contains("Robots wander", "guards=2", "12 runs of 4 combinations with 3 seeds");
    }

    @Test
    void reportsItsRunsSoThatOneCanBeRunAgainAsItWas() throws Exception {
        var wish = new SweepWish(
                scenario.toString(), List.of("long"), Map.of("guards", "1:2"), "2", "0.5", Optional.of(1));
        post("", wish);
        SweepInfo ended = awaitEnd();
        String label = ended.combinations().getLast().label();
        String path = "/api/sweeps/runs?combination=" + URLEncoder.encode(label, StandardCharsets.UTF_8);
        List<SweepRunInfo> runs =
                Json.read(RawHttp.get(port, path, host).body(), SweepRuns.class).runs();
        assertThat(runs).extracting(SweepRunInfo::seed).containsExactly("1", "2");
        SweepRunInfo last = runs.getLast();
        assertThat(last.outcome()).isEqualTo("limit");

        Files.writeString(scenario, "no longer what it was");
        Files.writeString(scanner, SCANNER.replace("noise: 0.01", "noise: 0.02"));
        assertThat(watch(ended.number(), last.run())).isEqualTo(200);
        List<Row> rows =
                Findings.read(Errand.sweeps(directory).resolve("guard-1")).rows();
        RunResult again = server.run().result().toCompletableFuture().get();
        assertThat(again.eventHash()).isEqualTo(rows.get(last.run() - 1).eventHash());
        assertThat(again.outcome()).isEqualTo("limit"); // by the sweep's limit

        assertThat(watch(ended.number() + 1, last.run())).isEqualTo(404);
        assertThat(watch(ended.number(), 5)).isEqualTo(404);
        assertThat(watch(ended.number(), 0)).isEqualTo(404);
        assertThat(RawHttp.get(port, "/api/sweeps/runs?combination=none", host).status())
                .isEqualTo(404);
    }

    private int watch(int sweep, int run) throws IOException {
        String wish = Json.write(new SweepRunAgain(sweep, run));
        return RawHttp.post(port, "/api/run/watch", wish, host, WITH_TOKEN).status();
    }

    @Test
    void isStoppedAndGoneOnWithAndLosesNoRow() throws Exception {
        int runs = Rounds.of(30, 100);
        post("", wish(List.of("long"), Map.of(), Integer.toString(runs)));
        await(sweep -> sweep.ended() >= 2);
        assertThat(RawHttp.delete(port, "/api/sweeps", host, WITH_TOKEN).status())
                .isEqualTo(200);
        SweepInfo stopped = awaitEnd();
        assertThat(stopped.status()).isEqualTo(SweepStatus.STOPPED);
        assertThat(stopped.ended()).isBetween(2, runs - 1);
        Path folder = Errand.sweeps(directory).resolve("guard-1");
        List<String> rows = Files.readAllLines(folder.resolve(SweepFolder.ROWS));
        assertThat(rows).hasSize(stopped.ended());

        assertThat(post("/resume", Map.of()).status()).isEqualTo(200);
        SweepInfo ended = awaitEnd();
        assertThat(ended.problem()).isEmpty();
        assertThat(ended.status()).isEqualTo(SweepStatus.ENDED);
        List<String> all = Files.readAllLines(folder.resolve(SweepFolder.ROWS));
        assertThat(all).hasSize(runs).startsWith(rows.toArray(String[]::new));

        assertThat(post("/resume", Map.of()).body()).contains("has ended");

        post("", wish(List.of("short"), Map.of(), "1"));
        assertThat(awaitEnd().folder()).endsWith("guard-2");
        assertThat(before()).extracting(EarlierSweep::name).containsExactly("guard-1");
    }

    @Test
    void listsThoseOfAnEarlierServerWithTheirReports() throws Exception {
        assertThat(before()).isEmpty();
        post("", wish(List.of("short"), Map.of("guards", "1:2"), "2"));
        awaitEnd();
        assertThat(before()).isEmpty(); // it is the newest
        server.close();
        Path sweeps = Errand.sweeps(directory);
        Files.createDirectories(sweeps.resolve("empty"));
        Files.writeString(Files.createDirectories(sweeps.resolve("foreign")).resolve(SweepFolder.MANIFEST), "{}");
        Path half = Files.createDirectories(sweeps.resolve("half"));
        Files.writeString(half.resolve(SweepFolder.MANIFEST), "{\"format\": 1, \"sessions\": []}");
        Files.writeString(sweeps.resolve("guard-1/" + SweepFolder.ROWS), "{\"run\": 7, ", StandardOpenOption.APPEND);

        serve(Errand.plan());
        assertThat(state().newest()).isEmpty();
        assertThat(before()).hasSize(1);
        EarlierSweep earlier = before().getFirst();
        assertThat(earlier.name()).isEqualTo("guard-1");
        assertThat(earlier.title()).isEqualTo("Robots wander");
        assertThat(earlier.runs()).isEqualTo(4);
        assertThat(earlier.ended()).isEqualTo(4); // half a row is none
        assertThat(earlier.command()).startsWith("rsal sweep ").contains("--vary guards=1,2");
        assertThat(report("guard-1").body()).contains("4 runs of 2 combinations with 2 seeds");
        assertThat(report("foreign").status()).isEqualTo(409);
        assertThat(report("half").status()).isEqualTo(409);
        assertThat(before()).isEqualTo(List.of(earlier)); // nothing has changed
        List<String> rows = Files.readAllLines(sweeps.resolve("guard-1/" + SweepFolder.ROWS));
        Files.write(sweeps.resolve("guard-1/" + SweepFolder.ROWS), rows.subList(0, 3));
        Files.setLastModifiedTime(sweeps.resolve("guard-1/" + SweepFolder.ROWS), FileTime.from(Instant.EPOCH));
        assertThat(before()).extracting(EarlierSweep::ended).containsExactly(3L);
        assertThat(report("guard-1").body()).contains("of which only 3 have ended");
        for (String none : List.of("guard-2", "empty", "..", "../sweeps/guard-1", sweeps + "/guard-1")) {
            assertThat(report(none).status()).isEqualTo(404);
        }
    }

    @Test
    void goesOnWithOneOfAnEarlierServer() throws Exception {
        post("", wish(List.of("long"), Map.of(), "30"));
        await(sweep -> sweep.ended() >= 2);
        server.close();
        Path sweeps = Errand.sweeps(directory);
        Path folder = sweeps.resolve("guard-1");
        List<String> rows = Files.readAllLines(folder.resolve(SweepFolder.ROWS));
        assertThat(rows).hasSizeBetween(2, 29);
        assertThat(folder.resolve(SweepFolder.MANIFEST)).content().doesNotContain(directory.toString());
        Path half = Files.createDirectories(sweeps.resolve("half"));
        Files.writeString(half.resolve(SweepFolder.MANIFEST), "{\"format\": 1, \"sessions\": []}");
        Files.createDirectories(sweeps.resolve("empty"));

        serve(Errand.plan());
        assertThat(resume("half").status()).isEqualTo(409);
        for (String none : List.of("guard-2", "empty", "..", "../sweeps/guard-1", folder.toString())) {
            assertThat(resume(none).status()).isEqualTo(404);
        }
        assertThat(state().newest()).isEmpty();
        assertThat(resume("guard-1").status()).isEqualTo(200);
        SweepInfo ended = awaitEnd();
        assertThat(ended.status()).isEqualTo(SweepStatus.ENDED);
        assertThat(ended.problem()).isEmpty();
        assertThat(Files.readAllLines(folder.resolve(SweepFolder.ROWS)))
                .hasSize(30)
                .startsWith(rows.toArray(String[]::new));
        assertThat(resume("guard-1").body()).contains("has ended");
    }

    @Test
    void doesNotGoOnWithWhatIsAnotherSweepNowOrWhatIsRecorded() throws Exception {
        post("", wish(List.of("slow"), Map.of(), "20"));
        server.close();
        Path manifest = Errand.sweeps(directory).resolve("guard-1/" + SweepFolder.MANIFEST);
        String written = Files.readString(manifest);

        Files.writeString(scenario, GUARD.replace("time > 600", "time > 601"));
        serve(Errand.plan());
        assertThat(resume("guard-1").body())
                .contains("The sweep in it is another one")
                .contains("scenario's text");
        Files.writeString(scenario, GUARD);
        Files.writeString(manifest, written.replace("\"--jobs\"", "\"--record\", \"--jobs\""));
        assertThat(resume("guard-1").body()).contains("Its runs are recorded");
        Files.writeString(manifest, written.replace(scenario.getFileName().toString(), "elsewhere.yaml"));
        assertThat(resume("guard-1").status()).isEqualTo(404);
        assertThat(state().newest()).isEmpty();
    }

    private Response resume(String sweep) throws IOException {
        return post("/resume?sweep=" + URLEncoder.encode(sweep, StandardCharsets.UTF_8), Map.of());
    }

    private List<EarlierSweep> before() throws IOException {
        return Json.read(RawHttp.get(port, "/api/sweeps/before", host).body(), SweepsBefore.class)
                .sweeps();
    }

    private Response report(String sweep) throws IOException {
        return RawHttp.get(port, "/api/sweeps/report?sweep=" + URLEncoder.encode(sweep, StandardCharsets.UTF_8), host);
    }

    @Test
    void endsWithTheServer() throws Exception {
        post("", wish(List.of("slow"), Map.of(), "20"));
        server.close();
        ServerClock.await()
                .until(() -> Thread.getAllStackTraces().keySet().stream() // no longer than half a second
                        .noneMatch(thread -> thread.getName().equals("sweep")));
        assertThat(Findings.read(Errand.sweeps(directory).resolve("guard-1")).isComplete())
                .isFalse();
    }

    @Test
    void needsTheTokenForAllButLooking() throws IOException {
        String wish = Json.write(wish(List.of("long"), Map.of(), "1"));
        for (String what : List.of("", "/check", "/resume")) {
            assertThat(RawHttp.post(port, "/api/sweeps" + what, wish, host).status())
                    .isEqualTo(401);
        }
        assertThat(RawHttp.delete(port, "/api/sweeps", host).status()).isEqualTo(401);
        assertThat(state().newest()).isEmpty();
        assertThat(Errand.sweeps(directory)).doesNotExist();
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', textBlock = """
            long   | guards=1,9      | 3      |     | arguments.guards
            long   | guards=7        | 3      |     | arguments.guards
            long   | guard=1         | 3      |     | arguments.guard
            long   | guards=1        | none   |     | seeds
            long   | guards=1        | 5-4    |     | seeds
            long   | guards=1        | 0      |     | seeds
            long   | guards=1        | 3      | -1  | limit
            long   | guards=1        | 10001  |     | at most 10000
            real   | guards=1        | 3      |     | runs in real time
            nobody | guards=1        | 3      |     | nobody
            """)
    void saysWhatIsWrong(String configuration, String argument, String seeds, String limit, String reported)
            throws IOException {
        List<String> words = Stream.of(argument.split("=", 2)).toList();
        var wish = new SweepWish(
                scenario.toString(),
                List.of(configuration),
                Map.of(words.getFirst(), words.getLast()),
                seeds,
                limit == null ? "" : limit,
                Optional.empty());
        Response refused = post("", wish);
        assertThat(refused.status()).isEqualTo(422);
        assertThat(refused.body()).contains(reported).doesNotContain("--");
        assertThat(Errand.sweeps(directory)).doesNotExist();
    }

    @Test
    void sentencesAboutOptionsOfACommandAreLeftOutWhole() {
        assertThat(SweepReader.inForm("Maybe 0.5. Set 'run.clock.mode' to wall, as --clock wall does. Or a.yaml."))
                .isEqualTo("Maybe 0.5. Or a.yaml.");
        assertThat(SweepReader.inForm("Set a limit by --for SECONDS.")).isEmpty();
        assertThat(SweepReader.inForm("")).isEmpty();
    }

    @Test
    void takesNoOtherScenariosAndNoMoreCoresThanAreLeft() throws IOException {
        var foreign = new SweepWish("/etc/passwd", List.of("a"), Map.of(), "1", "", Optional.empty());
        assertThat(post("", foreign).status()).isEqualTo(404);
        int most = state().jobs();
        assertThat(most).isEqualTo(Math.max(1, Runtime.getRuntime().availableProcessors() - 1));
        var greedy = new SweepWish(scenario.toString(), List.of("long"), Map.of(), "1", "", Optional.of(most + 1));
        assertThat(post("", greedy).body()).contains("\"where\":\"jobs\"");
    }

    @Test
    void doesNotDisturbRealTime() throws Exception {
        server.close();
        serve(Errand.plan("errand.yaml", RunOptions.NONE.inRealTimeOn("plain")));
        SweepWish wish = wish(List.of("long"), Map.of(), "1");
        assertThat(post("", wish).status()).isEqualTo(409);
        RawHttp.post(port, "/api/run/stop", "", host, WITH_TOKEN);
        server.run().result().toCompletableFuture().get();
        assertThat(post("", wish).status()).isEqualTo(200);
        awaitEnd();
    }
}
