package rsal.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.net.InetAddress;
import java.net.ServerSocket;
import java.net.URI;
import java.net.http.HttpClient;
import java.net.http.HttpRequest;
import java.net.http.HttpResponse;
import java.net.http.WebSocket;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionStage;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicInteger;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.EnabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.CleanupMode;
import org.junit.jupiter.api.io.TempDir;
import rsal.cli.terminal.Exit;
import rsal.testkit.LongTest;
import rsal.testkit.OfficialBagReader;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.json.JsonMapper;

/// Recordings as people make and use them: each command a process of its own.
class RecordIT {
    @TempDir(factory = WarmProcess.Folder.class, cleanup = CleanupMode.NEVER)
    Path folder;

    private Rsal rsal;

    @BeforeEach
    void writeScenario() throws Exception {
        rsal = new Rsal(folder);
    }

    /// The same bytes for the same seed, and the same run as without.
    @Test
    void aRunIsRecordedAsABagOfRos2() throws Exception {
        Ended plain = rsal.run("run", "--headless", "--speed", "max", "--seed", "7", "--for", "10", "--json");
        Files.createDirectory(folder.resolve("again"));
        for (String bag : List.of("bag", "again/bag")) {
            Ended run = rsal.run(
                    "run",
                    "--headless",
                    "--speed",
                    "max",
                    "--seed",
                    "7",
                    "--for",
                    "10",
                    "--json",
                    "--record-ros2",
                    bag);
            assertThat(run.code()).as(run.err()).isEqualTo(Exit.SUCCESS);
            assertThat(run.err()).contains("Recorded to " + bag);
            assertThat(json(run).get("eventHash")).isEqualTo(json(plain).get("eventHash"));
        }
        for (String file : List.of("metadata.yaml", "bag_0.mcap")) {
            assertThat(folder.resolve("bag").resolve(file))
                    .hasSameBinaryContentAs(folder.resolve("again/bag").resolve(file));
        }
        Ended there = rsal.run("run", "--headless", "--for", "1", "--record-ros2", "bag");
        assertThat(there.code()).isEqualTo(Exit.INVALID);
        assertThat(there.err()).contains("The folder is not empty", "--force");

        Ended mapped = rsal.run("map", "bag", "--out", "map");
        assertThat(mapped.code()).as(mapped.err()).isEqualTo(Exit.SUCCESS);
        assertThat(OfficialBagReader.topics(folder.resolve("bag")))
                .contains(
                        "/clock rosgraph_msgs/msg/Clock 100 VOLATILE",
                        "/hunter_1/ground_truth geometry_msgs/msg/PoseStamped 100 VOLATILE",
                        "/map nav_msgs/msg/OccupancyGrid 1 TRANSIENT_LOCAL")
                .anySatisfy(topic -> assertThat(topic).startsWith("/tf_static tf2_msgs/msg/TFMessage"))
                .anySatisfy(topic -> assertThat(topic).startsWith("/prey_1/scan sensor_msgs/msg/LaserScan"));
    }

    @Test
    void logsAreConvertedToBagsAndBack() throws Exception {
        var log = new StringBuilder();
        for (int i = 0; i < 30; i++) {
            log.append("ODOM %s 0 0 0.4 0 0 %s robot 0%n".formatted(0.1 * i, 100 + 0.25 * i))
                    .append("FLASER 4 1 2 3 4 %1$s 0 0 %1$s 0 0 %2$s robot 0%n".formatted(0.1 * i, 100 + 0.25 * i));
        }
        Files.writeString(folder.resolve("lab.log"), log);
        Ended bag = rsal.run("convert", "lab.log", "lab_bag/");
        assertThat(bag.code()).as(bag.err()).isZero();
        assertThat(bag.out()).contains("lab_bag: 30 scans, 30 messages of odometry");
        Ended back = rsal.run("convert", "lab_bag", "back.log", "--json");
        assertThat(back.code()).as(back.err()).isZero();
        assertThat(json(back).get("scans").asInt()).isEqualTo(30);
        assertThat(Files.readString(folder.resolve("back.log"))).contains("ROBOTLASER1", "ODOM");
        Ended there = rsal.run("convert", "lab_bag", "back.log");
        assertThat(there.code()).isEqualTo(Exit.INVALID);
        assertThat(there.err()).contains("there already", "Use --force");
        Ended unknown = rsal.run("convert", "lab_bag", "back.pcd");
        assertThat(unknown.code()).isEqualTo(Exit.INVALID);
        assertThat(unknown.err()).contains("back.pcd", "OUT.log", "FOLDER/", "FILE.world");
        Ended none = rsal.run("convert", "nothing.log", "some/");
        assertThat(none.err()).contains("There is no such file");
        assertThat(folder.resolve("some")).doesNotExist();
    }

