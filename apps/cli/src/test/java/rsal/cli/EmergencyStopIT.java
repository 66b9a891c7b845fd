package rsal.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.BufferedReader;
import java.io.IOException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.Socket;
import java.net.URI;
import java.net.http.HttpClient;
import java.net.http.HttpRequest;
import java.net.http.HttpResponse.BodyHandlers;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;

/// A process that may open few files only, in which others take all connections that they can get.
@Timeout(120)
class EmergencyStopIT {
    private static final int FILES = 140; // of the process, its own jars among them
    private static final int OTHERS = 150;

    @TempDir
    private Path folder;

    @Test
    void isConfirmedWhereFilesAreFewAndOthersHoldConnections() throws Exception {
        var command = new ArrayList<>(List.of("bash", "-c", "ulimit -n %d; exec \"$@\"".formatted(FILES), "bash"));
        command.addAll(new Rsal(folder).withPage().command("run", "patrol", "--port", "0", "--for", "600"));
        Process run = new ProcessBuilder(command).directory(folder.toFile()).start();
        var held = new ArrayList<Socket>();
        try (BufferedReader err = run.errorReader();
                HttpClient http = HttpClient.newHttpClient()) {
            URI page = Rsal.page(err);
            for (int i = 0; i < OTHERS; i++) {
                hold(page.getPort(), held);
            }
            for (int i = 0; i < 20; i++) {
                var stop = HttpRequest.newBuilder(page.resolve("/api/run/estop"))
                        .timeout(Duration.ofSeconds(20))
                        .header("Authorization", "Bearer " + page.getFragment().substring("token=".length()))
                        .POST(HttpRequest.BodyPublishers.ofString("{}"))
                        .build();
                assertThat(http.send(stop, BodyHandlers.ofString()).statusCode())
                        .isEqualTo(200);
            }
        } finally {
            for (Socket socket : held) {
                socket.close();
            }
            run.destroy();
            assertThat(run.waitFor(30, TimeUnit.SECONDS)).as("ends").isTrue();
        }
    }

    private static void hold(int port, List<Socket> held) {
        try {
            var socket = new Socket();
            held.add(socket);
            socket.connect(new InetSocketAddress(InetAddress.ofLiteral("127.0.0.1"), port), 1000);
        } catch (IOException _) {
            // refused: it takes no more
        }
    }
}
