package rsal.server;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static rsal.server.Errand.TOKEN;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.net.ConnectException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.NetworkInterface;
import java.net.ServerSocket;
import java.net.Socket;
import java.net.URI;
import java.net.http.HttpClient;
import java.net.http.HttpRequest;
import java.net.http.HttpResponse;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.Optional;
import java.util.Random;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import java.util.zip.GZIPInputStream;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Nested;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.TestInfo;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import rsal.data.OccupancyGrid;
import rsal.engine.LiveRun;
import rsal.engine.report.RunEvent;
import rsal.engine.report.Snapshot;
import rsal.server.RawHttp.Response;
import rsal.server.http.Http;
import rsal.server.message.Json;
import rsal.testkit.Trials;

class RunServerTest {
    private static final String WITH_TOKEN = "Authorization: Bearer " + TOKEN;

    /// Of tests that change nothing: all of them have one server.
    private static final String UNCHANGED = "unchanged";

    @TempDir
    private static Path page;

    private static Optional<RunServer> unchanged = Optional.empty();

    @TempDir
    private Path directory;

    private boolean isUnchanged;
    private RunServer server;
    private int port;
    private String host;

    @BeforeEach
    void start(TestInfo test) throws IOException, PortInUse {
        isUnchanged = test.getTags().contains(UNCHANGED);
        server = isUnchanged ? ofAll() : Errand.serve(directory, 0);
        port = server.url().getPort();
        host = "Host: 127.0.0.1:" + port;
    }

    private static RunServer ofAll() throws IOException, PortInUse {
        if (unchanged.isEmpty()) {
            unchanged = Optional.of(Errand.serve(page, 0));
        }
        return unchanged.orElseThrow();
    }

    @AfterEach
    void stop() {
        if (!isUnchanged) {
            server.close();
        }
    }

    @AfterAll
    static void stopThatOfAll() {
        unchanged.ifPresent(RunServer::close);
        unchanged = Optional.empty();
    }

    private Response get(String path) throws IOException {
        return RawHttp.get(port, path, host);
    }

    private Response post(String command, String body) throws IOException {
        return RawHttp.post(port, "/api/run/" + command, body, host, WITH_TOKEN);
    }

    /// The first snapshot that is as wanted; the run makes a new one whenever it is asked.
    private static Snapshot await(LiveRun run, java.util.function.Predicate<Snapshot> wanted)
            throws InterruptedException {
        while (true) {
            var news = new CountDownLatch(1);
            try (var _ = run.onSnapshot(news::countDown)) {
                Snapshot snapshot = run.snapshot();
                if (wanted.test(snapshot)) {
                    return snapshot;
                }
                news.await();
            }
        }
    }

    private static RunEvent awaitEvent(LiveRun run, String kind) throws InterruptedException {
        while (true) {
            var news = new CountDownLatch(1);
            try (var _ = run.onEvents(news::countDown)) {
                var found = run.events(0).stream()
                        .filter(e -> e.kind().equals(kind))
                        .findFirst();
                if (found.isPresent()) {
                    return found.get();
                }
                news.await();
            }
        }
    }

    @Nested
    class Looking {
        @Test
        void needsNoToken() throws IOException {
            assertThat(get("/api/run").status()).isEqualTo(200);
            assertThat(get("/api/run").body())
                    .contains("\"scenario\":\"errand\"", "\"configuration\":\"one\"", "\"seed\":\"7\"")
                    .contains("\"id\":\"courier-1\"", "\"Pioneer 2-DX\"")
                    .contains("\"name\":\"couriers\"", "\"min\":1.0,\"max\":4.0")
                    .contains("{\"name\":\"way\",\"unit\":\"m\",\"min\":null,\"max\":50.0}");
            assertThat(get("/").body()).contains("The page");
        }

        @Test
        void getsTheMapOfTheRunThatIsShown() throws Exception {
            byte[] cells = server.run().plan().map().cells();
            assertThat(unpacked("/api/map/1")).isEqualTo(cells);
            assertThat(get("/api/map/2").status()).isEqualTo(404);
            assertThat(get("/api/drawn/1?robot=nobody").status()).isEqualTo(404);
            assertThat(get("/api/drawn/1").text()).contains("has drawn no map");
            assertThat(get("/api/drawn/1/files?robot=nobody").status()).isEqualTo(404);
            assertThat(get("/api/costs?robot=nobody").status()).isEqualTo(409);
        }

        private byte[] unpacked(String path) throws Exception {
            try (var socket = java.net.http.HttpClient.newHttpClient()) {
                var response = socket.send(
                        java.net.http.HttpRequest.newBuilder(server.url().resolve(path))
                                .build(),
                        java.net.http.HttpResponse.BodyHandlers.ofInputStream());
                return new GZIPInputStream(response.body()).readAllBytes();
            }
        }

