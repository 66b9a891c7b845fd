package rsal.ros2.rosbridge;

import java.nio.ByteBuffer;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.function.Consumer;
import java.util.function.IntSupplier;
import java.util.function.Supplier;
import org.jspecify.annotations.Nullable;
import rsal.ros2.link.Profile;
import rsal.ros2.link.RosLink.Subscribed;
import rsal.ros2.link.RosPublisher.Publication;
import rsal.ros2.link.RosTopic;

/// Topics that this program subscribes to and publishes through a server, which hears of them whenever there
/// is a connection. Safe for several threads.
final class BridgedTopics {
    private final RosbridgeSession session;
    private final RosbridgeOptions options;
    private final Supplier<Optional<MessageValues>> values;
    private final Map<String, List<Hearing>> hearings = new ConcurrentHashMap<>(); // by names of topics
    private final List<Offer> offers = new CopyOnWriteArrayList<>();
    private final Set<String> published = ConcurrentHashMap.newKeySet(); // since the beginning
    private final Set<String> subscribed = ConcurrentHashMap.newKeySet(); // also

    /// @param values of the server; empty as long as it is not known
    BridgedTopics(RosbridgeSession session, RosbridgeOptions options, Supplier<Optional<MessageValues>> values) {
        this.session = session;
        this.options = options;
        this.values = values;
    }

    private record Hearing(String id, RosTopic topic, Profile profile, Consumer<ByteBuffer> listener) {}

    private final class Offer implements Publication {
        private final String id = session.number();
        private final RosTopic topic;
        private final Profile profile;
        private volatile byte @Nullable [] last; // of a latched one

        Offer(RosTopic topic, Profile profile) {
            this.topic = topic;
            this.profile = profile;
        }

        void announce(MessageValues its) {
            session.send("advertise", out -> {
                out.writeStringProperty("id", id);
                out.writeStringProperty("topic", topic.name());
                out.writeStringProperty("type", its.version().wire(topic.type()));
                out.writeBooleanProperty("latch", profile == Profile.LATCHED);
            });
            byte[] latched = last;
            if (latched != null) {
                send(its, latched);
            }
        }

        private void send(MessageValues its, byte[] message) {
            var fields = its.ofCdr(topic.type(), message);
            session.send(id + " publish", "publish", out -> {
                out.writeStringProperty("id", id);
                out.writeStringProperty("topic", topic.name());
                out.writeName("msg");
                its.write(fields, out);
            });
        }

        @Override
        public void publish(byte[] message) {
            if (profile == Profile.LATCHED) {
                last = message;
            }
            values.get().ifPresent(its -> send(its, message));
        }

        @Override
        public void close() {
            if (offers.remove(this)) {
                session.send("unadvertise", out -> {
                    out.writeStringProperty("id", id);
                    out.writeStringProperty("topic", topic.name());
                });
            }
        }
    }

    Publication advertise(RosTopic topic, Profile profile) {
        var offer = new Offer(topic, profile);
        published.add(topic.name());
        offers.add(offer);
        values.get().ifPresent(offer::announce);
        return offer;
    }

    /// @param publishers how many there are now
    Subscribed subscribe(RosTopic topic, Profile profile, Consumer<ByteBuffer> listener, IntSupplier publishers) {
        var hearing = new Hearing(session.number(), topic, profile, listener);
        subscribed.add(topic.name());
        List<Hearing> all = hearings.computeIfAbsent(topic.name(), _ -> new CopyOnWriteArrayList<>());
        all.add(hearing);
        values.get().ifPresent(its -> announce(hearing, its));
        return new Subscribed() {
            @Override
            public int publishers() {
                return publishers.getAsInt();
            }

            @Override
            public void close() {
                if (all.remove(hearing)) {
                    session.send("unsubscribe", out -> {
                        out.writeStringProperty("id", hearing.id);
                        out.writeStringProperty("topic", topic.name());
                    });
                }
            }
        };
    }

    private void announce(Hearing hearing, MessageValues its) {
        TopicDelivery delivery = TopicDelivery.of(hearing.topic, hearing.profile, options.throttle());
        boolean isCbor = options.encoding() == RosbridgeOptions.Encoding.CBOR && its.isForCbor(hearing.topic.type());
        session.send("subscribe", out -> {
            out.writeStringProperty("id", hearing.id);
            out.writeStringProperty("topic", hearing.topic.name());
            out.writeStringProperty("type", its.version().wire(hearing.topic.type()));
            out.writeStringProperty("compression", isCbor ? "cbor" : "none");
            out.writeNumberProperty("throttle_rate", delivery.throttle().toMillis());
            out.writeNumberProperty("queue_length", delivery.waiting());
        });
    }

    /// Tells the server of all of them, as it has forgotten them.
    void announceAll(MessageValues its) {
        offers.forEach(each -> each.announce(its));
        hearings.values().forEach(all -> all.forEach(each -> announce(each, its)));
    }

    boolean publishes(String topic) {
        return published.contains(topic);
    }

    boolean subscribes(String topic) {
        return subscribed.contains(topic);
    }

    /// Hands a message on to all who hear its topic.
    void take(String topic, WireValue message) throws InvalidMessage {
        List<Hearing> all = hearings.getOrDefault(topic, List.of());
        Optional<MessageValues> its = values.get();
        if (all.isEmpty() || its.isEmpty()) {
            return; // it comes after it was unsubscribed from
        }
        String type = all.getFirst().topic.type();
        byte[] bytes = its.get().toCdr(type, message);
        for (Hearing each : all) {
            if (each.topic.type().equals(type)) {
                each.listener.accept(ByteBuffer.wrap(bytes));
            }
        }
    }
}