    @Test
    void aRunIsRecordedShownRunAgainAndExported() throws Exception {
        Ended plain = rsal.run("run", "--headless", "--speed", "max", "--seed", "7", "--for", "20", "--json");
        Ended run = rsal.run(
                "run", "--headless", "--speed", "max", "--seed", "7", "--for", "20", "--json", "--record", "run.mcap");
        assertThat(run.code()).as(run.err()).isEqualTo(Exit.SUCCESS);
        assertThat(run.err()).contains("Recorded to run.mcap");
        assertThat(json(run).get("eventHash")).isEqualTo(json(plain).get("eventHash"));

        Ended shown = rsal.run("show", "run.mcap");
        assertThat(shown.code()).as(shown.err()).isEqualTo(Exit.SUCCESS);
        assertThat(shown.out())
                .contains("hunt-and-prey:", "seed 7", "20.0 s", "outcome limit", "/tf", "foxglove.LaserScan")
                .contains("rsal run --headless")
                .doesNotContain("Damaged");

        Ended verified = rsal.run("replay", "run.mcap", "--verify");
        assertThat(verified.code()).as(verified.err()).isEqualTo(Exit.SUCCESS);
        assertThat(verified.out())
                .matches(
                        "The same: \\d+ events, [1-9]\\d* messages and 20[01] states of all robots and agents in 20\\.00 s.\\R");

        Ended exported = rsal.run("export", "run.mcap", "--csv", "tables");
        assertThat(exported.code()).as(exported.err()).isEqualTo(Exit.SUCCESS);
        List<String> state = Files.readAllLines(folder.resolve("tables/state.csv"));
        assertThat(state.getFirst()).startsWith("log_time_s,").contains("robots.id", "robots.truth.x");
        assertThat(state).anyMatch(row -> row.contains(",hunter-1,"));
        assertThat(folder.resolve("tables/events.csv")).isNotEmptyFile();
        assertThat(rsal.run("export", "run.mcap", "--csv", "tables").err()).contains("--force");

        Ended drawn = rsal.run("export", "run.mcap", "--gif", "run.gif", "--size", "300", "--speed", "20");
        assertThat(drawn.code()).as(drawn.err()).isEqualTo(Exit.SUCCESS);
        assertThat(drawn.out()).isEqualToIgnoringNewLines("run.gif");
        assertThat(ImageIO.read(folder.resolve("run.gif").toFile()).getWidth()).isEqualTo(300);
        assertThat(rsal.run("export", "run.mcap", "--gif", "run.gif").err()).contains("--force");
    }

    @Test
    void whatHoldsNothingToCompareIsNotCalledTheSame() throws Exception {
        rsal.run("run", "--headless", "--speed", "max", "--seed", "7", "--for", "20", "--record", "run.mcap");
        byte[] whole = Files.readAllBytes(folder.resolve("run.mcap"));
        Files.write(folder.resolve("run.mcap"), Arrays.copyOf(whole, 40_000)); // scenario and map, no whole chunk after
        Ended verified = rsal.run("replay", "run.mcap", "--verify");
        assertThat(verified.code()).as(verified.err()).isEqualTo(Exit.NO_SUCCESS);
        assertThat(verified.out()).contains("Nothing was compared");
        assertThat(verified.err()).contains("cut off");
    }