        @Test
        void getsWhatPlacesCostARobot() throws Exception {
            OccupancyGrid map = server.run().plan().map();
            ByteBuffer reported =
                    ByteBuffer.wrap(unpacked("/api/costs?robot=courier-1")).order(ByteOrder.LITTLE_ENDIAN);
            assertThat(reported.getInt()).isEqualTo(map.width());
            assertThat(reported.getInt()).isEqualTo(map.height());
            assertThat(List.of(reported.getDouble(), reported.getDouble(), reported.getDouble()))
                    .containsExactly(map.resolution(), map.originX(), map.originY());
            assertThat(reported.remaining()).isEqualTo(map.cells().length);
            int free = 0;
            for (byte cell : map.cells()) {
                byte cost = reported.get();
                if (cell == OccupancyGrid.OCCUPIED) {
                    assertThat(cost).isEqualTo(OccupancyGrid.OCCUPIED);
                }
                free += cost >= 0 && cost < 100 ? 1 : 0;
            }
            assertThat(free).as("where the robot can be").isPositive();
        }

        @Test
        void sendsWhatIsPackedToThoseWhoTakeThat() throws Exception {
            URI script = server.url().resolve("/assets/index-1a2b.js");
            assertThat(packed(script, "deflate, gzip;q=0.8, br")).isEqualTo("/* the page's code */");
            for (String accepted : List.of("deflate", "gzip;q=0", "x-gzip")) {
                assertThat(RawHttp.get(port, "/assets/index-1a2b.js", host, "Accept-Encoding: " + accepted)
                                .text())
                        .contains("Vary: Accept-Encoding", "the page's code")
                        .doesNotContain("Content-Encoding");
            }
            assertThat(get("/assets/index-1a2b.js.gz").status()).isEqualTo(404);
        }

        private static String packed(URI address, String accepted) throws Exception {
            try (HttpClient http = HttpClient.newHttpClient()) {
                var request = HttpRequest.newBuilder(address)
                        .header("Accept-Encoding", accepted)
                        .build();
                HttpResponse<byte[]> response = http.send(request, HttpResponse.BodyHandlers.ofByteArray());
                assertThat(response.headers().firstValue("content-encoding")).contains("gzip");
                try (var unpacked = new GZIPInputStream(new ByteArrayInputStream(response.body()))) {
                    return new String(unpacked.readAllBytes(), StandardCharsets.UTF_8);
                }
            }
        }

        @Test
        void findsOnlyFilesOfThePage() throws IOException {
            assertThat(get("/assets/index-1a2b.js").text()).contains("immutable", "text/javascript", "the page's code");
            assertThat(get("/index.html").status()).isEqualTo(200);
            for (String path : List.of(
                    "/nothing",
                    "/../secret",
                    "/assets/../../secret",
                    "/%2e%2e/secret",
                    "//etc/passwd",
                    "/assets",
                    "/api/x")) {
                assertThat(get(path).status()).as(path).isBetween(400, 404);
            }
        }

        @Test
        void isInFramesOfOtherProgramsWhereThatIsWanted() throws Exception {
            var options = new RunServer.Options(
                    0,
                    TOKEN,
                    directory,
                    List.of(),
                    _ -> {},
                    LiveRun::start,
                    Optional::empty,
                    Optional.empty(),
                    Optional.empty(),
                    true);
            try (var framed = RunServer.start(Errand.plan(), options)) {
                int at = framed.url().getPort();
                assertThat(RawHttp.get(at, "/", "Host: 127.0.0.1:" + at).text())
                        .contains("frame-ancestors 'self' http://127.0.0.1:* http://localhost:*\r\n")
                        .doesNotContain("X-Frame-Options");
            }
        }

        @Test
        void isProtectedByHeadersEvenWhenItFails() throws IOException {
            for (String path : List.of("/", "/api/run", "/api/map/1", "/nothing")) {
                assertThat(get(path).text())
                        .as(path)
                        .contains("Content-Security-Policy: default-src 'none'; script-src 'self'")
                        .contains(
                                "frame-ancestors 'self'",
                                "X-Content-Type-Options: nosniff",
                                "X-Frame-Options: SAMEORIGIN")
                        .contains("Referrer-Policy: no-referrer")
                        .doesNotContain("unsafe", "Server:");
            }
        }
    }

    @Nested
    @Tag(UNCHANGED)
    class Doors {
        @ParameterizedTest
        @ValueSource(strings = {"127.0.0.1:%d", "localhost:%d", "[::1]:%d"})
        void openToOurNames(String name) throws IOException {
            String ours = name.formatted(port);
            assertThat(RawHttp.get(port, "/api/run", "Host: " + ours).status()).isEqualTo(200);
            assertThat(RawHttp.get(port, "/api/run", "Host: " + ours, "Origin: http://" + ours)
                            .status())
                    .isEqualTo(200);
            assertThat(RawHttp.upgrade(port, "Host: " + ours, "Origin: http://" + ours)
                            .status())
                    .isEqualTo(101);
        }

