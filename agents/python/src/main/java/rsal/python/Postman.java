package rsal.python;

import java.time.Instant;
import java.util.ArrayDeque;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Queue;
import java.util.SequencedMap;
import java.util.function.Consumer;
import org.jspecify.annotations.Nullable;

/// Brings events to Python in real time, on a thread of its own, so that the run never waits. Each agent has a queue;
/// agents with events have their turns one after the other. Of a device's readings only the newest waits; everything
/// else is kept, as far as there is room.
final class Postman {
    /// An event of an agent on its way.
    ///
    /// @param newest whether a later one of the same number takes its place
    /// @param since when the agent has waited for it, or for one whose place it took
    /// @param bring told that time
    record Letter(int number, boolean newest, Instant since, Consumer<Instant> bring) {
        Letter inPlaceOf(Letter before) {
            return new Letter(number, newest, before.since, bring);
        }
    }

    private static final int MOST = 10_000; // that wait for an agent
    private static final Letter NOTHING = new Letter(0, false, Instant.EPOCH, _ -> {});

    private final PythonWorker worker;
    private final Map<Integer, SequencedMap<Object, Letter>> waiting = new HashMap<>(); // by agent; guarded by this
    private final Queue<Integer> turns = new ArrayDeque<>(); // agents with letters; guarded by this
    private boolean closed; // guarded by this

    Postman(PythonWorker worker) {
        this.worker = worker;
        Thread.ofPlatform().daemon().name("python-io").start(this::work);
    }

    /// @throws IllegalStateException when too many wait for the agent, by which it ends
    synchronized void post(int agent, Letter letter) {
        SequencedMap<Object, Letter> own = waiting.computeIfAbsent(agent, _ -> new LinkedHashMap<>());
        if (own.isEmpty()) {
            turns.add(agent);
        }
        if (own.size() >= MOST) {
            throw new IllegalStateException(
                    "More than %d events wait for it: it is too slow for what happens. Maybe subscribe with 'at_most_every'."
                            .formatted(MOST));
        }
        own.merge(
                letter.newest ? (Object) letter.number : new Object(),
                letter,
                (before, later) -> later.inPlaceOf(before));
        notifyAll();
    }

    /// An agent has ended: nothing is brought to it any more.
    synchronized void forget(int agent, Instant now) {
        waiting.remove(agent);
        turns.remove(agent);
        post(agent, new Letter(0, false, now, _ -> {
            worker.turns().endNow(agent, now);
            drop(agent);
        }));
    }

    private synchronized void drop(int agent) {
        waiting.remove(agent);
    }

    /// Brings what waits, and ends.
    synchronized void close() {
        closed = true;
        notifyAll();
    }

    private void work() {
        try {
            for (Letter letter = take(); letter != null; letter = take()) {
                letter.bring.accept(letter.since);
            }
        } finally {
            worker.hangUp();
        }
    }

    private synchronized @Nullable Letter take() {
        while (turns.isEmpty()) {
            if (closed) {
                return null;
            }
            try {
                wait();
            } catch (InterruptedException e) {
                Thread.currentThread().interrupt();
                return null;
            }
        }
        int agent = turns.remove();
        SequencedMap<Object, Letter> own = waiting.getOrDefault(agent, new LinkedHashMap<>());
        Map.Entry<Object, Letter> first = own.pollFirstEntry();
        if (!own.isEmpty()) {
            turns.add(agent);
        }
        return first == null ? NOTHING : first.getValue();
    }
}
