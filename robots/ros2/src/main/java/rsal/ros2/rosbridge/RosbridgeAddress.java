package rsal.ros2.rosbridge;

import java.net.URI;
import java.net.URISyntaxException;

/// Addresses of servers: `ws://robot.local:9090`.
public final class RosbridgeAddress {
    private static final int PORT = 9090; // where rosbridge listens unless it is told otherwise

    private RosbridgeAddress() {}

    /// @param text with port 9090 for `ws://` where it has none
    /// @throws IllegalArgumentException when it is none; its message says what to write
    public static URI parse(String text) {
        try {
            var uri = new URI(text.strip());
            boolean isPlain = "ws".equals(uri.getScheme());
            if ((!isPlain && !"wss".equals(uri.getScheme()))
                    || uri.getHost() == null
                    || uri.getUserInfo() != null
                    || uri.getFragment() != null) {
                throw invalid(text);
            }
            return isPlain && uri.getPort() < 0
                    ? new URI("ws", null, uri.getHost(), PORT, uri.getPath(), uri.getQuery(), null)
                    : uri;
        } catch (URISyntaxException e) {
            throw (IllegalArgumentException) invalid(text).initCause(e);
        }
    }

    private static IllegalArgumentException invalid(String text) {
        return new IllegalArgumentException(
                "'rosbridge' can't be '%s'. Write the server's address, such as ws://robot.local:%d."
                        .formatted(text, PORT));
    }
}
