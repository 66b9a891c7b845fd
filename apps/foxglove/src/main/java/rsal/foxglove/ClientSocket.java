package rsal.foxglove;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.atomic.AtomicLong;
import org.eclipse.jetty.websocket.api.Callback;
import org.eclipse.jetty.websocket.api.Session;
import org.eclipse.jetty.websocket.api.StatusCode;
import org.jspecify.annotations.Nullable;
import rsal.data.Pose2d;
import rsal.engine.report.Answer;
import rsal.foxglove.FoxgloveServer.Showing;
import rsal.foxglove.PublishedGoal.Unclear;
import rsal.foxglove.ServerMessages.ServerInfo;
import rsal.foxglove.ServerMessages.Status;
import tools.jackson.core.JacksonException;
import tools.jackson.databind.JsonNode;

/// A client's socket. Jetty calls it and sends for it on threads of its own; it calls only public classes. What
/// can't be understood is answered by a status that says why, and changes nothing.
@SuppressWarnings("exports") // public for Jetty alone
public final class ClientSocket extends Session.Listener.AbstractAutoDemanding implements Client.Line {
    private static final int MOST_PUBLISHED = 1000; // channels of a client
    private static final int PUBLISHED = 1; // first byte of what is published

    private final FoxgloveServer server;
    private final Showing showing;
    private final boolean mayPublish;
    private final long number;
    private final Client client;
    private final Map<Long, PublishedGoal> published = new ConcurrentHashMap<>(); // by channel
    private final AtomicLong inProgress = new AtomicLong(); // [B]

    /// @param mayPublish whether it knows the token
    /// @param number greater than those of all before
    ClientSocket(FoxgloveServer server, Showing showing, boolean mayPublish, long number) {
        this.server = server;
        this.showing = showing;
        this.mayPublish = mayPublish;
        this.number = number;
        client = new Client(
                this, showing.origin().start(), showing.origin().plan().map());
    }

    Client client() {
        return client;
    }

    Showing showing() {
        return showing;
    }

    /// Whether it knows the token.
    boolean mayPublish() {
        return mayPublish;
    }

    long number() {
        return number;
    }

    @Override
    public void onWebSocketOpen(Session session) {
        super.onWebSocketOpen(session);
        send(ServerMessages.json(ServerInfo.of(showing.origin(), mayPublish, showing.session())));
        if (!server.add(this)) {
            close(
                    StatusCode.TRY_AGAIN_LATER,
                    "%d are watching already, or another run has begun.".formatted(FoxgloveServer.MAX_CLIENTS));
        }
    }

    @Override
    public void onWebSocketText(String message) {
        try {
            JsonNode request = ClientJson.MAPPER.readTree(message);
            switch (request.path("op").asString("")) {
                case "subscribe" -> request.path("subscriptions").forEach(this::subscribe);
                case "unsubscribe" -> request.path("subscriptionIds").forEach(id -> client.unsubscribe(id.asInt(-1)));
                case "advertise" -> request.path("channels").forEach(this::advertised);
                case "unadvertise" -> request.path("channelIds").forEach(id -> published.remove(id.asLong(-1)));
                default ->
                    send(Status.warning("This server doesn't know the request '%s'."
                            .formatted(
                                    PublishedGoal.shortened(request.path("op").asString("")))));
            }
        } catch (JacksonException _) {
            send(Status.error("This is not JSON: '%s'.".formatted(PublishedGoal.shortened(message))));
        }
    }

    private void subscribe(JsonNode wanted) {
        int id = wanted.path("id").asInt(-1);
        int channel = wanted.path("channelId").asInt(-1);
        if (id < 0 || !client.subscribe(id, channel)) {
            send(Status.error(
                    "Subscription '%d' of channel '%d' is refused: there is no such channel, or one of them is in use."
                            .formatted(id, channel)));
        }
    }

