package rsal.server.http;

import java.io.IOException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.Socket;
import java.nio.charset.StandardCharsets;
import java.util.List;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/// Asks a server that has just begun what a browser asks first. Java loads what answers when it is needed first, which
/// takes up to a second; so the first person who opens the page needn't wait for it. It also has what the server needs
/// among what the launcher keeps for fast starts.
final class WarmUp implements AutoCloseable {
    private static final int PATIENCE_MILLIS = 5_000;
    private static final Logger LOG = LoggerFactory.getLogger(WarmUp.class);

    private final InetSocketAddress server;
    private boolean over;
    private @Nullable Socket asking;

    private WarmUp(InetSocketAddress server) {
        this.server = server;
    }

    /// Returns at once. Whatever goes wrong is nothing but a slower start.
    ///
    /// @param paths what is asked for, one after the other
    static WarmUp begin(InetSocketAddress server, List<String> paths) {
        var rehearsal = new WarmUp(server);
        Thread.ofPlatform().daemon().name("server-rehearsal").start(() -> rehearsal.ask(paths));
        return rehearsal;
    }

    private void ask(List<String> paths) {
        try {
            for (String path : paths) {
                try (var socket = new Socket()) {
                    if (isOver(socket)) {
                        return;
                    }
                    ask(server, path, socket);
                }
            }
        } catch (IOException e) {
            LOG.debug("A server did not answer itself.", e); // it may have ended meanwhile
        }
    }

    private synchronized boolean isOver(Socket next) {
        asking = next;
        return over;
    }

    /// @param socket not connected yet
    /// @return the answer, with its head
    static byte[] ask(InetSocketAddress server, String path, Socket socket) throws IOException {
        InetAddress address = server.getAddress();
        socket.setSoTimeout(PATIENCE_MILLIS);
        socket.connect(server, PATIENCE_MILLIS);
        String question = "GET %s HTTP/1.1\r\nHost: %s:%d\r\nAccept-Encoding: gzip\r\nConnection: close\r\n\r\n"
                .formatted(path, address.getHostAddress(), server.getPort());
        socket.getOutputStream().write(question.getBytes(StandardCharsets.US_ASCII));
        return socket.getInputStream().readAllBytes();
    }

    /// Asks no more: a server that ends need not wait until nobody answers any longer.
    @Override
    public synchronized void close() {
        over = true;
        if (asking != null) {
            try {
                asking.close();
            } catch (IOException e) {
                LOG.debug("A question was not taken back.", e);
            }
        }
    }
}
