package rsal.foxglove;

import java.io.IOException;
import java.net.BindException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.URI;
import java.nio.channels.ServerSocketChannel;
import java.time.Duration;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.atomic.AtomicLong;
import java.util.function.Supplier;
import org.eclipse.jetty.http.HttpHeader;
import org.eclipse.jetty.http.HttpStatus;
import org.eclipse.jetty.server.HttpConfiguration;
import org.eclipse.jetty.server.HttpConnectionFactory;
import org.eclipse.jetty.server.Request;
import org.eclipse.jetty.server.Response;
import org.eclipse.jetty.server.Server;
import org.eclipse.jetty.server.ServerConnector;
import org.eclipse.jetty.util.Callback;
import org.eclipse.jetty.util.thread.QueuedThreadPool;
import org.eclipse.jetty.websocket.api.StatusCode;
import org.eclipse.jetty.websocket.server.ServerUpgradeRequest;
import org.eclipse.jetty.websocket.server.ServerUpgradeResponse;
import org.eclipse.jetty.websocket.server.ServerWebSocketContainer;
import org.eclipse.jetty.websocket.server.WebSocketUpgradeHandler;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;
import rsal.engine.LiveRun;
import rsal.engine.report.RunObserver;
import rsal.recording.Backlog;
import rsal.recording.Backlog.Behind;
import rsal.recording.Backlog.Entry;
import rsal.recording.Origin;

/// Shows runs to Foxglove, one after the other, on this machine's loopback address: what recordings have, ten
/// times a second of the run, at most. Programs of this machine may look; pages, as Foxglove itself is one,
/// need the token, and so does anyone who publishes goals and poses ([PublishedGoal#TOPICS]).
///
/// There are places for some clients. Who knows the token takes one from those who do not, when all are taken.
///
/// A client that takes less than is sent is left out until it has taken it. With another run, all are let go,
/// and come again. All methods may be called from any thread.
public final class FoxgloveServer implements AutoCloseable {
    /// Where Foxglove looks when nobody says otherwise.
    public static final int PORT = 8765;

    static final int MAX_CLIENTS = 8;

    private static final String LOOPBACK = "127.0.0.1";
    private static final List<String> PROTOCOLS = List.of("foxglove.sdk.v1", "foxglove.websocket.v1");
    private static final int MAX_TEXT = 1 << 20; // [B]; as many channels may be wanted at once
    private static final int MAX_BINARY = 64 << 10; // [B]
    private static final Logger LOG = LoggerFactory.getLogger(FoxgloveServer.class);

    private final Server server;
    private final FoxgloveAccess door;
    private final URI url;
    private final Thread shower;
    private final Set<ClientSocket> connections = ConcurrentHashMap.newKeySet();
    private final AtomicLong numbers = new AtomicLong(); // of connections
    private volatile @Nullable Showing now;
    private volatile boolean closed;
    private volatile Supplier<Optional<String>> heldBack = Optional::empty;
    private int runs; // under the lock of this

    /// A run that is shown.
    static final class Showing {
        private final Origin origin;
        private final Backlog backlog;
        private final String session;
        private volatile @Nullable LiveRun run;

        // of the shower's thread
        private final RecentEvents past = new RecentEvents();
        private Optional<Entry> state = Optional.empty(); // the newest
        private Duration reported = Duration.ZERO; // its time

        Showing(Origin origin, Backlog backlog, String session) {
            this.origin = origin;
            this.backlog = backlog;
            this.session = session;
        }

        Origin origin() {
            return origin;
        }

        /// What clients know it by.
        String session() {
            return session;
        }

        Optional<LiveRun> run() {
            return Optional.ofNullable(run);
        }

        /// How everything stands, where that is not older than what was told.
        private Optional<Entry> asked() {
            return run().map(LiveRun::snapshot)
                    .filter(now -> now.time().compareTo(reported) >= 0)
                    .map(Backlog::asked);
        }

        private void note(Optional<Entry> next) {
            next.flatMap(Entry::seen).ifPresent(time -> {
                state = next;
                reported = time;
            });
        }
    }

    /// Opens the port. Nobody is let in before the first run.
    ///
    /// @param port 0 for any that is free
    /// @param token letters, digits, `-` and `_`
    /// @throws BindException when the port is taken
    public static FoxgloveServer start(int port, String token) throws IOException {
        ServerSocketChannel channel = ServerSocketChannel.open();
        try {
            channel.bind(new InetSocketAddress(InetAddress.ofLiteral(LOOPBACK), port));
            return new FoxgloveServer(channel, token);
        } catch (IOException | RuntimeException e) {
            channel.close();
            throw e;
        }
    }

    private FoxgloveServer(ServerSocketChannel channel, String token) throws IOException {
        int port = ((InetSocketAddress) channel.getLocalAddress()).getPort();
        url = URI.create("ws://localhost:%d/?token=%s".formatted(port, token));
        door = new FoxgloveAccess(port, token);
        var threads = new QueuedThreadPool(8, 2);
        threads.setName("foxglove-server");
        threads.setDaemon(true);
        server = new Server(threads);
        server.setStopTimeout(0);
        var http = new HttpConfiguration();
        http.setSendServerVersion(false);
        var connector = new ServerConnector(server, 1, 1, new HttpConnectionFactory(http));
        connector.setHost(LOOPBACK);
        connector.open(channel);
        server.addConnector(connector);
        server.setHandler(WebSocketUpgradeHandler.from(server, this::configure));
        try {
            server.start();
        } catch (Exception e) {
            throw new IOException("The server for Foxglove can't start.", e);
        }
        shower = Thread.ofPlatform().name("foxglove").daemon().unstarted(this::show);
    }

