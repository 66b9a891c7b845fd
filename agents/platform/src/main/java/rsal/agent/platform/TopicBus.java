package rsal.agent.platform;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.function.Consumer;
import java.util.function.Supplier;
import rsal.agent.Message;
import rsal.agent.Topic;
import rsal.device.Listeners;
import rsal.device.Subscription;

/// Those who listen to a topic, in the order in which they subscribed. What is for one of them reaches that one
/// without asking the others, so that a conversation costs the same in a team of a thousand.
final class TopicBus<M> {
    private final Topic<M> topic;
    private final String firstUser;
    private final Supplier<Listeners<MessageDispatch<M>>> none;
    private final Listeners<MessageDispatch<M>> all;
    private final Map<String, Listeners<MessageDispatch<M>>> byAgent = new HashMap<>();
    private final List<Place<M>> places = new ArrayList<>(); // of all
    private List<MessageDispatch.Subscriber<M>> subscribers = List.of(); // of all, as they were told last
    private boolean changed; // since then

    /// @param none makes a set of listeners without any
    TopicBus(Topic<M> topic, String firstUser, Supplier<Listeners<MessageDispatch<M>>> none) {
        this.topic = topic;
        this.firstUser = firstUser;
        this.none = none;
        this.all = none.get();
    }

    Topic<M> topic() {
        return topic;
    }

    /// Who wanted it first.
    String firstUser() {
        return firstUser;
    }

    Subscription add(String agent, Consumer<? super MessageDispatch<M>> listener) {
        Listeners<MessageDispatch<M>> own = byAgent.computeIfAbsent(agent, _ -> none.get());
        var place = new Place<M>(listener);
        places.add(place);
        changed = true;
        Subscription amongAll = all.add(place);
        Subscription amongOwn = own.add(listener);
        return () -> {
            amongAll.cancel();
            changed |= places.remove(place);
            amongOwn.cancel();
            if (own.isEmpty()) {
                byAgent.remove(agent, own);
            }
        };
    }

    boolean isHeardBy(String agent) {
        return byAgent.containsKey(agent);
    }

    void deliver(MessageDispatch<M> said) {
        Message<M> message = said.message();
        if (message.isForAll()) {
            said.begin(subscribers());
            all.publish(said);
        } else {
            deliver(said, message.to());
        }
    }

    private List<MessageDispatch.Subscriber<M>> subscribers() {
        if (changed) {
            for (int i = 0; i < places.size(); i++) {
                places.get(i).number = i;
            }
            subscribers = places.stream().map(place -> place.subscriber).toList();
            changed = false;
        }
        return subscribers;
    }

    /// One of those who listen to all that is said here.
    private static final class Place<M> implements Consumer<MessageDispatch<M>> {
        private final Consumer<? super MessageDispatch<M>> listener;
        private final MessageDispatch.Subscriber<M> subscriber = new MessageDispatch.Subscriber<>();
        private int number; // among all, as they were told last

        Place(Consumer<? super MessageDispatch<M>> listener) {
            this.listener = listener;
        }

        @Override
        public void accept(MessageDispatch<M> said) {
            said.tells(number);
            listener.accept(said);
        }
    }

    /// Tells one of those it is for.
    void deliver(MessageDispatch<M> said, String agent) {
        Listeners<MessageDispatch<M>> own = byAgent.get(agent);
        if (own != null) {
            own.publish(said);
        }
    }
}
