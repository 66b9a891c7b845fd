package rsal.server;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.catchThrowable;
import static rsal.server.Errand.TOKEN;

import java.io.ByteArrayInputStream;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.ServerSocket;
import java.net.URI;
import java.net.http.HttpClient;
import java.net.http.HttpRequest;
import java.net.http.HttpResponse;
import java.net.http.WebSocket;
import java.nio.file.Files;
import java.nio.file.Path;
import java.security.KeyStore;
import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.CompletionException;
import javax.net.ssl.SSLContext;
import javax.net.ssl.TrustManagerFactory;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import rsal.engine.LiveRun;
import rsal.server.access.Listening;
import rsal.server.access.Role;

/// What other machines reach: by TLS, and with a token of the right role only.
class ListeningTest {
    private static final String WATCHER = "watcher-0123456789";
    private static final String OPERATOR = "operator-0123456789";
    private static final String ADMIN = "admin-0123456789ab";
    private static final String PROXY = "https://robots.example.org";

    private static KeyStore identity;

    @TempDir
    private Path directory;

    private RunServer server;
    private HttpClient client;
    private String address;

    /// One for all of them: making it takes a process.
    @BeforeAll
    static void identify(@TempDir Path folder) throws Exception {
        identity = identity(folder);
    }

    @BeforeEach
    void listen() throws Exception {
        int port;
        try (var free = new ServerSocket(0, 1, InetAddress.getLoopbackAddress())) {
            port = free.getLocalPort();
        }
        Files.writeString(directory.resolve("index.html"), "<!doctype html>the page");
        var options = new RunServer.Options(
                0,
                TOKEN,
                directory,
                List.of(),
                _ -> {},
                LiveRun::start,
                Optional::empty,
                Optional.empty(),
                Optional.of(new Listening(
                        new InetSocketAddress(InetAddress.getLoopbackAddress(), port),
                        identity,
                        Map.of(WATCHER, Role.WATCH, OPERATOR, Role.OPERATE, ADMIN, Role.ADMIN),
                        List.of(PROXY))));
        server = RunServer.start(Errand.plan(), options);
        var trust = TrustManagerFactory.getInstance(TrustManagerFactory.getDefaultAlgorithm());
        trust.init(identity);
        var tls = SSLContext.getInstance("TLS");
        tls.init(null, trust.getTrustManagers(), null);
        client = HttpClient.newBuilder().sslContext(tls).build();
        address = "https://localhost:" + port;
    }

    @AfterEach
    void end() {
        client.close();
        server.close();
    }

    /// Self-signed, for localhost, without a password.
    private static KeyStore identity(Path folder) throws Exception {
        Path file = folder.resolve("store.p12");
        int code = new ProcessBuilder(
                        Path.of(System.getProperty("java.home"), "bin", "keytool")
                                .toString(),
                        "-genkeypair",
                        "-alias",
                        "rsal",
                        "-keyalg",
                        "EC",
                        "-dname",
                        "CN=localhost",
                        "-ext",
                        "san=dns:localhost",
                        "-storetype",
                        "PKCS12",
                        "-keystore",
                        file.toString(),
                        "-storepass",
                        "secret")
                .start()
                .waitFor();
        assertThat(code).isZero();
        KeyStore made = KeyStore.getInstance("PKCS12");
        made.load(new ByteArrayInputStream(Files.readAllBytes(file)), "secret".toCharArray());
        KeyStore bare = KeyStore.getInstance("PKCS12");
        bare.load(null, null);
        bare.setKeyEntry(
                "rsal", made.getKey("rsal", "secret".toCharArray()), new char[0], made.getCertificateChain("rsal"));
        bare.setCertificateEntry("trusted", made.getCertificate("rsal"));
        return bare;
    }

    private HttpRequest.Builder at(String path, String token) {
        HttpRequest.Builder request =
                HttpRequest.newBuilder(URI.create(address + path)).timeout(Duration.ofSeconds(20));
        return token == null ? request : request.header("Authorization", "Bearer " + token);
    }

    private HttpResponse<String> send(HttpRequest.Builder request) throws Exception {
        return client.send(request.build(), HttpResponse.BodyHandlers.ofString());
    }

    private int get(String path, String token) throws Exception {
        return send(at(path, token)).statusCode();
    }

    private int post(String path, String token, String body) throws Exception {
        return send(at(path, token).POST(HttpRequest.BodyPublishers.ofString(body)))
                .statusCode();
    }

    @ParameterizedTest
    @ValueSource(
            strings = {
                "/api/run",
                "/metrics",
                "/readyz",
                "/api/agent?name=x",
                "/beside/1/api/run",
                "/api",
                "//api/run",
                "/x/../api/run",
                "/%61pi/run",
                "/beside/1/%61pi/run",
                "/x.js/../api/run",
                "/assets/../api/run",
                "/api/run.js",
                "/API/run",
                "/api;x/run"
            })
    void nothingIsReportedWithoutAToken(String path) throws Exception {
        assertThat(get(path, null)).isIn(400, 401, 404);
        assertThat(get(path, "wrong-0123456789abc")).isIn(400, 401, 404);
    }