        @ParameterizedTest
        @ValueSource(
                strings = {
                    "evil.example",
                    "evil.example:%d",
                    "127.0.0.1",
                    "localhost",
                    "127.0.0.1:1",
                    "localhost.:%d",
                    "127.0.0.1:%d.evil.example",
                    "0.0.0.0:%d",
                    "127.1:%d"
                })
        void closedToOtherNames(String name) throws IOException {
            String foreign = "Host: " + name.formatted(port);
            assertThat(RawHttp.get(port, "/", foreign).status()).isBetween(400, 421);
            assertThat(RawHttp.get(port, "/api/run", foreign).status()).isBetween(400, 421);
            assertThat(RawHttp.post(port, "/api/run/pause", "", foreign, WITH_TOKEN)
                            .status())
                    .isBetween(400, 421);
            assertThat(RawHttp.upgrade(port, foreign).status()).isBetween(400, 421);
        }

        @ParameterizedTest
        @ValueSource(
                strings = {
                    "null",
                    "http://evil.example",
                    "https://127.0.0.1:%d",
                    "http://127.0.0.1",
                    "http://127.0.0.1:1",
                    "http://localhost:%d",
                    "http://127.0.0.1:%d/",
                    "file://",
                    ""
                })
        void closedToPagesOfOthers(String origin) throws IOException {
            String foreign = "Origin: " + origin.formatted(port);
            assertThat(RawHttp.get(port, "/api/run", host, foreign).status()).isEqualTo(403);
            assertThat(RawHttp.post(port, "/api/run/pause", "", host, foreign, WITH_TOKEN)
                            .status())
                    .isEqualTo(403);
            assertThat(RawHttp.upgrade(port, host, foreign).status()).isEqualTo(403);
        }

        @ParameterizedTest
        @ValueSource(strings = {"/", "/api/run", "/nothing", "/metrics", "/beside/9/api/run"})
        void closedToWhatOtherSitesSend(String path) throws IOException {
            Response refused = RawHttp.get(port, path, host, "Sec-Fetch-Site: cross-site");
            assertThat(refused.status()).isEqualTo(403);
            assertThat(refused.text()).contains("Content-Security-Policy: default-src 'none'");
            assertThat(RawHttp.get(port, path, host, "Sec-Fetch-Site: same-origin")
                            .status())
                    .isNotEqualTo(403);
        }

        @ParameterizedTest
        @ValueSource(strings = {"/", "/api/run", "/api/live/", "/api/other", "/nothing", "/beside/1/api", "/metrics"})
        void closedToWebSocketsThatAreNone(String path) throws IOException {
            Response refused = RawHttp.upgradeAt(port, path, host);
            assertThat(refused.status()).isEqualTo(404);
            assertThat(refused.text()).doesNotContainIgnoringCase("cookie");
            assertThat(RawHttp.upgradeAt(port, path, "Host: evil.example").status())
                    .isEqualTo(421);
            assertThat(RawHttp.upgradeAt(port, path, host, "Origin: http://evil.example")
                            .status())
                    .isEqualTo(403);
        }

        /// None of these reads what it is sent.
        private static final List<String> UNREAD = List.of(
                "/api/session",
                "/api/run/pause",
                "/api/run/estop",
                "/api/run/no-such-command",
                "/nothing",
                "/api/live");

        /// Else a client's next request on the connection fails.
        @ParameterizedTest
        @ValueSource(booleans = {true, false})
        void keepsConnectionsBehindBodiesThatItDoesNotRead(boolean trusted) throws IOException {
            for (String path : UNREAD) {
                String first = "POST %s HTTP/1.1\r\n%s\r\n%sContent-Length: 5\r\n\r\n{\"a\":"
                        .formatted(path, host, trusted ? WITH_TOKEN + "\r\n" : "");
                String second = "GET /healthz HTTP/1.1\r\n%s\r\nConnection: close\r\n\r\n".formatted(host);
                Response both = RawHttp.send(port, (first + second).getBytes(StandardCharsets.ISO_8859_1));
                assertThat(both.text().split("HTTP/1.1 ", -1)).as(path).hasSize(3);
                assertThat(both.text()).as(path).contains("HTTP/1.1 200");
            }
        }

        @ParameterizedTest
        @ValueSource(booleans = {true, false})
        void saysThatItClosesConnectionsWhoseBodiesAreStillToCome(boolean trusted) throws IOException {
            for (String path : UNREAD) {
                String head = "POST %s HTTP/1.1\r\n%s\r\n%sContent-Length: 5\r\n\r\n"
                        .formatted(path, host, trusted ? WITH_TOKEN + "\r\n" : "");
                Response answer = RawHttp.send(port, head.getBytes(StandardCharsets.ISO_8859_1));
                assertThat(answer.text()).as(path).containsIgnoringCase("\r\nConnection: close\r\n");
            }
        }

