package rsal.agent.platform;

import java.util.ArrayList;
import java.util.BitSet;
import java.util.List;
import java.util.function.Consumer;
import org.jspecify.annotations.Nullable;
import rsal.agent.Message;

/// A message that those who listen are told: takes down who hears it at once, then lets them, in that order. It is one
/// task for all of them, as ten thousand agents that greet each other would be a hundred million. Of those who stand
/// in a channel's list it takes down a bit each: as many greetings are on their way at a time.
///
/// Calls come in turn, on the run's thread or on that of an agent.
final class MessageDispatch<M> implements Runnable {
    private final Message<M> message;
    private List<Subscriber<M>> subscribers = List.of(); // in the order in which they are told, which never changes
    private int reported; // number of the subscriber that is told now
    private @Nullable BitSet hearing; // numbers of the subscribers that hear it, as long as no others do
    private List<Hearer<M>> hearers = List.of(); // else: they themselves

    /// One who hears it.
    @FunctionalInterface
    interface Hearer<M> {
        void reach(MessageDispatch<M> reported);
    }

    /// An entry of a channel's list.
    static final class Subscriber<M> {
        private @Nullable Hearer<M> hearer; // as soon as it is known
    }

    MessageDispatch(Message<M> message) {
        this.message = message;
    }

    Message<M> message() {
        return message;
    }

    /// From now on these are told, one after the other.
    void begin(List<Subscriber<M>> channel) {
        subscribers = channel;
    }

    /// @param subscriber number of the one that is told next
    void tells(int subscriber) {
        reported = subscriber;
    }

    /// Lets one hear it that is always the same for the subscriber that is told.
    void add(Hearer<M> hearer) {
        if (hearers.isEmpty() && !subscribers.isEmpty() && isTheSubscribers(hearer)) {
            BitSet noted = hearing == null ? new BitSet(subscribers.size()) : hearing;
            noted.set(reported);
            hearing = noted;
        } else {
            addOnce(hearer);
        }
    }

    private boolean isTheSubscribers(Hearer<M> hearer) {
        Subscriber<M> subscriber = subscribers.get(reported);
        if (subscriber.hearer == null) {
            subscriber.hearer = hearer;
        }
        return hearer.equals(subscriber.hearer) && (hearing == null || !hearing.get(reported));
    }

    /// Lets one hear it who is made for this.
    void addOnce(Hearer<M> hearer) {
        if (hearers.isEmpty()) {
            hearers = noted();
            hearing = null;
        }
        hearers.add(hearer);
    }

    private List<Hearer<M>> noted() {
        var noted = new ArrayList<Hearer<M>>();
        forEach(subscribers, hearing, noted::add);
        return noted;
    }

    private static <M> void forEach(
            List<Subscriber<M>> subscribers, @Nullable BitSet hearing, Consumer<? super Hearer<M>> action) {
        if (hearing == null) {
            return;
        }
        for (int subscriber = hearing.nextSetBit(0); subscriber >= 0; subscriber = hearing.nextSetBit(subscriber + 1)) {
            Hearer<M> hearer = subscribers.get(subscriber).hearer;
            if (hearer != null) {
                action.accept(hearer);
            }
        }
    }

    boolean isHeard() {
        return hearing != null || !hearers.isEmpty();
    }

    @Override
    public void run() {
        List<Hearer<M>> now = hearers;
        List<Subscriber<M>> nowSubscribers = subscribers;
        BitSet nowHearing = hearing;
        hearers = List.of(); // copies of it that come late don't keep them
        subscribers = List.of();
        hearing = null;
        forEach(nowSubscribers, nowHearing, hearer -> hearer.reach(this));
        now.forEach(hearer -> hearer.reach(this));
    }
}
