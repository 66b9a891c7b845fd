package rsal.server.http;

import io.javalin.Javalin;
import io.javalin.compression.CompressionStrategy;
import io.javalin.config.JavalinConfig;
import io.javalin.config.RoutesConfig;
import io.javalin.http.Context;
import io.javalin.http.Header;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.URI;
import java.nio.channels.ServerSocketChannel;
import java.security.KeyStore;
import java.time.Duration;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import org.eclipse.jetty.ee10.websocket.server.config.JettyWebSocketServletContainerInitializer;
import org.eclipse.jetty.server.HttpConfiguration;
import org.eclipse.jetty.server.HttpConnectionFactory;
import org.eclipse.jetty.server.SecureRequestCustomizer;
import org.eclipse.jetty.server.Server;
import org.eclipse.jetty.server.ServerConnector;
import org.eclipse.jetty.server.SslConnectionFactory;
import org.eclipse.jetty.util.ssl.SslContextFactory;
import org.eclipse.jetty.util.thread.QueuedThreadPool;

/// HTTP and WebSocket on this machine's loopback address, and by TLS on another one where that is asked for.
public final class PageServer implements AutoCloseable {
    private static final String LOOPBACK = "127.0.0.1";
    private static final int SPARE_THREADS = 32; // beside one for each connection that asks: accepts, selects, sends
    private static final Duration IDLE = Duration.ofSeconds(30);
    private static final Duration STALLED = Duration.ofSeconds(5); // while a request or its answer is under way
    /// Name of the connector that other machines reach.
    static final String REMOTE = "remote";

    /// Answered once before anybody asks.
    static final List<String> FIRST = List.of("/", "/api/run");

    /// What other machines connect to.
    ///
    /// @param channel from [#open]
    /// @param identity as [Listening] has it
    public record TlsListener(ServerSocketChannel channel, KeyStore identity) {}

    private final Javalin http;
    private final ViewerEndpoint viewing;
    private final URI url;
    private final WarmUp rehearsal;

    /// @param door from [#open]
    /// @param gate that all requests pass
    /// @param viewing where viewers come in; this closes it
    /// @param routes what can be asked and told
    /// @param remote where else it can be reached; empty for nowhere
    public PageServer(
            ServerSocketChannel door,
            String token,
            AccessControl gate,
            ViewerEndpoint viewing,
            Consumer<RoutesConfig> routes,
            Optional<TlsListener> remote)
            throws IOException {
        this.viewing = viewing;
        url = URI.create("http://%s:%d/#token=%s".formatted(LOOPBACK, port(door), token));
        http = Javalin.create(config -> {
            configure(config, door, gate, remote);
            config.routes.post("/api/session", request -> enter(request, gate));
            routes.accept(config.routes);
        });
        try {
            http.start();
        } catch (RuntimeException e) {
            stop();
            throw e;
        }
        rehearsal = WarmUp.begin((InetSocketAddress) door.getLocalAddress(), FIRST);
    }

    /// @param port 0 for any that is free
    /// @throws java.net.BindException when the port is taken
    public static ServerSocketChannel open(int port) throws IOException {
        return open(new InetSocketAddress(InetAddress.ofLiteral(LOOPBACK), port));
    }

    /// @throws java.net.BindException when the port is taken, or the address is not of this machine
    public static ServerSocketChannel open(InetSocketAddress address) throws IOException {
        ServerSocketChannel door = ServerSocketChannel.open();
        try {
            return door.bind(address);
        } catch (IOException | RuntimeException e) {
            door.close();
            throw e;
        }
    }

    public static int port(ServerSocketChannel door) throws IOException {
        return ((InetSocketAddress) door.getLocalAddress()).getPort();
    }

    private static void enter(Context request, AccessControl gate) {
        String cookie = gate.session(request.header(Header.AUTHORIZATION));
        if (request.req().isSecure()) { // on the loopback address all may watch
            request.header(Header.SET_COOKIE, cookie);
        }
        request.status(204);
    }

    private void configure(
            JavalinConfig config, ServerSocketChannel door, AccessControl gate, Optional<TlsListener> remote) {
        var connections = new Connections();
        config.startup.showJavalinBanner = false;
        config.startup.showOldJavalinVersionWarning = false;
        config.startup.startupWatcherEnabled = false;
        config.http.asyncTimeout = 5_000;
        config.http.maxRequestSize = Http.MAX_MESSAGE;
        config.http.compressionStrategy = CompressionStrategy.NONE;
        var threads = new QueuedThreadPool(Connections.MOST_ASKING + SPARE_THREADS, 2);
        threads.setName("server");
        threads.setDaemon(true);
        config.jetty.threadPool = threads;
        config.jetty.addConnector((server, http) -> connector(server, http, door, connections));
        remote.ifPresent(
                each -> config.jetty.addConnector((server, http) -> encrypted(server, http, each, connections)));
        config.jetty.modifyServer(server -> server.setStopTimeout(0));
        config.jetty.modifyHttpConfiguration(http -> {
            http.setSendServerVersion(false);
            http.setIdleTimeout(STALLED.toMillis());
        });
        // not Javalin's own sockets, which give every viewer a session and a cookie
        config.jetty.modifyServletContextHandler(context -> {
            context.insertHandler(new RequestFilter(gate, connections));
            JettyWebSocketServletContainerInitializer.configure(context, (_, sockets) -> viewing.configure(sockets));
        });
    }

    private static ServerConnector connector(
            Server server, HttpConfiguration http, ServerSocketChannel door, Connections connections) {
        var connector = new ServerConnector(server, 1, 1, new HttpConnectionFactory(http));
        connector.addBean(connections);
        connector.setIdleTimeout(IDLE.toMillis());
        connector.setHost(LOOPBACK);
        return opened(connector, door);
    }

    private static ServerConnector opened(ServerConnector connector, ServerSocketChannel door) {
        try {
            connector.open(door);
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
        return connector;
    }

    private static ServerConnector encrypted(
            Server server, HttpConfiguration http, TlsListener listener, Connections connections) {
        var secure = new HttpConfiguration(http);
        secure.addCustomizer(new SecureRequestCustomizer(false)); // names of hosts are the AccessControl's business
        var tls = new SslContextFactory.Server();
        tls.setKeyStore(listener.identity());
        tls.setKeyStorePassword("");
        tls.setIncludeProtocols("TLSv1.2", "TLSv1.3");
        var connector = new ServerConnector(
                server, 1, 1, new SslConnectionFactory(tls, "http/1.1"), new HttpConnectionFactory(secure));
        connector.addBean(connections);
        connector.setIdleTimeout(IDLE.toMillis());
        connector.setName(REMOTE);
        return opened(connector, listener.channel());
    }

    /// With the token in the part that browsers keep to themselves.
    public URI url() {
        return url;
    }

    @Override
    public void close() {
        rehearsal.close();
        stop();
    }

    private void stop() {
        viewing.close();
        http.stop();
    }
}