        @Test
        void closedToOtherMachines() throws IOException {
            for (NetworkInterface network : NetworkInterface.networkInterfaces().toList()) {
                for (InetAddress address : network.inetAddresses().toList()) {
                    if (!address.isLoopbackAddress() && address instanceof java.net.Inet4Address) {
                        assertThatThrownBy(() -> {
                                    try (var socket = new Socket()) {
                                        socket.connect(new InetSocketAddress(address, port), 1000);
                                    }
                                })
                                .as("%s", address)
                                .isInstanceOf(ConnectException.class);
                    }
                }
            }
        }

        @ParameterizedTest
        @ValueSource(
                strings = {
                    "pause",
                    "resume",
                    "step",
                    "speed",
                    "stop",
                    "place",
                    "goal",
                    "drive",
                    "release",
                    "behavior",
                    "believe",
                    "add-agent",
                    "new-agent",
                    "watch",
                    "start-agent",
                    "stop-agent",
                    "say",
                    "add",
                    "add-robot",
                    "new-robot",
                    "remove",
                    "estop",
                    "rearm",
                    "motors",
                    "check",
                    "restart"
                })
        void openToChangesOnlyWithTheToken(String command) throws IOException {
            String path = "/api/run/" + command;
            LiveRun before = server.run();
            assertThat(RawHttp.post(port, path, "{}", host).status()).isEqualTo(401);
            assertThat(RawHttp.post(port, path, "{}", host, "Authorization: Bearer ")
                            .status())
                    .isEqualTo(401);
            assertThat(RawHttp.post(port, path, "{}", host, "Authorization: Bearer the-tokem")
                            .status())
                    .isEqualTo(401);
            assertThat(RawHttp.post(port, path, "{}", host, "Authorization: " + TOKEN)
                            .status())
                    .isEqualTo(401);
            assertThat(RawHttp.get(port, path, host, WITH_TOKEN).status()).isEqualTo(404);
            assertThat(server.run()).isSameAs(before);
            assertThat(server.run().result().toCompletableFuture()).isNotDone();
        }

        @Test
        void sayWhichPortIsTaken() throws IOException {
            try (var taken = new ServerSocket(0, 1, InetAddress.ofLiteral("127.0.0.1"))) {
                int there = taken.getLocalPort();
                assertThatThrownBy(() -> Errand.serve(directory, there))
                        .isInstanceOf(PortInUse.class)
                        .hasMessageContaining(Integer.toString(there))
                        .hasMessageContaining("--port");
            }
        }

        @Test
        void sayHowToBuildThePageThatIsMissing() {
            var options = new RunServer.Options(0, TOKEN, directory.resolve("nowhere"), run -> {});
            assertThatThrownBy(() -> RunServer.start(Errand.plan(), options))
                    .isInstanceOf(IOException.class)
                    .hasMessageContaining("nowhere")
                    .hasMessageContaining("npm");
        }
    }

    @Nested
    class Commands {
        @Test
        void pauseAndStepTheRun() throws Exception {
            assertThat(post("pause", "").body()).isEqualTo("{}");
            Snapshot paused = await(server.run(), Snapshot::paused);
            assertThat(post("step", "").status()).isEqualTo(200);
            Snapshot next = await(server.run(), s -> s.time().compareTo(paused.time()) > 0);
            assertThat(next.time())
                    .isEqualTo(paused.time().plus(server.run().plan().step()));
            assertThat(post("resume", "").status()).isEqualTo(200);
            await(server.run(), s -> !s.paused());
        }

        @Test
        void setTheSpeed() throws Exception {
            assertThat(post("speed", "{\"factor\":\"0.5\"}").status()).isEqualTo(200);
            await(server.run(), s -> s.speed() == 0.5);
            assertThat(post("speed", "{\"factor\":\"max\"}").status()).isEqualTo(200);
            await(server.run(), s -> s.speed() == Double.POSITIVE_INFINITY);
        }

        @ParameterizedTest
        @ValueSource(strings = {"0", "-1", "0.05", "1e9", "NaN", "Infinity", "fast", ""})
        void takeNoOddSpeed(String factor) throws IOException {
            Response response = post("speed", "{\"factor\":\"%s\"}".formatted(factor));
            assertThat(response.status()).isEqualTo(400);
            assertThat(response.body()).contains("0.1", "1000", "max", "'" + factor + "'");
        }

        @Test
        void placeARobot() throws Exception {
            Response response = post("place", "{\"robot\":\"courier-1\",\"x\":3,\"y\":-1,\"heading\":1.5}");
            assertThat(response.text()).contains("200 OK").endsWith("{}");
            await(
                    server.run(),
                    s -> !s.robots().isEmpty()
                            && s.robots().getFirst().truth().orElseThrow().distanceTo(new rsal.data.Pose2d(3, -1, 0))
                                    < 0.1);
        }

