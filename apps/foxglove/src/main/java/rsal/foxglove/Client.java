package rsal.foxglove;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.ArrayList;
import java.util.Base64;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import rsal.data.OccupancyGrid;
import rsal.foxglove.ServerMessages.Advertise;
import rsal.foxglove.ServerMessages.Offer;
import rsal.recording.Backlog.Entry;
import rsal.recording.Encoder;
import rsal.recording.MessageSink;

/// One that watches: which channels it was told of, and which of them it wants. Written to on the server's thread; its
/// subscriptions come on its connection's. It is sent no more than it takes: while [#MOST_IN_PROGRESS] is under way, it
/// is left out, and then told all once more. Events it is told from the oldest that is known, also those that happened
/// before it came or while it was left out, and none twice.
final class Client implements MessageSink {
    static final int MOST_IN_PROGRESS = 8 << 20; // [B]

    private static final byte MESSAGE = 1;
    private static final byte TIME = 2;
    private static final int MESSAGE_HEAD = 1 + 4 + 8; // [B]

    private static final class Subscription {
        private final int id;
        private long nextEvent; // to be told, of the server's thread

        Subscription(int id) {
            this.id = id;
        }
    }

    /// Where messages go. Sending does not wait.
    interface Line {
        void send(String text);

        void send(ByteBuffer bytes);

        /// What was sent and has not left this process [B].
        long inProgress();
    }

    private final Line line;
    private final Encoder encoder;
    private final OccupancyGrid map;
    private final Set<Integer> channels = ConcurrentHashMap.newKeySet(); // that it knows
    private final Map<Integer, Subscription> subscriptions = new ConcurrentHashMap<>(); // by channel
    private final Map<Integer, Integer> wanted = new ConcurrentHashMap<>(); // channels, by subscription
    private volatile boolean isNew = true; // has not been told all
    private volatile boolean wantsMap = true; // which never changes

    // of the server's thread
    private final List<Offer> opened = new ArrayList<>(); // and not yet advertised
    private Set<Integer> ofEvents = Set.of(); // channels
    private List<Subscription> reportedEvents = List.of(); // those that are being told
    private long event; // the number of that which is told
    private long time = Long.MIN_VALUE; // [ns]

    /// @param start of the run, on its own clock [ns]
    /// @param map that its robots know
    Client(Line line, long start, OccupancyGrid map) {
        this.line = line;
        this.map = map;
        encoder = new Encoder(this, start);
    }

    /// Wants the messages of a channel.
    ///
    /// @param subscription by which the client knows them
    /// @return whether there is such a channel, and it was not wanted before
    synchronized boolean subscribe(int subscription, int channel) {
        if (!channels.contains(channel) || wanted.containsKey(subscription) || subscriptions.containsKey(channel)) {
            return false;
        }
        wanted.put(subscription, channel);
        subscriptions.put(channel, new Subscription(subscription));
        wantsMap = true;
        isNew = true;
        return true;
    }

    synchronized void unsubscribe(int subscription) {
        Integer channel = wanted.remove(subscription);
        if (channel != null) {
            subscriptions.remove(channel);
        }
    }

    /// Tells all to one that has come, or wants something else, since it was told.
    ///
    /// @param state the newest
    void welcome(Entry state) throws IOException {
        if (isNew && line.inProgress() <= MOST_IN_PROGRESS) {
            isNew = false;
            encoder.writeAgain();
            if (wantsMap) {
                wantsMap = false;
                encoder.map(map);
            }
            send(state);
        }
    }

    /// Tells the events that it wants and has not been told.
    void publishEvents(RecentEvents past) throws IOException {
        if (ofEvents.isEmpty()) {
            ofEvents = encoder.openEvents();
            advertise();
        }
        reportedEvents = ofEvents.stream()
                .map(subscriptions::get)
                .filter(Objects::nonNull)
                .toList();
        long next =
                reportedEvents.stream().mapToLong(each -> each.nextEvent).min().orElse(past.next());
        for (event = Math.max(next, past.first()); event < past.next(); event++) {
            if (line.inProgress() > MOST_IN_PROGRESS) {
                return;
            }
            send(past.event(event));
        }
    }

    /// Something else than an event.
    ///
    /// @return whether it was sent
    boolean write(Entry entry) throws IOException {
        if (line.inProgress() > MOST_IN_PROGRESS) {
            isNew = true; // as it has missed something
            return false;
        }
        send(entry);
        return true;
    }

    private void send(Entry entry) throws IOException {
        entry.write(encoder);
        advertise();
    }

    private void advertise() {
        if (!opened.isEmpty()) {
            opened.forEach(offer -> channels.add(offer.id())); // first, as it may want them at once
            line.send(ServerMessages.json(new Advertise(opened)));
            opened.clear();
        }
    }

    @Override
    public int open(String topic, String schema, byte[] descriptors, Map<String, String> about) {
        int id = channels.size() + opened.size() + 1;
        opened.add(new Offer(
                id, topic, "protobuf", schema, "protobuf", Base64.getEncoder().encodeToString(descriptors)));
        return id;
    }

    @Override
    public void message(int channel, long at, long taken, ByteBuffer message) {
        if (at > time) {
            time = at;
            line.send(bytes(1 + 8).put(TIME).putLong(at).flip());
        }
        Subscription subscription = subscriptions.get(channel);
        if (subscription != null && (!ofEvents.contains(channel) || isDue(subscription))) {
            line.send(bytes(MESSAGE_HEAD + message.remaining())
                    .put(MESSAGE)
                    .putInt(subscription.id)
                    .putLong(at)
                    .put(message.duplicate())
                    .flip());
        }
    }

    /// Whether it has not been told the event; then it is now. One that began while events are told waits until they
    /// are told again, or it would miss those before.
    private boolean isDue(Subscription subscription) {
        boolean due = subscription.nextEvent <= event && reportedEvents.contains(subscription);
        if (due) {
            subscription.nextEvent = event + 1;
        }
        return due;
    }

    private static ByteBuffer bytes(int length) {
        return ByteBuffer.allocate(length).order(ByteOrder.LITTLE_ENDIAN);
    }
}
