package rsal.player.server;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.Iterator;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.locks.Condition;
import java.util.concurrent.locks.ReentrantLock;
import java.util.function.DoubleSupplier;
import rsal.player.message.Session;
import rsal.player.message.Session.ReplaceRule;
import rsal.player.wire.Header;
import rsal.player.wire.Kind;
import rsal.player.wire.Packet;

/// What one client is to be sent, as Player has it: pushed, all as soon as it can be; pulled, in rounds that the client
/// asks for, each of which ends with a synch once there was data in it. Data is dropped when there is too much, answers
/// never: whoever asks waits until there is [room][#awaitRoom]. May be used on any thread.
final class OutQueue {
    static final int MOST = 1024; // messages, as Player has it
    private static final int MOST_ANSWERS = 256;
    private static final long LARGEST_ANSWERS = 4L << 20; // bytes of all of them
    private static final int MOST_RULES = 256;

    private final ReentrantLock lock = new ReentrantLock();
    private final Condition changed = lock.newCondition();
    private final Deque<Packet> queue = new ArrayDeque<>();
    private final List<ReplaceRule> rules = new ArrayList<>();
    private boolean pulled;
    private boolean wanted; // a round, that has not ended
    private int left; // messages of the round, those that were there when it began
    private int delivered; // data in it
    private int answers; // in the queue
    private long answerBytes; // of those
    private int dropped; // since the last synch
    private boolean closed;

    void mode(boolean pull) {
        lock.lock();
        try {
            pulled = pull;
            wanted &= pull;
            changed.signalAll();
        } finally {
            lock.unlock();
        }
    }

    /// @return whether there was room for it
    boolean add(ReplaceRule rule) {
        lock.lock();
        try {
            return rules.size() < MOST_RULES && rules.add(rule);
        } finally {
            lock.unlock();
        }
    }

    void data(Packet packet) {
        lock.lock();
        try {
            int fate = fate(packet.header());
            if (fate == Session.IGNORE) {
                return;
            }
            if (fate == Session.REPLACE) {
                removeNewestLike(packet.header());
            }
            if (queue.size() >= MOST) {
                dropped++;
                return;
            }
            queue.addLast(packet);
            changed.signalAll();
        } finally {
            lock.unlock();
        }
    }

    private int fate(Header header) {
        for (ReplaceRule rule : rules) {
            if (holds(rule.interf(), header.address().interf())
                    && holds(rule.index(), header.address().index())
                    && holds(rule.type(), header.kind().code())
                    && holds(rule.subtype(), header.subtype())) {
                return rule.replace();
            }
        }
        return Session.QUEUE;
    }

    private static boolean holds(int asked, int is) {
        return asked == Session.ANY || asked == is;
    }

    private void removeNewestLike(Header header) {
        Iterator<Packet> newestFirst = queue.descendingIterator();
        while (newestFirst.hasNext()) {
            Header other = newestFirst.next().header();
            if (other.address().equals(header.address())
                    && other.kind() == header.kind()
                    && other.subtype() == header.subtype()) {
                newestFirst.remove();
                return;
            }
        }
    }

    void answer(Packet packet) {
        lock.lock();
        try {
            queue.addLast(packet);
            count(packet, 1);
            changed.signalAll();
        } finally {
            lock.unlock();
        }
    }

    /// A client asks for a round of data.
    ///
    /// @param ack that says so, before all else
    void round(Packet ack) {
        lock.lock();
        try {
            queue.addFirst(ack);
            count(ack, 1);
            wanted = true;
            left = queue.size();
            delivered = 0;
            changed.signalAll();
        } finally {
            lock.unlock();
        }
    }

    /// The client is gone: nobody waits any more.
    void close() {
        lock.lock();
        try {
            closed = true;
            changed.signalAll();
        } finally {
            lock.unlock();
        }
    }

    /// Waits until the client has taken some of its answers, or is gone.
    void awaitRoom() throws InterruptedException {
        lock.lock();
        try {
            while ((answers >= MOST_ANSWERS || answerBytes >= LARGEST_ANSWERS) && !closed) {
                changed.await();
            }
        } finally {
            lock.unlock();
        }
    }

    /// What is to be sent next; waits for it. Empty once the client is gone.
    ///
    /// @param time of the server, for a synch [s]
    Optional<Packet> take(DoubleSupplier time) throws InterruptedException {
        lock.lock();
        try {
            while (!closed) {
                if (wanted && delivered > 0 && (left <= 0 || queue.isEmpty())) {
                    wanted = false;
                    return Optional.of(synch(time.getAsDouble()));
                }
                if (!queue.isEmpty() && (!pulled || wanted || answers > 0)) {
                    return Optional.of(next());
                }
                changed.await();
            }
            return Optional.empty();
        } finally {
            lock.unlock();
        }
    }

    private Packet next() {
        Packet packet = queue.removeFirst();
        left--;
        if (packet.header().kind() == Kind.DATA) {
            delivered++;
        } else {
            count(packet, -1);
            changed.signalAll(); // for whoever awaits room
        }
        return packet;
    }

    private void count(Packet answer, int more) {
        answers += more;
        answerBytes += (long) more * answer.body().length;
    }

    private Packet synch(double time) {
        int lost = dropped;
        dropped = 0;
        return lost == 0
                ? Packet.of(Session.SERVER, Kind.SYNCH, Session.COMPLETE, time)
                : Packet.of(Session.SERVER, Kind.SYNCH, Session.OVERFLOW, time, new Session.Lost(lost));
    }
}