        @Test
        void sendARobotSomewhere() throws Exception {
            assertThat(post("goal", "{\"robot\":\"courier-1\",\"x\":3,\"y\":-1,\"heading\":0}")
                            .status())
                    .isEqualTo(200);
            await(
                    server.run(),
                    s -> !s.robots().isEmpty() && s.robots().getFirst().goal().isPresent());
        }

        @Test
        void reportWhenARobotCannotGetWhereItWasSent() throws Exception {
            String inACorner = "{\"robot\":\"courier-1\",\"x\":18.4,\"y\":-6.4,\"heading\":0}";
            assertThat(post("goal", inACorner).status()).isEqualTo(200);
            RunEvent event = awaitEvent(server.run(), "unreached");
            assertThat(event.subject()).isEqualTo("courier-1");
            assertThat(event.text()).startsWith("can't get to (18.40, -6.40, 0°): no path. ");
        }

        @Test
        void sayWhyNot() throws IOException {
            Response nobody = post("goal", "{\"robot\":\"nobody\",\"x\":3,\"y\":-1,\"heading\":0}");
            assertThat(nobody.status()).isEqualTo(409);
            assertThat(nobody.body()).contains("nobody");
            Response wall = post("place", "{\"robot\":\"courier-1\",\"x\":900,\"y\":-1,\"heading\":0}");
            assertThat(wall.status()).isEqualTo(409);
            assertThat(wall.body()).contains("900");
        }

        @Test
        void addMoveAndRemoveThings() throws Exception {
            await(server.run(), snapshot -> !snapshot.robots().isEmpty());
            assertThat(post("add", "{\"kind\":\"BOX\",\"x\":3,\"y\":-1,\"heading\":0}")
                            .body())
                    .isEqualTo("{\"name\":\"box-1\"}");
            assertThat(post("place", "{\"robot\":\"box-1\",\"x\":5,\"y\":-1,\"heading\":1}")
                            .body())
                    .isEqualTo("{}");
            await(
                    server.run(),
                    snapshot -> snapshot.things().size() == 1
                            && snapshot.things().getFirst().mapFromThing().x() == 5);
            assertThat(post("remove", "{\"name\":\"box-1\"}").body()).isEqualTo("{}");
            await(server.run(), snapshot -> snapshot.things().isEmpty());
        }

        @Test
        void addAndRemoveRobots() throws Exception {
            await(server.run(), snapshot -> !snapshot.robots().isEmpty());
            assertThat(post("add-robot", "{\"robot\":\"courier-1\",\"x\":3,\"y\":-1,\"heading\":0}")
                            .body())
                    .isEqualTo("{\"name\":\"courier-2\"}");
            await(server.run(), snapshot -> snapshot.agents().size() == 2);
            assertThat(get("/api/run").body()).contains("\"id\":\"courier-2\"");
            assertThat(post("remove", "{\"name\":\"courier-1\"}").body()).isEqualTo("{}");
            await(server.run(), snapshot -> snapshot.robots().size() == 1);
        }

        @Test
        void addRobotsOfModels() throws Exception {
            await(server.run(), snapshot -> !snapshot.robots().isEmpty());
            assertThat(get("/api/robots/models").body())
                    .contains("{\"model\":\"pioneer2dx\",\"title\":\"Pioneer 2-DX\"}");
            assertThat(post("new-robot", "{\"model\":\"pioneer2dx\",\"x\":3,\"y\":-1,\"heading\":0}")
                            .body())
                    .isEqualTo("{\"name\":\"pioneer2dx-1\"}");
            await(server.run(), snapshot -> snapshot.robots().size() == 2);
            assertThat(get("/api/run").body()).contains("\"id\":\"pioneer2dx-1\"");
        }

        @Test
        void haveNoCostsWhereARobotPlansByNone() throws Exception {
            await(server.run(), snapshot -> !snapshot.robots().isEmpty());
            post("new-robot", "{\"model\":\"pioneer2dx\",\"x\":3,\"y\":-1,\"heading\":0}");
            await(server.run(), snapshot -> snapshot.robots().size() == 2);
            assertThat(get("/api/costs?robot=pioneer2dx-1"))
                    .returns(204, Response::status)
                    .returns("", Response::body);
        }