    @Test
    @LongTest
    void foxgloveIsInformedWhereToLook() throws Exception {
        Ended plain = rsal.run("run", "--headless", "--speed", "max", "--seed", "7", "--for", "2", "--json");
        Ended run = rsal.run(
                "run", "--headless", "--speed", "max", "--seed", "7", "--for", "2", "--json", "--foxglove-port", "0");
        assertThat(run.code()).as(run.err()).isEqualTo(Exit.SUCCESS);
        assertThat(run.err()).contains("In Foxglove, open a connection to ws://localhost:", "/?token=");
        assertThat(json(run).get("eventHash")).isEqualTo(json(plain).get("eventHash"));
        try (var taken = new ServerSocket(0, 1, InetAddress.getLoopbackAddress())) {
            String port = Integer.toString(taken.getLocalPort());
            Ended refused = rsal.run("run", "--headless", "--for", "1", "--foxglove-port", port);
            assertThat(refused.code()).isEqualTo(Exit.UNREACHABLE);
            assertThat(refused.err()).contains("Port " + port + " is in use", "--foxglove-port");
        }
    }

    @Test
    void errorsAreReportedBeforeAnythingRuns() throws Exception {
        Files.writeString(folder.resolve("there.mcap"), "precious");
        Ended there = rsal.run("run", "--headless", "--for", "1", "--record", "there.mcap");
        assertThat(there.code()).isEqualTo(Exit.INVALID);
        assertThat(there.err()).contains("there.mcap", "The file is there already", "--force");
        assertThat(folder.resolve("there.mcap")).hasContent("precious");
        Ended nowhere = rsal.run("run", "--headless", "--for", "1", "--record", "no/such/folder.mcap");
        assertThat(nowhere.code()).isEqualTo(Exit.INVALID);
        assertThat(nowhere.err()).contains("No recording can be written");
        Ended none = rsal.run("show", "there.mcap");
        assertThat(none.code()).isEqualTo(Exit.INVALID);
        assertThat(none.err()).contains("is not an MCAP file");
        assertThat(rsal.run("replay", "missing.mcap", "--verify").err()).contains("There is no file");
        assertThat(rsal.run("replay", "there.mcap").err()).contains("is not an MCAP file");
        assertThat(rsal.run("replay", "there.mcap", "--verify", "--port", "0").code())
                .isEqualTo(Exit.USAGE);
        assertThat(rsal.run("replay", "there.mcap", "--json").code()).isEqualTo(Exit.USAGE);
    }

    @Test
    @EnabledOnOs(OS.LINUX)
    void aFullDiskIsReported() throws Exception {
        Ended full = rsal.run("run", "--headless", "--for", "1", "--record", "/dev/full", "--force");
        assertThat(full.code()).isEqualTo(Exit.INVALID);
        assertThat(full.err()).contains("No space left");
    }

    /// A process that is killed loses a second at most; what is there is run again and is the same.
    @Test
    void aKilledRunLeavesARecording() throws Exception {
        Path file = folder.resolve("run.mcap");
        Process process =
                rsal.start("run", "--headless", "--speed", "4", "--seed", "7", "--for", "600", "--record", "run.mcap");
        try {
            awaitSize(file, 300_000, process);
        } finally {
            process.destroyForcibly().waitFor();
        }
        Ended shown = rsal.run("show", "run.mcap", "--json");
        assertThat(shown.code()).as(shown.err()).isEqualTo(Exit.SUCCESS);
        JsonNode recording = json(shown);
        assertThat(recording.get("damage").size()).isPositive();
        assertThat(recording.get("seconds").asDouble()).isPositive();
        Ended verified = rsal.run("replay", "run.mcap", "--verify");
        assertThat(verified.code()).as(verified.err()).isEqualTo(Exit.SUCCESS);
        assertThat(verified.out()).contains("The same up to", "the recording ends before the run did");
    }

    @Test
    void aRunThatIsInterruptedIsRecordedWhole() throws Exception {
        Path file = folder.resolve("run.mcap");
        Process process = rsal.start("run", "--headless", "--speed", "4", "--for", "600", "--record", "run.mcap");
        awaitSize(file, 200_000, process);
        Ended.signal("INT", process);
        assertThat(Ended.of(process).code()).isEqualTo(130);
        JsonNode recording = json(rsal.run("show", "run.mcap", "--json"));
        assertThat(recording.get("damage").size()).isZero();
        assertThat(recording.get("result").get("outcome").asString()).isEqualTo("stopped");
    }

