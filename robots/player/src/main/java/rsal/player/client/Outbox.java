package rsal.player.client;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.locks.Condition;
import java.util.concurrent.locks.ReentrantLock;
import rsal.player.wire.Address;
import rsal.player.wire.Packet;

/// What is to be sent, in its order; but a newer command takes the place of one of its kind that was not sent yet. So
/// nothing grows when the network is slow, and what goes out is what is wanted now. May be used on any thread.
final class Outbox {
    private static final int MOST = 1024; // messages

    private final ReentrantLock lock = new ReentrantLock();
    private final Condition some = lock.newCondition();
    private final LinkedHashMap<Object, List<Packet>> waiting = new LinkedHashMap<>(); // commands by signature
    private boolean closed;

    /// @return whether there was room for it
    boolean request(Packet request) {
        return put(new Object(), List.of(request));
    }

    /// @return whether there was room for it
    boolean command(Packet command) {
        return put(Signature.of(command.header()), List.of(command));
    }

    /// Commands that make sense together only, in place of such for the same device that were not sent yet.
    ///
    /// @return whether there was room for them
    boolean commands(Address device, List<Packet> together) {
        return put(device, List.copyOf(together));
    }

    private boolean put(Object key, List<Packet> packets) {
        lock.lock();
        try {
            boolean room = waiting.size() < MOST || waiting.containsKey(key);
            if (closed || !room) {
                return false;
            }
            waiting.putLast(key, packets); // what was wanted last is said last
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

    /// Whether there is nothing to take now.
    boolean isEmpty() {
        lock.lock();
        try {
            return waiting.isEmpty();
        } finally {
            lock.unlock();
        }
    }

    /// The next that belong together; waits for them. Empty once it is closed and nothing is left.
    Optional<List<Packet>> take() throws InterruptedException {
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
