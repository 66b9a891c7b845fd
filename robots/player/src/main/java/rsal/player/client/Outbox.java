package rsal.player.client;

import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.locks.Condition;
import java.util.concurrent.locks.ReentrantLock;
import rsal.player.wire.Packet;

/// What is to be sent, in its order; but a newer command takes the place of one of its kind that was not sent yet. So
/// nothing grows when the network is slow, and what goes out is what is wanted now. May be used on any thread.
final class Outbox {
    private static final int MOST = 1024; // messages

    private final ReentrantLock lock = new ReentrantLock();
    private final Condition some = lock.newCondition();
    private final LinkedHashMap<Object, Packet> waiting = new LinkedHashMap<>(); // commands by signature
    private boolean closed;

    /// @return whether there was room for it
    boolean request(Packet request) {
        return put(new Object(), request);
    }

    /// @return whether there was room for it
    boolean command(Packet command) {
        return put(Signature.of(command.header()), command);
    }

    private boolean put(Object key, Packet packet) {
        lock.lock();
        try {
            boolean room = waiting.size() < MOST || waiting.containsKey(key);
            if (closed || !room) {
                return false;
            }
            waiting.put(key, packet);
            some.signal();
            return true;
        } finally {
            lock.unlock();
        }
    }

    /// Takes nothing more; what is in it still goes out.
    void close() {
        lock.lock();
        try {
            closed = true;
            some.signalAll();
        } finally {
            lock.unlock();
        }
    }

    /// The next; waits for it. Empty once it is closed and nothing is left.
    Optional<Packet> take() throws InterruptedException {
        lock.lock();
        try {
            while (waiting.isEmpty() && !closed) {
                some.await();
            }
            return Optional.ofNullable(waiting.pollFirstEntry()).map(Map.Entry::getValue);
        } finally {
            lock.unlock();
        }
    }
}
