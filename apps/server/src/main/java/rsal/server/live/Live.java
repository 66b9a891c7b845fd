package rsal.server.live;

import java.nio.ByteBuffer;
import java.time.Duration;
import java.util.Comparator;
import java.util.List;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.Executors;
import java.util.concurrent.ScheduledExecutorService;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.concurrent.atomic.AtomicLong;
import org.eclipse.jetty.ee10.websocket.server.JettyServerUpgradeRequest;
import org.eclipse.jetty.ee10.websocket.server.JettyServerUpgradeResponse;
import org.eclipse.jetty.ee10.websocket.server.JettyWebSocketServerContainer;
import org.eclipse.jetty.websocket.api.Callback;
import org.eclipse.jetty.websocket.api.Session;
import org.eclipse.jetty.websocket.api.StatusCode;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;
import rsal.server.http.AccessControl;
import rsal.server.http.Http;
import rsal.server.http.ViewerEndpoint;
import rsal.server.live.ViewerCounts.Reason;
import rsal.server.message.Json;
import rsal.server.message.Messages.Access;
import rsal.server.message.Messages.Receipt;
import rsal.server.message.Messages.ServerMessage;
import rsal.server.message.Refusal;

/// Shows a run over WebSockets, 20 times a second, or 4 times when it goes by too fast to be followed: to draw more
/// would take from the run what nobody sees. Each snapshot of one that goes on is encoded once for all that look; while
/// nobody looks, twice a second, to look back on.
public final class Live implements ViewerEndpoint {
    /// Without the token; who has it may always enter.
    public static final int MAX_VIEWERS = 64;
    /// What viewers are told when their run was closed; of those codes that applications may use (RFC 6455, 7.4.2).
    public static final int CLOSED = 4000;

    private static final int PERIOD_MILLIS = 50;
    private static final Duration PERIOD = Duration.ofMillis(PERIOD_MILLIS);
    private static final int UNWATCHED = 10; // periods between looks
    private static final int FAST = 5;
    private static final int LONGEST_WAIT = 20; // periods in which the token may come where all seats are taken
    private static final String RECEIPTS =
            "This takes receipts: {\"frame\": 7} or {\"events\": 7}; and {\"look\": {\"time\": 7}}.";
    private static final Logger LOG = LoggerFactory.getLogger(Live.class);

    private final ViewSource showing;
    private final AccessControl gate;
    private final Set<Connection> connections = ConcurrentHashMap.newKeySet();
    private final Set<Connection> waiting = ConcurrentHashMap.newKeySet(); // while all seats are taken, for the token
    private final AtomicLong newest = new AtomicLong();
    private final ViewerCounts counts = new ViewerCounts();
    private final ScheduledExecutorService clock;
    private volatile boolean ended;
    private long periods; // the clock's thread only

    public Live(ViewSource showing, AccessControl gate) {
        this.showing = showing;
        this.gate = gate;
        clock = Executors.newSingleThreadScheduledExecutor(
                Thread.ofPlatform().name("server-live").daemon().factory());
        var _ = clock.scheduleAtFixedRate(this::offer, PERIOD_MILLIS, PERIOD_MILLIS, TimeUnit.MILLISECONDS);
    }

    @Override
    public void configure(JettyWebSocketServerContainer sockets) {
        sockets.setMaxTextMessageSize(Http.MAX_MESSAGE);
        sockets.setMaxBinaryMessageSize(Http.MAX_MESSAGE);
        sockets.setIdleTimeout(Duration.ZERO); // a paused run has nothing to say
        sockets.addMapping("/api/live", this::open);
    }

    @Nullable
    public Connection open(JettyServerUpgradeRequest request, JettyServerUpgradeResponse response) throws Exception {
        response.setExtensions(List.of()); // compressing costs more than loopback does
        return new Connection();
    }

    private void offer() {
        try {
            if (periods++ % periodsPerLook() == 0) {
                showing.look(periodsPerLook());
            }
            for (Connection connection : connections) {
                offer(connection);
            }
            waiting.forEach(Connection::waitOn);
        } catch (RuntimeException e) {
            LOG.error("Could not show the run.", e); // the next snapshot may do
        }
    }

    private int periodsPerLook() {
        return connections.isEmpty() ? UNWATCHED : showing.isFast() ? FAST : 1;
    }