        @ParameterizedTest
        @CsvSource(quoteCharacter = '`', delimiter = '|', textBlock = """
                add       | {"kind":"BOX","x":900,"y":-1,"heading":0}           | 409 | outside
                add       | {"kind":"CAT","x":3,"y":-1,"heading":0}             | 400 | 'kind' must be one of BOX, BALL
                add       | {"x":3,"y":-1,"heading":0}                          | 400 | kind
                add       | {"kind":"BALL","x":1e9,"y":-1,"heading":0}          | 400 | 'x' must be a number from -1000000
                add-robot | {"robot":"nobody","x":3,"y":-1,"heading":0}         | 409 | There is no 'nobody'
                add-robot | {"robot":"courier-1","x":900,"y":-1,"heading":0}    | 409 | outside
                new-robot | {"model":"pioneer2","x":3,"y":-1,"heading":0}       | 409 | Maybe 'pioneer2dx' was meant?
                new-robot | {"model":"pioneer2dx","x":900,"y":-1,"heading":0}   | 409 | outside
                new-robot | {"x":3,"y":-1,"heading":0}                          | 400 | model
                remove    | {"name":"nobody"}                                   | 409 | There is no 'nobody'
                remove    | {}                                                  | 400 | name
                motors    | {"robot":"nobody","on":true}                        | 409 | There is no 'nobody'
                """)
        void sayWhatCantBeAddedOrRemoved(String command, String body, int status, String why) throws Exception {
            await(server.run(), snapshot -> !snapshot.robots().isEmpty());
            Response response = post(command, body);
            assertThat(response.status()).isEqualTo(status);
            assertThat(response.body()).contains(why);
        }

        @Test
        void stopAllRobotsUntilTheyAreRearmed() throws Exception {
            assertThat(post("estop", "").status()).isEqualTo(200);
            await(server.run(), Snapshot::stopped);
            assertThat(post("rearm", "").status()).isEqualTo(200);
            await(server.run(), s -> !s.stopped());
        }

        @Test
        void switchTheMotorsOfOneRobot() throws Exception {
            await(server.run(), snapshot -> !snapshot.robots().isEmpty());
            assertThat(post("motors", "{\"robot\":\"courier-1\",\"on\":false}").status())
                    .isEqualTo(200);
            await(server.run(), snapshot -> snapshot.robots().getFirst().stopped());
            assertThat(post("estop", "").status()).isEqualTo(200);
            assertThat(post("rearm", "").body()).matches("\\{\"on\":\\d+,\"off\":\\[\"courier-1\"]}");
            assertThat(post("motors", "{\"robot\":\"courier-1\",\"on\":true}").status())
                    .isEqualTo(200);
            await(server.run(), snapshot -> !snapshot.robots().getFirst().stopped());
        }

        @Test
        void areRefusedWhenTheRunIsOver() throws Exception {
            assertThat(post("stop", "").status()).isEqualTo(200);
            server.run().result().toCompletableFuture().join();
            Response response = post("pause", "");
            assertThat(response.status()).isEqualTo(409);
            assertThat(response.body()).contains("over");
        }
    }

    @Nested
    class Restarting {
        @Test
        void beginsAnotherRunAsAskedFor() throws Exception {
            LiveRun first = server.run();
            post("speed", "{\"factor\":\"5\"}");
            await(first, s -> s.speed() == 5);
            Response response =
                    post("restart", "{\"configuration\":\"pair\",\"seed\":\"9007199254740993\",\"arguments\":{}}");
            assertThat(response.body())
                    .contains("\"number\":2", "\"configuration\":\"pair\"", "\"seed\":\"9007199254740993\"")
                    .contains("\"id\":\"courier-2\"");
            assertThat(first.result().toCompletableFuture()).isCompleted();
            assertThat(server.run().plan().speed()).isEqualTo(5);
            assertThat(server.run().plan().seed()).isEqualTo(9_007_199_254_740_993L);
        }

        @Trials(
                value = {
                    "readings?robot=courier-2",
                    "numbers?robot=courier-2",
                    "abilities?robot=courier-2",
                    "costs?robot=courier-2",
                    "agent?name=nav-2"
                },
                landing = 2)
        void saysNothingToWhoeverAsksAboutTheRunBefore(String question) throws IOException {
            post("restart", "{\"configuration\":\"pair\"}");
            assertThat(get("/api/" + question + "&run=2").status()).isIn(200, 204); // no costs where nobody drives
            post("restart", "{\"configuration\":\"one\"}");
            Response late = get("/api/" + question + "&run=2");
            assertThat(late.status()).isEqualTo(204);
            assertThat(late.body()).isEmpty();
            assertThat(get("/api/" + question + "&run=3").status()).isEqualTo(409);
        }

        @ParameterizedTest
        @ValueSource(strings = {"abilities?robot=courier-1", "costs?robot=courier-1", "links?robot=courier-1"})
        void saysNothingToWhoeverDoesNotKnowYetThatTheRunIsOver(String question) throws Exception {
            post("stop", "{}");
            server.run().result().toCompletableFuture().get(10, TimeUnit.SECONDS);
            assertThat(get("/api/" + question).status()).isEqualTo(409);
            assertThat(get("/api/" + question + "&run=1"))
                    .returns(204, Response::status)
                    .returns("", Response::body);
        }

        /// A page that is opened while another run begins asks for the map of the one that it was told of.
        @Test
        void saysNothingOfTheMapsOfARunThatAnotherHasFollowed() throws IOException {
            post("restart", "{}");
            for (String map : List.of("map/1", "drawn/1?robot=courier-1")) {
                assertThat(get("/api/" + map)).returns(204, Response::status).returns("", Response::body);
            }
            assertThat(get("/api/map/2").status()).isEqualTo(200);
            for (String wrong : List.of("3", "0", "-1", "x", "99999999999")) {
                assertThat(get("/api/map/" + wrong).status()).as(wrong).isEqualTo(404);
            }
        }

