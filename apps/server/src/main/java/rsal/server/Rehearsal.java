package rsal.server;

import java.io.IOException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.Socket;
import java.nio.charset.StandardCharsets;
import java.util.List;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/// Asks a server that has just begun what a browser asks first. Java loads what answers when it is needed first, which
/// takes up to a second; so the first person who opens the page needn't wait for it. It also has what the server needs
/// among what the launcher keeps for fast starts.
final class Rehearsal {
    private static final int PATIENCE_MILLIS = 5_000;
    private static final Logger LOG = LoggerFactory.getLogger(Rehearsal.class);

    private Rehearsal() {}

    /// Returns at once. Whatever goes wrong is nothing but a slower start.
    ///
    /// @param paths what is asked for, one after the other
    static void begin(InetSocketAddress server, List<String> paths) {
        Thread.ofPlatform().daemon().name("server-rehearsal").start(() -> {
            try {
                for (String path : paths) {
                    ask(server, path);
                }
            } catch (IOException e) {
                LOG.debug("A server did not answer itself.", e); // it may have ended meanwhile
            }
        });
    }

    /// @return the answer, with its head
    static byte[] ask(InetSocketAddress server, String path) throws IOException {
        InetAddress address = server.getAddress();
        try (var socket = new Socket()) {
            socket.setSoTimeout(PATIENCE_MILLIS);
            socket.connect(server, PATIENCE_MILLIS);
            String question = "GET %s HTTP/1.1\r\nHost: %s:%d\r\nAccept-Encoding: gzip\r\nConnection: close\r\n\r\n"
                    .formatted(path, address.getHostAddress(), server.getPort());
            socket.getOutputStream().write(question.getBytes(StandardCharsets.US_ASCII));
            return socket.getInputStream().readAllBytes();
        }
    }
}
