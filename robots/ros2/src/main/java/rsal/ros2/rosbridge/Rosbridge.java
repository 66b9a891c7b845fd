package rsal.ros2.rosbridge;

import java.util.Optional;
import rsal.time.Scheduler;

/// All that the nodes of a link share: the connection to the server, what is there, and what is open.
final class Rosbridge implements RosbridgeSession.Listener {
    private final RosbridgeSession session;
    private final GraphWatcher watcher;
    private final BridgedTopics topics;
    private final BridgedServices services;
    private final BridgedActions actions;
    private volatile Optional<MessageValues> values = Optional.empty(); // of the server, since it is known

    Rosbridge(RosbridgeTransport transport, RosbridgeOptions options, Scheduler scheduler) {
        session = new RosbridgeSession(transport, options.address().toString(), scheduler, this);
        topics = new BridgedTopics(session, options, () -> values);
        services = new BridgedServices(session, () -> values);
        actions = new BridgedActions(session, scheduler, () -> values);
        var used = new GraphWatcher.Used() {
            @Override
            public boolean publishes(String topic) {
                return topics.publishes(topic);
            }

            @Override
            public boolean subscribes(String topic) {
                return topics.subscribes(topic);
            }
        };
        watcher = new GraphWatcher(session, scheduler, options.distribution(), used, this::onKnown);
        session.open();
    }

    RosbridgeSession session() {
        return session;
    }

    GraphWatcher watcher() {
        return watcher;
    }

    BridgedTopics topics() {
        return topics;
    }

    BridgedServices services() {
        return services;
    }

    BridgedActions actions() {
        return actions;
    }

    private void onKnown(MessageValues its) {
        values = Optional.of(its);
        topics.announceAll(its);
        services.announceAll(its);
    }

    @Override
    public void onConnected() {
        actions.onConnected();
        values.ifPresent(its -> {
            topics.announceAll(its);
            services.announceAll(its);
        });
        watcher.begin();
    }

    @Override
    public void onDisconnected() {
        watcher.end();
        actions.onDisconnected();
    }

    @Override
    public void onMessage(String topic, WireValue message) throws InvalidMessage {
        topics.take(topic, message);
    }

    @Override
    public void onRefused(String id, String why) {
        actions.onRefused(id, why);
    }

    @Override
    public void onOperation(String operation, WireValue.Fields fields) throws InvalidMessage {
        switch (operation) {
            case "action_feedback" -> actions.onFeedback(fields);
            case "action_result" -> actions.onResult(fields);
            case "call_service" -> services.answer(fields);
            case "fragment", "png" ->
                throw new InvalidMessage(
                        "It came in parts ('%s'). Raise the server's max_message_size.".formatted(operation));
            default -> throw new InvalidMessage("Its operation '%s' is not known.".formatted(operation));
        }
    }

    void close() {
        watcher.end();
        session.close();
    }
}
