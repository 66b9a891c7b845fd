package rsal.server;

import io.javalin.Javalin;
import io.javalin.compression.CompressionStrategy;
import io.javalin.config.JavalinConfig;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.net.BindException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.URI;
import java.nio.channels.ServerSocketChannel;
import java.nio.file.Path;
import java.security.SecureRandom;
import java.util.Base64;
import java.util.function.Consumer;
import java.util.function.Function;
import org.eclipse.jetty.ee10.websocket.server.config.JettyWebSocketServletContainerInitializer;
import org.eclipse.jetty.server.HttpConfiguration;
import org.eclipse.jetty.server.HttpConnectionFactory;
import org.eclipse.jetty.server.Server;
import org.eclipse.jetty.server.ServerConnector;
import org.eclipse.jetty.util.thread.QueuedThreadPool;
import rsal.scenario.RunPlan;
import rsal.scenario.run.LiveRun;

/// Runs a scenario and shows it on this machine's loopback address, and there only. Whoever can reach the port
/// may look; changing anything takes the token.
///
/// All methods may be called from any thread.
public final class RunServer implements AutoCloseable {
    /// Of a WebSocket message or a request's body [B]; all that the page sends is smaller.
    static final int MAX_MESSAGE = 16 * 1024;

    private static final String LOOPBACK = "127.0.0.1";

    private final Javalin http;
    private final CurrentRun current;
    private final Live live;
    private final URI url;
    private final String token;

    /// @param port 0 for any that is free
    /// @param token what a browser must know to change anything, as from [#newToken]
    /// @param page directory of the built page
    /// @param onStart told of each run, the first and those that replace it, when it begins
    /// @param starter starts a run
    public record Options(
            int port, String token, Path page, Consumer<LiveRun> onStart, Function<RunPlan, LiveRun> starter) {
        /// With runs that nobody else sees all of.
        public Options(int port, String token, Path page, Consumer<LiveRun> onStart) {
            this(port, token, page, onStart, LiveRun::start);
        }
    }

    /// Opens the port, then starts the run.
    ///
    /// @throws PortInUse when the port is taken; nothing was started then
    /// @throws IOException when the page was not built, or the port can't be opened for another reason
    public static RunServer start(RunPlan plan, Options options) throws IOException, PortInUse {
        var page = new Page(options.page());
        ServerSocketChannel door = open(options.port());
        try {
            return new RunServer(plan, options, page, door);
        } catch (RuntimeException e) {
            door.close();
            throw e;
        }
    }

    private RunServer(RunPlan plan, Options options, Page page, ServerSocketChannel door) throws IOException {
        int port = ((InetSocketAddress) door.getLocalAddress()).getPort();
        token = options.token();
        url = URI.create("http://%s:%d/#token=%s".formatted(LOOPBACK, port, token));
        current = new CurrentRun(plan, options.onStart(), options.starter());
        var gate = new Gate(port, options.token());
        live = new Live(current, gate);
        http = Javalin.create(config -> {
            configure(config, door);
            new Api(current, gate, page).configure(config.routes);
        });
        try {
            http.start();
        } catch (RuntimeException e) {
            close();
            throw e;
        }
    }

    private static ServerSocketChannel open(int port) throws IOException, PortInUse {
        ServerSocketChannel door = ServerSocketChannel.open();
        try {
            return door.bind(new InetSocketAddress(InetAddress.ofLiteral(LOOPBACK), port));
        } catch (BindException e) {
            door.close();
            throw new PortInUse(port);
        } catch (IOException | RuntimeException e) {
            door.close();
            throw e;
        }
    }

    private void configure(JavalinConfig config, ServerSocketChannel door) {
        config.startup.showJavalinBanner = false;
        config.startup.showOldJavalinVersionWarning = false;
        config.startup.startupWatcherEnabled = false;
        config.http.asyncTimeout = 5_000;
        config.http.maxRequestSize = MAX_MESSAGE;
        config.http.compressionStrategy = CompressionStrategy.NONE;
        var threads = new QueuedThreadPool(16, 2);
        threads.setName("server");
        threads.setDaemon(true);
        config.jetty.threadPool = threads;
        config.jetty.addConnector((server, http) -> connector(server, http, door));
        config.jetty.modifyServer(server -> server.setStopTimeout(0));
        config.jetty.modifyHttpConfiguration(http -> http.setSendServerVersion(false));
        // not Javalin's own sockets, which give every viewer a session and a cookie
        config.jetty.modifyServletContextHandler(context ->
                JettyWebSocketServletContainerInitializer.configure(context, (_, sockets) -> live.configure(sockets)));
    }

    private static ServerConnector connector(Server server, HttpConfiguration http, ServerSocketChannel door) {
        var connector = new ServerConnector(server, 1, 1, new HttpConnectionFactory(http));
        connector.setHost(LOOPBACK);
        try {
            connector.open(door);
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
        return connector;
    }

    /// 128 random bits, as they may stand in a URL.
    public static String newToken() {
        byte[] bits = new byte[16];
        new SecureRandom().nextBytes(bits);
        return Base64.getUrlEncoder().withoutPadding().encodeToString(bits);
    }

    /// What whoever wants to change something must know.
    public String token() {
        return token;
    }

    /// The page's address, with the token in the part that browsers keep to themselves.
    public URI url() {
        return url;
    }

    /// The run that is shown now.
    public LiveRun run() {
        return current.now().run();
    }

    /// Ends the run and the server within a second. Closing twice does nothing.
    @Override
    public void close() {
        live.close();
        http.stop();
        current.close();
    }
}
