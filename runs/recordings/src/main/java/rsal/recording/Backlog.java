package rsal.recording;

import java.io.IOException;
import java.time.Duration;
import java.util.ArrayDeque;
import java.util.Deque;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.locks.Condition;
import java.util.concurrent.locks.ReentrantLock;
import java.util.function.BooleanSupplier;
import rsal.agent.bdi.Mind;
import rsal.engine.report.RunEvent;
import rsal.engine.report.RunObserver;
import rsal.engine.report.SentMessage;
import rsal.engine.report.Snapshot;

/// What a run has told and nobody has taken yet: told on the run's thread, taken on one other. It is bounded: when
/// [Behind#DROP] is chosen, the newest states win and others are counted as dropped, and only when 100,000 events and
/// messages wait does the run, too, as those are never dropped. When [Behind#WAIT] is, the run waits for the one that
/// takes, and what is taken depends on nothing but the run.
public final class Backlog implements RunObserver {
    /// How often a run tells how everything stands.
    static final Duration PERIOD = Duration.ofMillis(100);

    private static final int MOST_STATES = 16; // that wait
    private static final int MOST_OTHERS = 100_000; // that wait
    private static final long PATIENCE = 200_000_000; // of who takes [ns]

    /// What happens when the run is faster than the one that takes.
    public enum Behind {
        WAIT,
        DROP
    }

    /// Something that was told.
    public sealed interface Entry {
        void write(Encoder encoder) throws IOException;

        /// When everything stood as it tells, since the run's start; empty when it tells something else.
        default Optional<Duration> seen() {
            return Optional.empty();
        }

        /// Whether it is an event, which no later state tells.
        default boolean isEvent() {
            return false;
        }
    }

    private static final class State implements Entry {
        private final Snapshot now;
        private final String hash;

        State(Snapshot now, String hash) {
            this.now = now;
            this.hash = hash;
        }

        @Override
        public void write(Encoder encoder) throws IOException {
            encoder.state(now, hash);
        }

        @Override
        public Optional<Duration> seen() {
            return Optional.of(now.time());
        }
    }

    private record Event(RunEvent event, String hash) implements Entry {
        @Override
        public void write(Encoder encoder) throws IOException {
            encoder.event(event, hash);
        }

        @Override
        public boolean isEvent() {
            return true;
        }
    }

    private record Heard(SentMessage said, Object content) implements Entry {
        @Override
        public void write(Encoder encoder) throws IOException {
            encoder.said(said, content);
        }
    }

    private record Minds(Duration time, Map<String, Mind.View> minds) implements Entry {
        @Override
        public void write(Encoder encoder) throws IOException {
            encoder.minds(time, minds);
        }
    }

    private final Behind behind;
    private final BooleanSupplier looks;
    private final ReentrantLock lock = new ReentrantLock();
    private final Condition changed = lock.newCondition();
    // under the lock
    private final Deque<Entry> waiting = new ArrayDeque<>();
    private final Deque<State> states = new ArrayDeque<>(); // those that wait
    private long dropped;
    private boolean ended;
    private boolean abandoned;

    /// One that is shown all.
    public Backlog(Behind behind) {
        this(behind, () -> true);
    }

    /// @param looks whether anybody wants to know how everything stands; asked on the run's thread
    public Backlog(Behind behind, BooleanSupplier looks) {
        this.behind = behind;
        this.looks = looks;
    }

    /// How everything stands, as somebody has asked for it.
    public static Entry asked(Snapshot now) {
        return new State(now, "");
    }

    @Override
    public Duration period() {
        return PERIOD;
    }

    @Override
    public boolean looks() {
        return looks.getAsBoolean();
    }

    @Override
    public void sees(Snapshot now, String hash) {
        lock.lock();
        try {
            while (behind == Behind.WAIT && states.size() >= MOST_STATES && isOpen()) {
                changed.awaitUninterruptibly();
            }
            if (states.size() >= MOST_STATES) {
                waiting.removeFirstOccurrence(states.removeFirst()); // near the front, being old
                dropped++;
            }
            var state = new State(now, hash);
            if (isOpen()) {
                states.addLast(state);
            }
            add(state);
        } finally {
            lock.unlock();
        }
    }

    @Override
    public void looksInto(Duration time, Map<String, Mind.View> minds) {
        if (!minds.isEmpty()) {
            visit(new Minds(time, Map.copyOf(minds)));
        }
    }

    @Override
    public void happened(RunEvent event, String hash) {
        visit(new Event(event, hash));
    }

    @Override
    public void heard(SentMessage message, Object content) {
        visit(new Heard(message, content));
    }

    private void visit(Entry entry) {
        lock.lock();
        try {
            while (waiting.size() >= MOST_OTHERS && isOpen()) {
                changed.awaitUninterruptibly();
            }
            add(entry);
        } finally {
            lock.unlock();
        }
    }

    /// Under the lock.
    private void add(Entry entry) {
        if (isOpen()) {
            waiting.addLast(entry);
            changed.signalAll();
        }
    }

    /// Under the lock. Else nobody takes what is added.
    private boolean isOpen() {
        return !ended && !abandoned;
    }

    /// The next; empty when there was none for a while, or no more come.
    public Optional<Entry> take() {
        lock.lock();
        try {
            long left = PATIENCE;
            while (waiting.isEmpty() && !ended && left > 0) {
                left = changed.awaitNanos(left);
            }
            Entry entry = waiting.pollFirst();
            if (entry != null && entry.equals(states.peekFirst())) {
                states.removeFirst();
            }
            if (entry != null) {
                changed.signalAll();
            }
            return Optional.ofNullable(entry);
        } catch (InterruptedException e) {
            throw new IllegalStateException("Nobody interrupts it.", e);
        } finally {
            lock.unlock();
        }
    }

    /// What is told from now on is forgotten; what waits is still to be taken.
    public void end() {
        lock.lock();
        try {
            ended = true;
            changed.signalAll();
        } finally {
            lock.unlock();
        }
    }

    /// Whether nothing more is told and all is taken.
    public boolean isOver() {
        lock.lock();
        try {
            return ended && waiting.isEmpty();
        } finally {
            lock.unlock();
        }
    }

    /// Nobody takes any more: what waits is forgotten, as is all that is told from now on.
    public void abandon() {
        lock.lock();
        try {
            abandoned = true;
            waiting.clear();
            states.clear();
            changed.signalAll();
        } finally {
            lock.unlock();
        }
    }

    /// States that nobody took, as they were too slow.
    public long dropped() {
        lock.lock();
        try {
            return dropped;
        } finally {
            lock.unlock();
        }
    }
}
