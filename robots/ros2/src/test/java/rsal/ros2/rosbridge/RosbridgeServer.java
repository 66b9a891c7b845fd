package rsal.ros2.rosbridge;

import java.net.URI;
import java.nio.ByteBuffer;
import java.util.concurrent.Executor;
import org.eclipse.jetty.server.Server;
import org.eclipse.jetty.server.ServerConnector;
import org.eclipse.jetty.util.component.LifeCycle;
import org.eclipse.jetty.websocket.api.Callback;
import org.eclipse.jetty.websocket.api.Session;
import org.eclipse.jetty.websocket.server.WebSocketUpgradeHandler;
import org.jspecify.annotations.Nullable;

/// [FakeRosbridge] behind a WebSocket of Jetty.
public final class RosbridgeServer implements AutoCloseable {
    private final FakeRosbridge rosbridge;
    private final Executor thread;
    private final Server jetty = new Server();
    private final ServerConnector connector = new ServerConnector(jetty);

    /// @param port 0 for any that is free
    /// @param thread of the server in memory
    public RosbridgeServer(FakeRosbridge rosbridge, int port, Executor thread) throws Exception {
        this.rosbridge = rosbridge;
        this.thread = thread;
        connector.setHost("127.0.0.1");
        connector.setPort(port);
        jetty.addConnector(connector);
        jetty.setHandler(WebSocketUpgradeHandler.from(jetty, sockets -> {
            sockets.setMaxTextMessageSize(1 << 24);
            sockets.addMapping("/", (_, _, _) -> new Socket());
        }));
        jetty.start();
    }

    public URI address() {
        return URI.create("ws://127.0.0.1:%d".formatted(connector.getLocalPort()));
    }

    @Override
    public void close() {
        LifeCycle.stop(jetty);
    }

    /// Of one client.
    @SuppressWarnings("exports") // public for Jetty alone
    public final class Socket extends Session.Listener.AbstractAutoDemanding {
        private FakeRosbridge.@Nullable Client client; // of the server's thread

        @Override
        public void onWebSocketOpen(Session session) {
            super.onWebSocketOpen(session);
            thread.execute(() -> client = rosbridge.connect(
                    text -> session.sendText(text, Callback.NOOP),
                    bytes -> session.sendBinary(ByteBuffer.wrap(bytes), Callback.NOOP),
                    why -> session.close(1001, why, Callback.NOOP)));
        }

        @Override
        public void onWebSocketText(String message) {
            thread.execute(() -> client.receive(message));
        }

        @Override
        public void onWebSocketClose(int status, String reason, Callback callback) {
            thread.execute(() -> client.close());
            callback.succeed();
        }
    }
}
