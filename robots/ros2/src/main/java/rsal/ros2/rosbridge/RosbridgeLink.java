package rsal.ros2.rosbridge;

import java.nio.ByteBuffer;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import java.util.function.BooleanSupplier;
import java.util.function.Consumer;
import java.util.function.IntSupplier;
import rsal.ros2.link.Profile;
import rsal.ros2.link.RosEndpoint;
import rsal.ros2.link.RosLink;
import rsal.ros2.link.RosTopic;
import rsal.ros2.type.Distribution;
import rsal.time.Scheduler;

/// ROS 1 or 2 through a server of rosbridge. What is open stays open while the server is away: it hears of it
/// again.
///
/// A server has one node for all of its clients, so nodes of this link have no names there. It matches
/// quality of service itself, tells no hashes of types, and notices no publisher of ROS 1 that was killed:
/// its data is stale. Actions can be used, and not served. To be used on the scheduler's thread.
public final class RosbridgeLink implements RosLink {
    private final Rosbridge bridge;
    private final boolean isOwner; // of the connection
    private final Set<AutoCloseable> open = ConcurrentHashMap.newKeySet();

    /// Connects, as soon as the server is there.
    ///
    /// @param transport is closed with the link
    public RosbridgeLink(RosbridgeTransport transport, RosbridgeOptions options, Scheduler scheduler) {
        this(new Rosbridge(transport, options, scheduler), true);
    }

    private RosbridgeLink(Rosbridge bridge, boolean isOwner) {
        this.bridge = bridge;
        this.isOwner = isOwner;
    }

    @Override
    public RosLink node(String namespace, String name) {
        var node = new RosbridgeLink(bridge, false);
        open.add(node);
        return node;
    }

    @Override
    public List<RosEndpoint> endpoints() {
        return bridge.watcher().endpoints();
    }

    /// Whether the server has told which topics there are, since it was connected.
    public boolean hasAnswered() {
        return bridge.watcher().isComplete();
    }

    @Override
    public Optional<Distribution> distribution() {
        return bridge.watcher().distribution();
    }

    @Override
    public Optional<String> trouble() {
        return bridge.session().trouble();
    }

    @Override
    public String suspicion() {
        return "do the robot's drivers run beside rosbridge?";
    }

    private <T extends AutoCloseable> T opened(T made) {
        open.add(made);
        return made;
    }

    @Override
    public Publication advertise(RosTopic topic, Profile profile) {
        return opened(bridge.topics().advertise(topic, profile));
    }

    @Override
    public Subscribed subscribe(RosTopic topic, Profile profile, Consumer<ByteBuffer> listener) {
        Optional<String> action = BridgedActions.action(topic.name());
        if (action.isPresent()) {
            IntSupplier servers = () -> isServed(action.get()).getAsBoolean() ? 1 : 0;
            return opened(bridge.actions().subscribe(topic, listener, servers));
        }
        IntSupplier publishers = () -> bridge.watcher().graph().publishers(topic);
        return opened(bridge.topics().subscribe(topic, profile, listener, publishers));
    }

    private BooleanSupplier isServed(String action) {
        return () -> bridge.watcher().graph().actions().containsKey(action);
    }

    @Override
    public ServiceClient client(String name, String type) {
        Optional<String> action = BridgedActions.action(name);
        return opened(
                action.isPresent()
                        ? bridge.actions().client(name, type, isServed(action.get()))
                        : bridge.services()
                                .client(
                                        name,
                                        type,
                                        () -> bridge.watcher()
                                                .graph()
                                                .services()
                                                .contains(name)));
    }

    /// @throws IllegalArgumentException for parts of actions
    @Override
    public Served serve(String name, String type, Server server) {
        if (BridgedActions.action(name).isPresent()) {
            throw new IllegalArgumentException("Actions can't be served through rosbridge: '%s'.".formatted(name));
        }
        return opened(bridge.services().serve(name, type, server));
    }

    /// How many messages of the server were malformed.
    public long malformed() {
        return bridge.session().malformed();
    }

    /// Closing what was closed before does nothing.
    @Override
    public void close() {
        for (AutoCloseable each : List.copyOf(open)) {
            close(each);
        }
        open.clear();
        if (isOwner) {
            bridge.close();
        }
    }

    private static void close(AutoCloseable each) {
        try {
            each.close();
        } catch (RuntimeException e) {
            throw e;
        } catch (Exception e) {
            throw new IllegalStateException(e);
        }
    }
}
