package rsal.server.http;

import org.eclipse.jetty.ee10.websocket.server.JettyWebSocketServerContainer;

/// Where viewers come in.
public interface ViewerEndpoint extends AutoCloseable {
    void configure(JettyWebSocketServerContainer sockets);

    /// No viewer is offered anything any more. Their connections end with the server.
    @Override
    void close();
}