    private void offer(Connection connection) {
        try {
            connection.viewer.offer(showing.live(), showing.past(), PERIOD);
        } catch (RuntimeException e) {
            LOG.warn("A viewer was disconnected, since nothing could be sent to it.", e);
            connections.remove(connection);
            counts.letGo(Reason.FAILED);
            connection.viewer.drop();
        }
    }

    /// How many there are now. For any thread.
    public int viewers() {
        return connections.size();
    }

    /// What they were sent. For any thread.
    public ViewerCounts counts() {
        return counts;
    }

    /// Tells all viewers that there will be nothing more to see, and lets them go.
    public void end() {
        ended = true;
        close();
        connections.forEach(Connection::end);
    }

    @Override
    public void close() {
        clock.shutdownNow();
        try {
            clock.awaitTermination(1, TimeUnit.SECONDS);
        } catch (InterruptedException _) {
            Thread.currentThread().interrupt();
        }
    }

    /// One viewer's socket. Jetty calls it and sends for it on threads of its own; it calls only public classes.
    public final class Connection extends Session.Listener.AbstractAutoDemanding implements Viewer.Line {
        private final Viewer viewer = new Viewer(this, counts);
        private final AtomicInteger inProgress = new AtomicInteger();
        private final long number = newest.incrementAndGet();
        private volatile boolean trusted; // it has shown the token
        private int patience = LONGEST_WAIT; // periods; the clock's thread only

        @Override
        public void onWebSocketOpen(Session session) {
            super.onWebSocketOpen(session);
            if (connections.size() >= MAX_VIEWERS) {
                waiting.add(this);
            } else {
                enter();
            }
        }

        private void enter() {
            connections.add(this);
            counts.addViewer();
            if (ended) {
                end(); // nobody else would any more
            }
        }

        /// A viewer with the token may always enter. The oldest one without it makes room.
        private void show(String token) {
            trusted = gate.isToken("Bearer " + token);
            send(Json.write(ServerMessage.of(new Access(trusted))));
            if (trusted && waiting.remove(this)) {
                connections.stream()
                        .filter(other -> !other.trusted)
                        .min(Comparator.comparingLong(other -> other.number))
                        .ifPresent(Connection::makeRoom);
                enter();
            }
        }

        private void makeRoom() {
            close(Reason.FULL, StatusCode.TRY_AGAIN_LATER, "%d browsers are watching already.".formatted(MAX_VIEWERS));
        }

        /// Called each period.
        private void waitOn() {
            if (--patience < 0) {
                makeRoom();
            }
        }

        @Override
        public void onWebSocketText(String message) {
            try {
                Receipt receipt = Json.read(message, Receipt.class);
                viewer.received(receipt);
                receipt.token().ifPresent(this::show);
            } catch (Refusal _) {
                close(Reason.NONSENSE, StatusCode.POLICY_VIOLATION, RECEIPTS);
            }
        }

        @Override
        public void onWebSocketBinary(ByteBuffer message, Callback taken) {
            taken.succeed();
            close(Reason.NONSENSE, StatusCode.BAD_DATA, RECEIPTS);
        }

        @Override
        public void onWebSocketClose(int status, @Nullable String reason, Callback closed) {
            leave();
            closed.succeed();
        }

        @Override
        public void onWebSocketError(Throwable cause) {
            leave();
        }

        private void leave() {
            connections.remove(this);
            waiting.remove(this);
        }

        private void end() {
            connections.remove(this);
            getSession().close(CLOSED, "This run was closed.", Callback.NOOP);
        }

        private void close(Reason why, int status, String words) {
            leave();
            counts.letGo(why);
            getSession().close(status, words, Callback.NOOP);
        }

        @Override
        public void send(String text) {
            getSession().sendText(text, sent());
        }

        @Override
        public void send(byte[] bytes) {
            getSession().sendBinary(ByteBuffer.wrap(bytes), sent());
        }

        private Callback sent() {
            inProgress.incrementAndGet();
            return Callback.from(inProgress::decrementAndGet, _ -> inProgress.decrementAndGet());
        }

        @Override
        public boolean isClear() {
            return inProgress.get() == 0;
        }

        @Override
        public void cut() {
            getSession().disconnect();
        }
    }
}