        @Test
        void refusesCommandsWhateverRunTheyName() throws Exception {
            post("stop", "{}");
            server.run().result().toCompletableFuture().get(10, TimeUnit.SECONDS);
            assertThat(post("pause?run=1", "{}").status()).isEqualTo(409);
            assertThat(post("pause?run=9", "{}").status()).isEqualTo(409);
            assertThat(get("/api/drawn/1?robot=courier-1&run=1").status()).isEqualTo(404);
        }

        @Test
        void goesAsFastAsAskedFor() throws IOException {
            post("restart", "{\"speed\":\"max\"}");
            assertThat(server.run().plan().speed()).isEqualTo(Double.POSITIVE_INFINITY);
            post("restart", "{\"speed\":\"0.5\"}");
            assertThat(server.run().plan().speed()).isEqualTo(0.5);
        }

        @Test
        void namesTheFieldOfEveryErrorAtOnce() throws IOException {
            LiveRun before = server.run();
            Response response = post(
                    "restart",
                    "{\"seed\":\"x\",\"speed\":\"fast\",\"arguments\":{\"couriers\":\"99\",\"couriars\":\"2\"}}");
            assertThat(response.status()).isEqualTo(422);
            assertThat(response.body())
                    .contains("\"where\":\"seed\"", "\"where\":\"speed\"")
                    .contains("\"where\":\"arguments.couriers\"", "\"where\":\"arguments.couriars\"");
            assertThat(server.run()).isSameAs(before);
        }

        @Test
        void keepsWhatIsLeftOut() throws IOException {
            post("restart", "{\"arguments\":{\"couriers\":\"3\"},\"seed\":\"11\"}");
            post("restart", "{}");
            assertThat(server.run().plan().seed()).isEqualTo(11);
            assertThat(server.run().plan().robots()).hasSize(3);
        }

        @ParameterizedTest
        @CsvSource(
                delimiter = '|',
                value = {
                    "{\"arguments\":{\"couriers\":\"99\"}} | couriers",
                    "{\"arguments\":{\"couriers\":\"many\"}} | many",
                    "{\"arguments\":{\"couriars\":\"2\"}} | couriers",
                    "{\"configuration\":\"trio\"} | trio",
                    "{\"seed\":\"abc\"} | abc",
                    "{\"seed\":\"1e3\"} | 1e3",
                    "{\"speed\":\"0\"} | speed",
                })
        void changesNothingWhenItIsInvalid(String wish, String culprit) throws IOException {
            LiveRun before = server.run();
            for (String command : List.of("check", "restart")) {
                Response response = post(command, wish);
                assertThat(response.status()).isEqualTo(422);
                assertThat(response.body()).contains("problems", culprit);
            }
            assertThat(server.run()).isSameAs(before);
            assertThat(before.result().toCompletableFuture()).isNotDone();
        }

        @Test
        void runsAnotherScenarioAsThatOneSays() throws IOException {
            assertThat(post("check", "{\"scenario\":\"teleop\"}").body()).contains("\"seed\":\"");
            post("restart", "{\"seed\":\"11\",\"arguments\":{\"couriers\":\"3\"}}");
            Response response = post("restart", "{\"scenario\":\"hunt-and-prey\",\"configuration\":\"virtual\"}");
            assertThat(response.status()).as(response.body()).isEqualTo(200);
            assertThat(response.body()).contains("\"scenario\":\"hunt-and-prey\"", "\"configuration\":\"virtual\"");
            assertThat(server.run().plan().seed()).isEqualTo(42);
            assertThat(server.run().plan().robots()).hasSize(3);
        }

        @Test
        void putsAgentsOnAnotherHostAndBack() throws IOException {
            post("restart", "{\"mas\":\"other\"}");
            assertThat(get("/api/run").body()).contains("\"mas\":\"\"");
            Response refused = post("check", "{\"mas\":\"other\"}");
            assertThat(refused.status()).isEqualTo(422);
            assertThat(refused.body()).contains("'other'");
            assertThat(post("restart", "{\"mas\":\"plain\"}").body()).contains("\"mas\":\"plain\"");
            assertThat(post("restart", "{}").body()).contains("\"mas\":\"plain\"");
            assertThat(post("restart", "{\"mas\":\"\"}").body()).contains("\"mas\":\"\"");
        }

