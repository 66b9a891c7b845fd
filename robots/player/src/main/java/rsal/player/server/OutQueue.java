package rsal.player.server;

import java.time.Duration;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.Iterator;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.locks.Condition;
import java.util.concurrent.locks.ReentrantLock;
import java.util.function.DoubleSupplier;
import java.util.function.LongSupplier;
import rsal.player.message.Session;
import rsal.player.message.Session.ReplaceRule;
import rsal.player.wire.Header;
import rsal.player.wire.MessageKind;
import rsal.player.wire.Packet;

/// What one client is to be sent, as Player has it: pushed, all as soon as it can be; pulled, in rounds that the
/// client asks for, each of which ends with a synch once there was data in it. What came about at the same time is
/// never torn apart: it is all in one round. Data is dropped when there is too much, answers never: the client that
/// asks waits until there is [room][#awaitRoom]. May be used on any thread.
final class OutQueue {
    static final int MOST = 1024; // messages, as Player has it
    private static final int MOST_ANSWERS = 256;
    private static final long LARGEST_ANSWERS = 4L << 20; // bytes of all of them
    private static final int MOST_RULES = 256;
    private static final Duration PATIENCE = Duration.ofSeconds(1); // with who pulls, of a run that could go on

    private final ReentrantLock lock = new ReentrantLock();
    private final Condition changed = lock.newCondition();
    private final DoubleSupplier time;
    private final LongSupplier clock; // real time [ns]
    private final Deque<Packet> going = new ArrayDeque<>(); // before all others, as they are
    private final Deque<Packet> queue = new ArrayDeque<>(); // what came since
    private final List<ReplaceRule> rules = new ArrayList<>();
    private boolean pulled;
    private boolean wanted; // a round, that waits for data
    private int answers; // not sent yet
    private long answerBytes; // of those
    private int dropped; // since the last synch
    private boolean asked; // for a round, ever
    private long askedAt; // last [ns]
    private boolean closed;

    /// @param time of the server, for a synch [s]
    /// @param clock of real time, in which clients live [ns], such as `System::nanoTime`
    OutQueue(DoubleSupplier time, LongSupplier clock) {
        this.time = time;
        this.clock = clock;
    }

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

    /// What has come about at the same time.
    void data(List<Packet> packets) {
        lock.lock();
        try {
            packets.forEach(this::add);
            if (wanted) {
                endRound();
            }
            changed.signalAll();
        } finally {
            lock.unlock();
        }
    }

    private void add(Packet packet) {
        int fate = fate(packet.header());
        if (fate == Session.IGNORE) {
            return;
        }
        if (fate == Session.REPLACE) {
            removeNewestLike(packet.header());
        }
        if (going.size() + queue.size() >= MOST) {
            dropped++;
            return;
        }
        queue.addLast(packet);
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

    /// It goes at once, with all that came before it.
    void answer(Packet packet) {
        lock.lock();
        try {
            queue.addLast(packet);
            count(packet, 1);
            if (pulled) {
                go();
            }
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
            going.addLast(ack);
            count(ack, 1);
            asked = true;
            askedAt = clock.getAsLong();
            endRound();
            changed.signalAll();
        } finally {
            lock.unlock();
        }
    }

    /// All that is there goes; the round is over if there is data in it, else it waits for some.
    private void endRound() {
        wanted = queue.stream().noneMatch(packet -> packet.header().kind() == MessageKind.DATA);
        go();
        if (!wanted) {
            going.addLast(synch());
        }
    }

    private void go() {
        going.addAll(queue);
        queue.clear();
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
    Optional<Packet> take() throws InterruptedException {
        lock.lock();
        try {
            while (!closed) {
                Optional<Packet> next = next();
                if (next.isPresent()) {
                    return next;
                }
                changed.await();
            }
            return Optional.empty();
        } finally {
            lock.unlock();
        }
    }

    /// Whether there is nothing to take now.
    boolean isIdle() {
        lock.lock();
        try {
            return going.isEmpty() && (pulled || queue.isEmpty());
        } finally {
            lock.unlock();
        }
    }

    /// Whether there is data for a client that pulls, and has not asked for it yet; but not for more than a second.
    boolean isBehind() {
        lock.lock();
        try {
            return pulled
                    && asked
                    && !wanted
                    && !closed
                    && !queue.isEmpty()
                    && clock.getAsLong() - askedAt < PATIENCE.toNanos();
        } finally {
            lock.unlock();
        }
    }

    private Optional<Packet> next() {
        Optional<Packet> next = Optional.ofNullable(going.pollFirst());
        if (next.isEmpty() && !pulled) {
            next = Optional.ofNullable(queue.pollFirst());
        }
        next.filter(OutQueue::isAnswer).ifPresent(answer -> {
            count(answer, -1);
            changed.signalAll(); // for those that await room
        });
        return next;
    }

    private static boolean isAnswer(Packet packet) {
        return packet.header().kind() == MessageKind.ACK || packet.header().kind() == MessageKind.NACK;
    }

    private void count(Packet answer, int more) {
        answers += more;
        answerBytes += (long) more * answer.body().length;
    }

    private Packet synch() {
        int lost = dropped;
        dropped = 0;
        return lost == 0
                ? Packet.of(Session.SERVER, MessageKind.SYNCH, Session.COMPLETE, time.getAsDouble())
                : Packet.of(
                        Session.SERVER,
                        MessageKind.SYNCH,
                        Session.OVERFLOW,
                        time.getAsDouble(),
                        new Session.Lost(lost));
    }
}
