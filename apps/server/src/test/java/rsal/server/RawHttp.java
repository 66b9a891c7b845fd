package rsal.server;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.net.InetAddress;
import java.net.Socket;
import java.net.SocketException;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.stream.Collectors;

/// HTTP as bytes, since clients of libraries are too polite to lie about their `Host`.
final class RawHttp {
    private RawHttp() {}

    /// @param text status line, headers and body
    record Response(String text) {
        int status() {
            return text.isEmpty() ? 0 : Integer.parseInt(text.substring(9, 12));
        }

        String body() {
            return text.substring(text.indexOf("\r\n\r\n") + 4);
        }
    }

    static Response get(int port, String path, String... headers) throws IOException {
        return send(port, "GET", path, "", List.of(headers));
    }

    static Response post(int port, String path, String body, String... headers) throws IOException {
        return send(port, "POST", path, body, List.of(headers));
    }

    static Response put(int port, String path, String body, String... headers) throws IOException {
        return send(port, "PUT", path, body, List.of(headers));
    }

    static Response delete(int port, String path, String... headers) throws IOException {
        return send(port, "DELETE", path, "", List.of(headers));
    }

    /// Asks for a WebSocket as a browser does; 101 is a yes.
    static Response upgrade(int port, String... headers) throws IOException {
        return upgradeAt(port, "/api/live", headers);
    }

    static Response upgradeAt(int port, String path, String... headers) throws IOException {
        return upgradeAndSend(port, path, new byte[0], headers);
    }

    /// Asks for a WebSocket and sends bytes there that need not be frames.
    static Response upgradeAndSend(int port, byte[] bytes, String... headers) throws IOException {
        return upgradeAndSend(port, "/api/live", bytes, headers);
    }

    private static Response upgradeAndSend(int port, String path, byte[] bytes, String... headers) throws IOException {
        var request = new ByteArrayOutputStream();
        request.writeBytes("""
                GET %s HTTP/1.1\r
                Upgrade: websocket\r
                Connection: Upgrade\r
                Sec-WebSocket-Version: 13\r
                Sec-WebSocket-Key: dGhlIHNhbXBsZSBub25jZQ==\r
                %s\r
                """.formatted(path, lines(List.of(headers))).getBytes(StandardCharsets.ISO_8859_1));
        request.writeBytes(bytes);
        return headOf(port, request.toByteArray());
    }

    private static Response send(int port, String method, String path, String body, List<String> headers)
            throws IOException {
        byte[] content = body.getBytes(StandardCharsets.UTF_8);
        var request = new ByteArrayOutputStream();
        request.writeBytes("%s %s HTTP/1.1\r\nConnection: close\r\nContent-Length: %d\r\n%s\r\n"
                .formatted(method, path, content.length, lines(headers))
                .getBytes(StandardCharsets.ISO_8859_1));
        request.writeBytes(content);
        return send(port, request.toByteArray());
    }

    private static String lines(List<String> headers) {
        return headers.stream().map(header -> header + "\r\n").collect(Collectors.joining());
    }

    /// Sends bytes and reads until the server closes.
    static Response send(int port, byte[] request) throws IOException {
        return exchange(port, request, false);
    }

    /// Sends bytes and reads until the answer's head is there; then closes.
    private static Response headOf(int port, byte[] request) throws IOException {
        return exchange(port, request, true);
    }

    private static Response exchange(int port, byte[] request, boolean onlyHead) throws IOException {
        try (var socket = new Socket(InetAddress.ofLiteral("127.0.0.1"), port)) {
            socket.setSoTimeout(60_000); // ten seconds are too few beside other work
            var answer = new ByteArrayOutputStream();
            try {
                socket.getOutputStream().write(request);
                int read;
                while (!(onlyHead
                                && answer.toString(StandardCharsets.ISO_8859_1).endsWith("\r\n\r\n"))
                        && (read = socket.getInputStream().read()) >= 0) {
                    answer.write(read);
                }
            } catch (SocketException e) {
                // it closed before it had read all; what it said until then counts
            }
            return new Response(answer.toString(StandardCharsets.UTF_8));
        }
    }
}
