package rsal.server;

import static org.assertj.core.api.Assertions.assertThat;

import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class RehearsalTest {
    @Test
    void isAnsweredAsAnybodyIs(@TempDir Path directory) throws Exception {
        try (RunServer server = Errand.serve(directory, 0)) {
            var where = new InetSocketAddress(
                    InetAddress.ofLiteral("127.0.0.1"), server.url().getPort());
            for (String path : PageServer.FIRST) {
                var answer = new String(Rehearsal.ask(where, path), StandardCharsets.ISO_8859_1);
                assertThat(answer).as(path).startsWith("HTTP/1.1 200 ");
            }
        }
    }
}