        @ParameterizedTest
        @ValueSource(strings = {"errand.yaml", "/etc/passwd", "../errand.yaml", "", "no-such"})
        void runsNoFileThatWasNotNamedWhenItBegan(String scenario) throws IOException {
            LiveRun before = server.run();
            for (String command : List.of("check", "restart")) {
                Response response = post(command, Json.write(java.util.Map.of("scenario", scenario)));
                assertThat(response.status()).isEqualTo(404);
                assertThat(response.body()).contains("There is no scenario");
            }
            assertThat(get("/api/scenarios/picture?scenario="
                                    + java.net.URLEncoder.encode(scenario, java.nio.charset.StandardCharsets.UTF_8))
                            .status())
                    .isEqualTo(404);
            assertThat(server.run()).isSameAs(before);
        }

        @Test
        void canBeTriedOutWithoutDoingIt() throws IOException {
            LiveRun before = server.run();
            assertThat(post("check", "{\"configuration\":\"pair\"}").body())
                    .contains("\"name\":\"couriers\"", "\"value\":\"2\"");
            assertThat(server.run()).isSameAs(before);
        }
    }

    @Nested
    class BadInput {
        @ParameterizedTest
        @ValueSource(
                strings = {
                    "",
                    "{",
                    "[]",
                    "null",
                    "7",
                    "\"x\"",
                    "{\"robot\":\"courier-1\"}",
                    "{\"robot\":7}",
                    "{\"robot\":\"courier-1\",\"x\":1,\"y\":1,\"heading\":null}",
                    "{\"robot\":\"courier-1\",\"x\":\"a\",\"y\":1,\"heading\":0}",
                    "{\"robot\":\"courier-1\",\"x\":1e400,\"y\":1,\"heading\":0}",
                    "{\"robot\":\"courier-1\",\"x\":NaN,\"y\":1,\"heading\":0}",
                    "{\"robot\":\"courier-1\",\"x\":1,\"y\":1,\"heading\":0,\"z\":0}",
                    "{\"robot\":\"courier-1\",\"x\":1,\"y\":1,\"heading\":0} x",
                    "[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[",
                    "{\"robot\":\"courier-1\",\"x\":1e7,\"y\":1,\"heading\":0}"
                })
        @Tag(UNCHANGED)
        void isRefusedWithASentence(String body) throws IOException {
            Response response = post("place", body);
            assertThat(response.status()).isEqualTo(400);
            assertThat(response.body()).startsWith("{\"message\":\"").doesNotContain("rsal.server", "jackson");
        }

        @Test
        void mayNotBeLarge() throws IOException {
            assertThat(post("place", "x".repeat(Http.MAX_MESSAGE + 1)).status()).isEqualTo(413);
            String chunked =
                    "POST /api/run/place HTTP/1.1\r\n%s\r\n%s\r\nTransfer-Encoding: chunked\r\nConnection: close\r\n\r\n"
                                    .formatted(host, WITH_TOKEN)
                            + ("1000\r\n" + " ".repeat(0x1000) + "\r\n").repeat(5)
                            + "0\r\n\r\n";
            assertThat(RawHttp.send(port, chunked.getBytes(java.nio.charset.StandardCharsets.ISO_8859_1))
                            .status())
                    .isEqualTo(413);
            assertThat(RawHttp.get(port, "/", host, "X: " + "x".repeat(100_000)).status())
                    .isEqualTo(431);
        }

        @Test
        void ofAnyKindLeavesTheServerWell() throws IOException {
            long seed = 20_260_101;
            var random = new Random(seed);
            String[] commands = {
                "speed",
                "place",
                "goal",
                "drive",
                "release",
                "behavior",
                "check",
                "restart",
                "add",
                "add-robot",
                "new-robot",
                "remove"
            };
            for (int i = 0; i < 300; i++) {
                String body = Fuzz.json(random);
                String command = commands[random.nextInt(commands.length)];
                Response response = post(command, body);
                assertThat(response.status())
                        .as("seed %d, round %d: %s %s", seed, i, command, body)
                        .isIn(200, 400, 409, 422);
            }
            for (int i = 0; i < 100; i++) {
                byte[] noise = new byte[random.nextInt(200)];
                random.nextBytes(noise);
                Response response = RawHttp.send(port, Fuzz.request(noise, random));
                assertThat(response.status())
                        .as("seed %d, round %d", seed, i)
                        .isIn(0, 200, 400, 404, 414, 421, 431, 505);
            }
            assertThat(get("/api/run").status()).isEqualTo(200);
        }
    }

    @Test
    void leavesNoThreadBehind() throws Exception {
        await(server.run(), s -> !s.robots().isEmpty());
        Response response = RawHttp.upgrade(port, host);
        assertThat(response.status()).isEqualTo(101);
        server.close();
        for (Thread thread : Thread.getAllStackTraces().keySet()) {
            if (thread.getName().startsWith("server") || thread.getName().startsWith("run-")) {
                assertThat(thread.join(Duration.ofSeconds(1)))
                        .as(thread.getName())
                        .isTrue();
            }
        }
        assertThatThrownBy(() -> get("/")).isInstanceOf(ConnectException.class);
        server.close(); // twice does nothing
    }
}
