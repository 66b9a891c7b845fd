package rsal.server.http;

import static org.assertj.core.api.Assertions.assertThat;

import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.time.Duration;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import rsal.server.Errand;
import rsal.server.RunServer;

class WarmUpTest {
    @Test
    void isAnsweredAsAnybodyIs(@TempDir Path directory) throws Exception {
        try (RunServer server = Errand.serve(directory, 0)) {
            var where = new InetSocketAddress(
                    InetAddress.ofLiteral("127.0.0.1"), server.url().getPort());
            for (String path : PageServer.FIRST) {
                try (var socket = new Socket()) {
                    var answer = new String(WarmUp.ask(where, path, socket), StandardCharsets.ISO_8859_1);
                    assertThat(answer).as(path).startsWith("HTTP/1.1 200 ");
                }
            }
        }
    }

    @Test
    void isOverAtOnceWhenItsServerEnds() throws Exception {
        try (var mute = new ServerSocket(0, 1, InetAddress.ofLiteral("127.0.0.1"))) {
            var rehearsal = WarmUp.begin((InetSocketAddress) mute.getLocalSocketAddress(), PageServer.FIRST);
            try (Socket asked = mute.accept()) {
                assertThat(asked.getInputStream().read()).isEqualTo('G');
                rehearsal.close();
                assertThat(Thread.getAllStackTraces().keySet())
                        .filteredOn(thread -> thread.getName().equals("server-rehearsal"))
                        .allSatisfy(thread ->
                                assertThat(thread.join(Duration.ofSeconds(3))).isTrue());
            }
        }
    }
}
