package rsal.ros2;

import java.nio.ByteBuffer;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionStage;
import java.util.function.BiConsumer;
import java.util.function.Consumer;
import java.util.function.Function;
import java.util.stream.Collectors;
import rsal.ros2.link.Profile;
import rsal.ros2.link.RosEndpoint;
import rsal.ros2.link.RosLink;
import rsal.ros2.link.RosTopic;
import rsal.ros2.type.Distribution;
import rsal.ros2.type.TypeLibrary;

/// A network of ROS 2 in memory: all who join it hear the others at once, on the thread that publishes. Of
/// one thread.
public final class MemoryNetwork {
    private static final TypeLibrary TYPES = TypeLibrary.of(Distribution.JAZZY);

    private final List<Member> members = new ArrayList<>();

    private final Map<String, Function<byte[], CompletionStage<byte[]>>> services = new HashMap<>();
    private final Map<String, String> serviceTypes = new HashMap<>(); // of those whose type is known

    private record Hearing(RosTopic topic, Profile profile, BiConsumer<String, ByteBuffer> listener) {
        /// Whether what is offered is enough.
        boolean fits(Profile offered) {
            return offered.compareTo(profile) >= 0;
        }
    }

    /// From now on, it has not acknowledged so many messages of those that it subscribes to as reliable.
    public void delay(RosLink member, long messages) {
        ((Member) member).lacking = messages;
    }

    private record Offer(RosTopic topic, Profile profile) {}

    /// From now on, somebody answers requests of that name.
    public void serve(String name, Function<byte[], CompletionStage<byte[]>> server) {
        services.put(name, server);
    }

    /// As [#serve(String, Function)], for those who need to know its type.
    public void serve(String name, String type, Function<byte[], CompletionStage<byte[]>> server) {
        serve(name, server);
        serviceTypes.put(name, type);
    }

    /// Types of the services that there are, by name.
    public Map<String, String> serviceTypes() {
        return Map.copyOf(serviceTypes);
    }

    /// Names of the nodes that there are: `/r1/rsal`.
    public List<String> nodes() {
        return members.stream().flatMap(member -> member.name.stream()).sorted().toList();
    }

    /// Nobody answers them any more.
    public void forget(String name) {
        services.remove(name);
        serviceTypes.remove(name);
    }

    public RosLink join() {
        return join(Optional.empty());
    }

    private Member join(Optional<String> name) {
        var member = new Member(name);
        members.add(member);
        return member;
    }

    private final class Member implements RosLink {
        private final Optional<String> name;
        private final String id = Integer.toString(members.size());
        private final List<Member> nodes = new ArrayList<>();
        private long lacking;
        private final List<Hearing> hearings = new ArrayList<>();
        private final List<Offer> offers = new ArrayList<>();
        private final Map<Offer, byte[]> latched = new HashMap<>();

        Member(Optional<String> name) {
            this.name = name;
        }

        @Override
        public RosLink node(String namespace, String name) {
            Member node = join(Optional.of(namespace.equals("/") ? "/" + name : namespace + "/" + name));
            nodes.add(node);
            return node;
        }

        private static RosEndpoint endpoint(RosTopic topic, boolean isPublisher, Profile profile) {
            return new RosEndpoint(topic, isPublisher, profile, TYPES.hash(topic.type()));
        }

        @Override
        public List<RosEndpoint> endpoints() {
            var all = new ArrayList<RosEndpoint>();
            members.stream().filter(each -> each != this).forEach(other -> {
                other.offers.forEach(offer -> all.add(endpoint(offer.topic, true, offer.profile)));
                other.hearings.forEach(hearing -> all.add(endpoint(hearing.topic, false, hearing.profile)));
            });
            return all;
        }

        @Override
        public Publication advertise(RosTopic topic, Profile profile) {
            var offer = new Offer(topic, profile);
            offers.add(offer);
            return new Publication() {
                @Override
                public void publish(byte[] message) {
                    if (profile == Profile.LATCHED) {
                        latched.put(offer, message);
                    }
                    List.copyOf(members).forEach(member -> member.hear(id, offer, message));
                }

                @Override
                public Map<String, Long> unacknowledged() {
                    return members.stream()
                            .filter(member -> member.hearings.stream()
                                    .anyMatch(each -> each.topic.equals(topic)
                                            && each.profile != Profile.SENSOR_DATA
                                            && each.fits(profile)))
                            .collect(Collectors.toMap(member -> member.id, member -> member.lacking));
                }

                @Override
                public void close() {
                    offers.remove(offer);
                    latched.remove(offer);
                }
            };
        }

        private void hear(String publisher, Offer offer, byte[] message) {
            List.copyOf(hearings).stream()
                    .filter(each -> each.topic.equals(offer.topic) && each.fits(offer.profile))
                    .forEach(each -> each.listener.accept(publisher, ByteBuffer.wrap(message)));
        }

        @Override
        public Subscribed subscribe(RosTopic topic, Profile profile, Consumer<ByteBuffer> listener) {
            return subscribeEach(topic, profile, (_, message) -> listener.accept(message));
        }

        @Override
        public String program(String id) {
            return "Program " + id;
        }

        @Override
        public Subscribed subscribeEach(RosTopic topic, Profile profile, BiConsumer<String, ByteBuffer> listener) {
            var hearing = new Hearing(topic, profile, listener);
            hearings.add(hearing);
            if (profile == Profile.LATCHED) {
                members.forEach(member -> member.latched.forEach((offer, message) -> {
                    if (offer.topic.equals(topic)) {
                        listener.accept(member.id, ByteBuffer.wrap(message));
                    }
                }));
            }
            return new Subscribed() {
                @Override
                public int publishers() {
                    return (int) members.stream()
                            .flatMap(member -> member.offers.stream())
                            .filter(offer -> offer.topic.equals(topic) && hearing.fits(offer.profile))
                            .count();
                }

                @Override
                public Set<String> publisherIds() {
                    return members.stream()
                            .filter(member -> member.offers.stream()
                                    .anyMatch(offer -> offer.topic.equals(topic) && hearing.fits(offer.profile)))
                            .map(member -> member.id)
                            .collect(Collectors.toSet());
                }

                @Override
                public void close() {
                    hearings.remove(hearing);
                }
            };
        }

        @Override
        public ServiceClient client(String name, String type) {
            return new ServiceClient() {
                @Override
                public boolean isAvailable() {
                    return services.containsKey(name);
                }

                @Override
                public CompletionStage<byte[]> call(byte[] request) {
                    var server = services.get(name);
                    return server == null
                            ? CompletableFuture.failedStage(new IllegalStateException("Nobody serves it."))
                            : server.apply(request);
                }

                @Override
                public void close() {}
            };
        }

        @Override
        public Served serve(String name, String type, Server server) {
            MemoryNetwork.this.serve(name, type, server::answer);
            return () -> forget(name);
        }

        @Override
        public void close() {
            nodes.forEach(Member::close);
            hearings.clear();
            offers.clear();
            members.remove(this);
        }
    }
}