    @Test
    void thePagesOwnFilesAndHealthAreForAll() throws Exception {
        assertThat(send(at("/", null)).body()).contains("the page");
        assertThat(get("/healthz", null)).isEqualTo(200);
    }

    @ParameterizedTest
    @CsvSource(textBlock = """
            watcher-0123456789,  200, 403, 403
            operator-0123456789, 200, 200, 403
            admin-0123456789ab,  200, 200, 400
            """)
    void aTokenMayWhatItsRoleMay(String token, int look, int pause, int save) throws Exception {
        assertThat(get("/api/run", token)).isEqualTo(look);
        assertThat(get("/metrics", token)).isEqualTo(look);
        assertThat(post("/api/run/pause", token, "{}")).isEqualTo(pause);
        assertThat(post("/api/run/estop", token, "{}")).isEqualTo(pause);
        assertThat(send(at("/api/scenarios/text", token).PUT(HttpRequest.BodyPublishers.ofString("nonsense")))
                        .statusCode())
                .isEqualTo(save);
        assertThat(post("/api/run/restart", token, "{\"text\": \"rsal: 1\"}")).isEqualTo(save == 400 ? 422 : save);
    }

    @Test
    void theOwnersTokenMayAll() throws Exception {
        assertThat(post("/api/run/pause", TOKEN, "{}")).isEqualTo(200);
    }

    @Test
    void aBrowserWatchesByACookieAndDoesNothingByIt() throws Exception {
        HttpResponse<String> entered = send(at("/api/session", WATCHER).POST(HttpRequest.BodyPublishers.noBody()));
        assertThat(entered.statusCode()).isEqualTo(204);
        String cookie = entered.headers().firstValue("Set-Cookie").orElseThrow();
        assertThat(cookie).contains("Secure").contains("HttpOnly").contains("SameSite=Strict");
        String name = cookie.substring(0, cookie.indexOf(';'));

        assertThat(send(at("/api/run", null).header("Cookie", "a=b; " + name)).statusCode())
                .isEqualTo(200);
        String admin = send(at("/api/session", ADMIN).POST(HttpRequest.BodyPublishers.noBody()))
                .headers()
                .firstValue("Set-Cookie")
                .orElseThrow()
                .replaceFirst(";.*", "");
        assertThat(send(at("/api/run/pause", null)
                                .header("Cookie", admin)
                                .POST(HttpRequest.BodyPublishers.ofString("{}")))
                        .statusCode())
                .isEqualTo(401);
        assertThat(send(at("/api/session", null).POST(HttpRequest.BodyPublishers.noBody()))
                        .statusCode())
                .isEqualTo(401);
        socket(name).abort();
    }

    private WebSocket socket(String cookie) {
        var builder = client.newWebSocketBuilder();
        if (cookie != null) {
            builder.header("Cookie", cookie);
        }
        return builder.buildAsync(
                        URI.create(address.replace("https", "wss") + "/api/live"), new WebSocket.Listener() {})
                .join();
    }

    @Test
    void nobodyWatchesLiveWithoutAToken() {
        assertThat(catchThrowable(() -> socket(null))).isInstanceOf(CompletionException.class);
    }

    @Test
    void pagesOfOthersGetNoAnswer() throws Exception {
        assertThat(send(at("/api/run", ADMIN).header("Origin", "https://evil.example"))
                        .statusCode())
                .isEqualTo(403);
        assertThat(send(at("/api/run", ADMIN).header("Origin", "null")).statusCode())
                .isEqualTo(403);
        assertThat(send(at("/api/run", ADMIN).header("Sec-Fetch-Site", "cross-site"))
                        .statusCode())
                .isEqualTo(403);
        assertThat(send(at("/api/run", ADMIN).header("Origin", address)).statusCode())
                .isEqualTo(200);
        assertThat(send(at("/api/run", ADMIN).header("Origin", PROXY)).statusCode())
                .isEqualTo(200);
    }

    @Test
    void itSpeaksNothingButTls() {
        assertThat(catchThrowable(() -> client.send(
                        HttpRequest.newBuilder(URI.create(address.replace("https", "http") + "/healthz"))
                                .timeout(Duration.ofSeconds(5))
                                .build(),
                        HttpResponse.BodyHandlers.ofString())))
                .isNotNull();
    }

    /// All else stays as it is without listening.
    @Test
    void onThisMachineAllMayWatchAsBefore() throws Exception {
        int port = server.url().getPort();
        assertThat(RawHttp.get(port, "/api/run", "Host: 127.0.0.1:" + port).status())
                .isEqualTo(200);
        assertThat(RawHttp.post(port, "/api/run/pause", "{}", "Host: 127.0.0.1:" + port)
                        .status())
                .isEqualTo(401);
    }
}
