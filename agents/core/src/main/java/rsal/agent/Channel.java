package rsal.agent;

import java.util.HashMap;
import java.util.Map;
import java.util.function.Consumer;
import java.util.function.Supplier;
import rsal.device.Listeners;
import rsal.device.Subscription;

/// Those who listen to a topic, in the order in which they subscribed. What is for one of them reaches that one
/// without asking the others, so that a conversation costs the same in a team of a thousand.
final class Channel<M> {
    private final Topic<M> topic;
    private final String firstUser;
    private final Supplier<Listeners<Telling<M>>> none;
    private final Listeners<Telling<M>> all;
    private final Map<String, Listeners<Telling<M>>> byAgent = new HashMap<>();

    /// @param none makes a set of listeners without any
    Channel(Topic<M> topic, String firstUser, Supplier<Listeners<Telling<M>>> none) {
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

    Subscription add(String agent, Consumer<? super Telling<M>> listener) {
        Listeners<Telling<M>> own = byAgent.computeIfAbsent(agent, _ -> none.get());
        Subscription amongAll = all.add(listener);
        Subscription amongOwn = own.add(listener);
        return () -> {
            amongAll.cancel();
            amongOwn.cancel();
            if (own.isEmpty()) {
                byAgent.remove(agent, own);
            }
        };
    }

    boolean isHeardBy(String agent) {
        return byAgent.containsKey(agent);
    }

    void tell(Telling<M> said) {
        Message<M> message = said.message();
        if (message.isForAll()) {
            all.tell(said);
        } else {
            tell(said, message.to());
        }
    }

    /// Tells one of those it is for.
    void tell(Telling<M> said, String agent) {
        Listeners<Telling<M>> own = byAgent.get(agent);
        if (own != null) {
            own.tell(said);
        }
    }
}