    private void configure(ServerWebSocketContainer sockets) {
        sockets.setMaxTextMessageSize(MAX_TEXT);
        sockets.setMaxBinaryMessageSize(MAX_BINARY);
        sockets.setIdleTimeout(Duration.ZERO); // a paused run has nothing to say
        sockets.addMapping("/*", this::open);
    }

    private @Nullable ClientSocket open(
            ServerUpgradeRequest request, ServerUpgradeResponse response, Callback callback) {
        Showing showing = now;
        String token = Request.extractQueryParameters(request).getValue("token");
        Optional<String> refusal = door.refuse(
                request.getHeaders().get(HttpHeader.HOST), request.getHeaders().get(HttpHeader.ORIGIN), token);
        Optional<String> protocol =
                PROTOCOLS.stream().filter(request.getSubProtocols()::contains).findFirst();
        if (refusal.isPresent()) {
            return refuse(request, response, callback, HttpStatus.FORBIDDEN_403, refusal.get());
        } else if (protocol.isEmpty()) {
            return refuse(
                    request,
                    response,
                    callback,
                    HttpStatus.BAD_REQUEST_400,
                    "Clients speak one of %s, not %s.".formatted(PROTOCOLS, request.getSubProtocols()));
        } else if (showing == null) {
            return refuse(request, response, callback, HttpStatus.SERVICE_UNAVAILABLE_503, "No run has begun.");
        }
        response.setAcceptedSubProtocol(protocol.get());
        response.setExtensions(List.of()); // compressing costs more than loopback does
        return new ClientSocket(this, showing, door.knows(token), numbers.incrementAndGet());
    }

    private static @Nullable ClientSocket refuse(
            ServerUpgradeRequest request, ServerUpgradeResponse response, Callback callback, int status, String why) {
        LOG.info("A connection was refused: {}", why);
        Response.writeError(request, response, callback, status, why);
        return null;
    }

    /// From now on takes goals and poses only while nothing holds them back.
    ///
    /// @param heldBack why they are not to be taken now; asked on threads of this server
    public void heed(Supplier<Optional<String>> heldBack) {
        this.heldBack = heldBack;
    }

    Optional<String> heldBack() {
        return heldBack.get();
    }

    /// What Foxglove is to open, with the token.
    public URI url() {
        return url;
    }

    /// The next run.
    ///
    /// @return whom it is to tell
    public synchronized RunObserver next(Origin origin) {
        Showing before = now;
        runs++;
        var backlog = new Backlog(Behind.DROP, () -> !connections.isEmpty());
        var next = new Showing(origin, backlog, "%s-%d".formatted(origin.started(), runs));
        now = next;
        if (before == null) {
            shower.start();
        } else {
            before.backlog.abandon();
            before.backlog.end();
            List.copyOf(connections).forEach(old -> old.close(StatusCode.SHUTDOWN, "Another run has begun."));
        }
        return next.backlog;
    }

    /// The run that [#next] announced has begun, and takes goals from now on.
    public void began(LiveRun run) {
        Showing showing = now;
        if (showing != null) {
            showing.run = run;
        }
    }

    /// Who knows the token always has a place: the one of who has been there longest without it, or else with
    /// it.
    ///
    /// @return whether there was room
    boolean add(ClientSocket connection) {
        Optional<ClientSocket> leaves;
        synchronized (this) {
            if (!connection.showing().equals(now)) {
                return false;
            }
            leaves = connections.size() < MAX_CLIENTS ? Optional.empty() : leavesFor(connection);
            if (connections.size() >= MAX_CLIENTS && leaves.isEmpty()) {
                return false;
            }
            leaves.ifPresent(connections::remove);
            connections.add(connection);
        }
        leaves.ifPresent(
                other -> other.close(StatusCode.TRY_AGAIN_LATER, "Another client with the token takes this place."));
        return true;
    }

    private Optional<ClientSocket> leavesFor(ClientSocket connection) {
        return connections.stream()
                .filter(_ -> connection.mayPublish())
                .min(Comparator.comparing(ClientSocket::mayPublish).thenComparingLong(ClientSocket::number));
    }

    void remove(ClientSocket connection) {
        connections.remove(connection);
    }

    /// On the thread `foxglove`.
    private void show() {
        for (Showing showing = now; showing != null && !closed; showing = now) {
            Optional<Entry> taken = showing.backlog.take();
            taken.filter(Entry::isEvent).ifPresent(showing.past::add);
            if (connections.isEmpty()) {
                showing.state = Optional.empty(); // nothing newer comes while nobody looks
                continue;
            }
            Optional<Entry> next = taken.or(showing::asked); // it is paused, slow, or has ended
            showing.note(next);
            for (ClientSocket connection : connections) {
                if (connection.showing().equals(showing)) {
                    show(showing, next, connection);
                }
            }
        }
    }

    private static void show(Showing showing, Optional<Entry> next, ClientSocket connection) {
        Client client = connection.client();
        try {
            client.publishEvents(showing.past);
            if (next.isPresent() && !next.get().isEvent()) {
                client.write(next.get());
            }
            if (showing.state.isPresent()) {
                client.welcome(showing.state.get());
            }
        } catch (IOException | RuntimeException e) {
            LOG.warn("A client was disconnected, since nothing could be sent to it.", e);
            connection.close(StatusCode.SERVER_ERROR, "Showing the run failed.");
        }
    }

    /// Lets all go. Closing twice does nothing.
    @Override
    public void close() {
        closed = true;
        Showing last = now;
        if (last != null) {
            last.backlog.abandon();
            last.backlog.end();
        }
        try {
            server.stop();
        } catch (Exception e) {
            LOG.warn("The server for Foxglove did not stop.", e);
        }
    }
}