    /// The client will publish something.
    private void advertised(JsonNode channel) {
        String topic = channel.path("topic").asString("");
        Optional<PublishedGoal> wish = PublishedGoal.of(topic);
        if (!mayPublish) {
            send(Status.error("To publish needs the run's token: open the address that was printed at start."));
        } else if (!channel.path("encoding").asString("").equals("json")) {
            send(Status.error(
                    "What is published here is JSON; '%s' is not.".formatted(PublishedGoal.shortened(topic))));
        } else if (wish.isEmpty()) {
            send(Status.warning("Topic '%s' is not known here. Publish to %s."
                    .formatted(PublishedGoal.shortened(topic), PublishedGoal.TOPICS)));
        } else if (published.size() < MOST_PUBLISHED) {
            published.put(channel.path("id").asLong(-1), wish.get());
        }
    }

    @Override
    public void onWebSocketBinary(ByteBuffer message, Callback taken) {
        ByteBuffer bytes = message.slice().order(ByteOrder.LITTLE_ENDIAN);
        if (bytes.remaining() < 1 + Integer.BYTES || bytes.get() != PUBLISHED) {
            send(Status.error("This was not published."));
        } else {
            PublishedGoal wish = published.get(Integer.toUnsignedLong(bytes.getInt()));
            byte[] pose = new byte[bytes.remaining()];
            bytes.get(pose);
            if (wish == null) {
                send(Status.error("To publish a channel, advertise it before; %s are understood."
                        .formatted(PublishedGoal.TOPICS)));
            } else {
                fulfil(wish, pose);
            }
        }
        taken.succeed();
    }

    private void fulfil(PublishedGoal wish, byte[] message) {
        Optional<String> heldBack = server.heldBack();
        if (heldBack.isPresent()) {
            send(Status.error(heldBack.get()));
            return;
        }
        try {
            Pose2d pose = PublishedGoal.pose(message);
            String robot = robot(wish);
            var run = showing.run().orElseThrow(() -> new Unclear("The run has not begun."));
            var answer = wish.kind() == PublishedGoal.Kind.GOAL
                    ? run.operator().goTo(robot, pose)
                    : run.operator().place(robot, pose);
            var _ = answer.handle((said, failure) -> {
                send(
                        switch (said) {
                            case Answer.Refused refused -> Status.error(refused.why());
                            case null -> Status.error("It failed: " + failure);
                            default ->
                                Status.info("%s: %s %.2f %.2f, %.0f°"
                                        .formatted(
                                                robot,
                                                wish.kind() == PublishedGoal.Kind.GOAL ? "goes to" : "is at",
                                                pose.x(),
                                                pose.y(),
                                                Math.toDegrees(pose.theta())));
                        });
                return said;
            });
        } catch (Unclear e) {
            send(Status.error(String.valueOf(e.getMessage())));
        }
    }

    /// Where a topic names none, the only one.
    private String robot(PublishedGoal wish) throws Unclear {
        var robots = showing.origin().plan().robots();
        if (!wish.robot().isEmpty()) {
            return wish.robot();
        } else if (robots.size() == 1) {
            return robots.getFirst().spec().id();
        }
        throw new Unclear("This run has %d robots. Publish to the topic of one: /%s/goal, /%s/initialpose."
                .formatted(
                        robots.size(),
                        robots.isEmpty() ? "ROBOT" : robots.getFirst().spec().id(),
                        robots.isEmpty() ? "ROBOT" : robots.getFirst().spec().id()));
    }

    @Override
    public void onWebSocketClose(int status, @Nullable String reason, Callback closed) {
        server.remove(this);
        closed.succeed();
    }

    @Override
    public void onWebSocketError(Throwable cause) {
        server.remove(this);
    }

    void close(int status, String reason) {
        server.remove(this);
        getSession().close(status, reason, Callback.NOOP);
    }

    private void send(Status status) {
        if (inProgress.get() <= Client.MOST_IN_PROGRESS) {
            send(ServerMessages.json(status));
        }
    }

    @Override
    public void send(String text) {
        getSession().sendText(text, sent(text.length()));
    }

    @Override
    public void send(ByteBuffer bytes) {
        int length = bytes.remaining();
        getSession().sendBinary(bytes, sent(length));
    }

    private Callback sent(int length) {
        inProgress.addAndGet(length);
        return Callback.from(() -> inProgress.addAndGet(-length), _ -> inProgress.addAndGet(-length));
    }

    @Override
    public long inProgress() {
        return inProgress.get();
    }
}
