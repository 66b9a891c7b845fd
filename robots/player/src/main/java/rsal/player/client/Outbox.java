package rsal.player.client;

import java.util.ArrayDeque;
import java.util.LinkedHashMap;
import java.util.Queue;
import java.util.concurrent.locks.Condition;
import java.util.concurrent.locks.ReentrantLock;
import rsal.player.wire.Packet;

/// What is to be sent: requests in their order, before commands, of which a newer one takes the place of one of its
/// kind that was not sent yet. So nothing grows when the network is slow, and what goes out is what is wanted now. May
/// be used on any thread.
final class Outbox {
    private static final int MOST = 1024; // requests

    private final ReentrantLock lock = new ReentrantLock();
    private final Condition some = lock.newCondition();
    private final Queue<Packet> requests = new ArrayDeque<>();
    private final LinkedHashMap<Signature, Packet> commands = new LinkedHashMap<>();

    /// @return whether there was room for it
    boolean request(Packet request) {
        lock.lock();
        try {
            if (requests.size() == MOST) {
                return false;
            }
            requests.add(request);
            some.signal();
            return true;
        } finally {
            lock.unlock();
        }
    }

    void command(Packet command) {
        lock.lock();
        try {
            commands.put(Signature.of(command.header()), command);
            some.signal();
        } finally {
            lock.unlock();
        }
    }

    /// The next; waits for it.
    Packet take() throws InterruptedException {
        lock.lock();
        try {
            while (requests.isEmpty() && commands.isEmpty()) {
                some.await();
            }
            Packet request = requests.poll();
            return request != null ? request : commands.pollFirstEntry().getValue();
        } finally {
            lock.unlock();
        }
    }
}
