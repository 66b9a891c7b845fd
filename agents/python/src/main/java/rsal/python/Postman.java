package rsal.python;

import java.time.Instant;
import java.util.ArrayDeque;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Queue;
import java.util.SequencedMap;
import org.jspecify.annotations.Nullable;

/// Brings events to Python in real time, on a thread of its own, so that the run never waits. Each agent has a queue;
/// agents with events have their turns one after the other. Of a device's readings only the newest waits; everything
/// else is kept.
final class Postman {
    /// An event of an agent on its way.
    ///
    /// @param newest whether a later one of the same number takes its place
    record Letter(int number, boolean newest, Runnable bring) {}

    private final PythonWorker worker;
    private final Map<Integer, SequencedMap<Object, Letter>> waiting = new HashMap<>(); // by agent; guarded by this
    private final Queue<Integer> turns = new ArrayDeque<>(); // agents with letters; guarded by this
    private boolean closed; // guarded by this

    Postman(PythonWorker worker) {
        this.worker = worker;
        Thread.ofPlatform().daemon().name("python-io").start(this::work);
    }

    synchronized void post(int agent, Letter letter) {
        SequencedMap<Object, Letter> own = waiting.computeIfAbsent(agent, _ -> new LinkedHashMap<>());
        if (own.isEmpty()) {
            turns.add(agent);
        }
        own.put(letter.newest ? (Object) letter.number : new Object(), letter);
        notifyAll();
    }

    /// An agent has ended: nothing is brought to it any more.
    synchronized void forget(int agent, Instant now) {
        waiting.remove(agent);
        turns.remove(agent);
        post(agent, new Letter(0, false, () -> {
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
                letter.bring.run();
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
        return first == null ? new Letter(0, false, () -> {}) : first.getValue();
    }
}
