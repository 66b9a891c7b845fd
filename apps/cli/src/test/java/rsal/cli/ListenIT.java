package rsal.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.BufferedReader;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.net.URI;
import java.net.http.HttpClient;
import java.net.http.HttpRequest;
import java.net.http.HttpResponse;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFilePermissions;
import java.security.KeyStore;
import java.security.cert.CertificateFactory;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import javax.net.ssl.SSLContext;
import javax.net.ssl.TrustManagerFactory;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.CleanupMode;
import org.junit.jupiter.api.io.TempDir;

/// `rsal certificate`, and runs that other machines reach.
class ListenIT {
    private static final String WATCHER = "watcher-0123456789";

    @TempDir(factory = WarmProcess.Folder.class, cleanup = CleanupMode.NEVER)
    private Path folder;

    private Rsal rsal;

    @BeforeEach
    void withAPage() throws Exception {
        rsal = new Rsal(folder);
    }

    private List<String> listening(int port, String... more) {
        var line = new ArrayList<>(List.of(
                "run",
                "--port",
                "0",
                "--for",
                "1000",
                "--listen",
                "127.0.0.1:" + port,
                "--certificate",
                "certificate.pem",
                "--key",
                "key.pem"));
        line.addAll(List.of(more));
        return line;
    }

    @Test
    void aRunIsReachedByTlsWithTheCertificateThatWasMade() throws Exception {
        Ended made = rsal.run("certificate", "localhost", "127.0.0.1");
        assertThat(made.code()).as(made.err()).isZero();
        assertThat(made.out()).contains("SHA-256 fingerprint: ").contains("--listen 0.0.0.0");
        assertThat(Files.getPosixFilePermissions(folder.resolve("key.pem")))
                .isEqualTo(PosixFilePermissions.fromString("rw-------"));
        assertThat(rsal.run("certificate", "localhost").err()).contains("is there already");
        Files.writeString(folder.resolve("tokens"), "# the wall\nwatch %s\n".formatted(WATCHER));
        int port;
        try (var free = new ServerSocket(0, 1, InetAddress.getLoopbackAddress())) {
            port = free.getLocalPort();
        }

        Process run = rsal.withPage()
                .inEnvironment(
                        Map.of("RSAL_TOKEN_FILE", folder.resolve("tokens").toString()))
                .start(listening(port).toArray(String[]::new));
        try (BufferedReader reported = run.errorReader()) {
            String line = reported.readLine();
            while (line != null && !line.startsWith("From other machines:")) {
                line = reported.readLine();
            }
            assertThat(line).startsWith("From other machines: https://127.0.0.1:%d/#token=".formatted(port));
            String address = "https://127.0.0.1:" + port;
            try (HttpClient client = client()) {
                assertThat(status(client, address + "/api/run", "none-0123456789abc"))
                        .isEqualTo(401);
                assertThat(status(client, address + "/api/run", WATCHER)).isEqualTo(200);
                assertThat(status(client, address + "/api/run", line.substring(line.indexOf('=') + 1)))
                        .isEqualTo(200);
            }

            Ended second = rsal.withPage().run(listening(port).toArray(String[]::new));
            assertThat(second.code()).as(second.err()).isEqualTo(5);
            assertThat(second.err()).contains("%d".formatted(port)).doesNotContain("Something went wrong");
        } finally {
            run.destroy();
            run.waitFor();
        }
    }

    private HttpClient client() throws Exception {
        KeyStore trusted = KeyStore.getInstance("PKCS12");
        trusted.load(null, null);
        try (var in = Files.newInputStream(folder.resolve("certificate.pem"))) {
            trusted.setCertificateEntry(
                    "rsal", CertificateFactory.getInstance("X.509").generateCertificate(in));
        }
        var trust = TrustManagerFactory.getInstance(TrustManagerFactory.getDefaultAlgorithm());
        trust.init(trusted);
        var tls = SSLContext.getInstance("TLS");
        tls.init(null, trust.getTrustManagers(), null);
        return HttpClient.newBuilder().sslContext(tls).build();
    }

    private static int status(HttpClient client, String address, String token) throws Exception {
        return client.send(
                        HttpRequest.newBuilder(URI.create(address))
                                .header("Authorization", "Bearer " + token)
                                .build(),
                        HttpResponse.BodyHandlers.discarding())
                .statusCode();
    }

    @Test
    void errorsAreReportedBeforeARunBegins() throws Exception {
        assertThat(rsal.run("certificate", "localhost").code()).isZero();
        Files.writeString(folder.resolve("other.pem"), "no key");
        Files.writeString(folder.resolve("tokens"), "watch short\n");

        refuses(2, "--listen needs --certificate", "run", "--listen", "127.0.0.1");
        refuses(2, "need --listen", "run", "--key", "key.pem");
        refuses(
                3,
                "This is not an unencrypted private key in PEM",
                "run",
                "--listen",
                "127.0.0.1",
                "--certificate",
                "certificate.pem",
                "--key",
                "other.pem");
        refuses(
                3,
                "This is not a certificate in PEM",
                "run",
                "--listen",
                "127.0.0.1",
                "--certificate",
                "other.pem",
                "--key",
                "key.pem");
        refuses(
                3,
                "at least 16 characters",
                listening(8443, "--token-file", "tokens").toArray(String[]::new));
        Files.writeString(folder.resolve("tokens"), "watch Secure;Path=/0123456789\n"); // no cookie could hold it
        refuses(
                3,
                "at least 16 characters",
                listening(8443, "--token-file", "tokens").toArray(String[]::new));
        refuses(2, "is not an origin", listening(8443, "--origin", "robots").toArray(String[]::new));
        refuses(
                2,
                "'x y' is not a port",
                "run",
                "--listen",
                "127.0.0.1:x y",
                "--certificate",
                "certificate.pem",
                "--key",
                "key.pem");
        Files.move(folder.resolve("key.pem"), folder.resolve("first.pem"));
        Files.delete(folder.resolve("certificate.pem"));
        assertThat(rsal.run("certificate", "localhost").code()).isZero();
        refuses(
                3,
                "This key is not that of the certificate",
                "run",
                "--listen",
                "127.0.0.1",
                "--certificate",
                "certificate.pem",
                "--key",
                "first.pem");
        refuses(2, "--headless", listening(8443, "--headless").toArray(String[]::new));
    }

    private void refuses(int code, String message, String... line) throws Exception {
        Ended ended = rsal.run(line);
        assertThat(ended.err()).contains(message).doesNotContain("Something went wrong");
        assertThat(ended.code()).isEqualTo(code);
    }
}