    /// Who watches sees it as it is recorded, and changes neither.
    @Test
    @LongTest
    void aRunThatIsWatchedIsRecordedAsAnyOther() throws Exception {
        Ended alone = rsal.run("run", "--headless", "--speed", "max", "--seed", "7", "--for", "20", "--json");
        Process process = rsal.withPage()
                .start("run --once --speed 2 --seed 7 --for 20 --json --record run.mcap --port 0".split(" ", -1));
        var frames = new AtomicInteger();
        try (var err = process.errorReader();
                var client = HttpClient.newHttpClient()) {
            URI page = Rsal.page(err);
            client.newWebSocketBuilder()
                    .buildAsync(URI.create("ws://" + page.getAuthority() + "/api/live"), new WebSocket.Listener() {
                        @Override
                        public CompletionStage<?> onBinary(WebSocket line, ByteBuffer frame, boolean last) {
                            frames.incrementAndGet();
                            line.request(1);
                            return CompletableFuture.completedFuture(null);
                        }
                    })
                    .join();
            String result = new String(process.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
            assertThat(JsonMapper.shared().readTree(result).get("eventHash"))
                    .isEqualTo(json(alone).get("eventHash"));
            client.shutdownNow();
        } finally {
            process.destroyForcibly().waitFor();
        }
        assertThat(frames).hasPositiveValue();
        assertThat(rsal.run("replay", "run.mcap", "--verify").out())
                .startsWith("The same: ")
                .contains("20.00 s");
    }

    /// The page of a recording: it can be looked at, and not be told anything; Ctrl-C ends it.
    @Test
    void aRecordingIsShownInThePage() throws Exception {
        assertThat(rsal.run("run", "--headless", "--speed", "max", "--for", "5", "--record", "run.mcap")
                        .code())
                .isEqualTo(Exit.SUCCESS);
        assertThat(rsal.run("replay", "run.mcap").err()).contains("The page is not built");
        byte[] whole = Files.readAllBytes(folder.resolve("run.mcap"));
        Files.write(folder.resolve("cut.mcap"), Arrays.copyOf(whole, whole.length * 2 / 3));
        for (String file : List.of("run.mcap", "cut.mcap")) {
            Process process = rsal.withPage().start("replay", file, "--port", "0");
            try (var err = process.errorReader()) {
                URI url = Rsal.page(err);
                assertThat(ask(url.resolve("/api/run"))
                                .get("recording")
                                .get("name")
                                .asString())
                        .isEqualTo(file);
                assertThat(ask(url.resolve("/api/run"))
                                .get("recording")
                                .get("damage")
                                .isEmpty())
                        .isEqualTo(file.equals("run.mcap"));
                assertThat(ask(url.resolve("/api/readings?robot=prey-1&time=2")).has("readings"))
                        .as("of the one that is cut off, the last that is there")
                        .isTrue();
                assertThat(ask(url.resolve("/api/costs?robot=prey-1"))
                                .get("message")
                                .asString())
                        .contains("not recorded");
                Ended.signal("INT", process);
                assertThat(process.waitFor(20, TimeUnit.SECONDS)).isTrue();
                assertThat(process.exitValue()).isEqualTo(130);
            } finally {
                process.destroyForcibly().waitFor();
            }
        }
    }

    private static JsonNode ask(URI url) throws Exception {
        try (var client = HttpClient.newHttpClient()) {
            return JsonMapper.shared()
                    .readTree(client.send(HttpRequest.newBuilder(url).build(), HttpResponse.BodyHandlers.ofString())
                            .body());
        }
    }

    private static void awaitSize(Path file, long bytes, Process process) throws Exception {
        for (int i = 0; !Files.exists(file) || Files.size(file) < bytes; i++) {
            assertThat(i).as("looks at %s", file).isLessThan(600);
            assertThat(process.waitFor(100, TimeUnit.MILLISECONDS)).as("ended").isFalse();
        }
    }

    private static JsonNode json(Ended ended) {
        return JsonMapper.shared().readTree(ended.out());
    }
}
