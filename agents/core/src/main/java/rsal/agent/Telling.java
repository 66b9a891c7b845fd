package rsal.agent;

import java.util.ArrayList;
import java.util.List;

/// A message that those who listen are told: takes down who hears it at once, then lets them, in that order. It is one
/// task for all of them, as ten thousand agents that greet each other would be a hundred million.
///
/// Calls come in turn, on the run's thread or on that of an agent.
final class Telling<M> implements Runnable {
    private final Message<M> message;
    private List<Hearer<M>> hearers = new ArrayList<>();

    /// One who hears it.
    @FunctionalInterface
    interface Hearer<M> {
        void reach(Telling<M> told);
    }

    Telling(Message<M> message) {
        this.message = message;
    }

    Message<M> message() {
        return message;
    }

    void add(Hearer<M> hearer) {
        hearers.add(hearer);
    }

    boolean isHeard() {
        return !hearers.isEmpty();
    }

    @Override
    public void run() {
        List<Hearer<M>> now = hearers;
        hearers = List.of(); // copies of it that come late don't keep them
        now.forEach(hearer -> hearer.reach(this));
    }
}
