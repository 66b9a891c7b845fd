package rsal.recording;

import java.io.IOException;
import java.nio.channels.FileChannel;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.time.Duration;
import java.util.ArrayDeque;
import java.util.Deque;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.locks.Condition;
import java.util.concurrent.locks.ReentrantLock;
import java.util.function.LongSupplier;
import org.jspecify.annotations.Nullable;
import rsal.agent.bdi.Mind;
import rsal.recording.mcap.McapWriter;
import rsal.scenario.run.RunEvent;
import rsal.scenario.run.RunResult;
import rsal.scenario.run.Said;
import rsal.scenario.run.Snapshot;
import rsal.scenario.run.Witness;

/// Records a run: what it is told on the run's thread it writes on one of its own, `recorder`. What waits to be written
/// is bounded: when [Behind#DROP] is chosen, the newest states win and others are counted as dropped, and only when
/// 100,000 events and messages wait does the run, too, as those are never dropped. When [Behind#WAIT] is, the run waits
/// for the file, and what is written depends on nothing but the run.
///
/// When writing fails, the run goes on and nothing more is recorded ([#failure]).
public final class Recorder implements Witness, AutoCloseable {
    private static final Duration PERIOD = Duration.ofMillis(100);
    private static final int MOST_STATES = 16; // that wait
    private static final int MOST_OTHERS = 100_000; // that wait
    private static final long TICK = 200_000_000; // [ns]

    /// What happens when the run is faster than the file.
    public enum Behind {
        WAIT,
        DROP
    }

    private final Behind behind;
    private final McapWriter file;
    private final Encoder encoder;
    private final Thread writer;

    private final ReentrantLock lock = new ReentrantLock();
    private final Condition changed = lock.newCondition();
    // under the lock
    private final Deque<Entry> waiting = new ArrayDeque<>();
    private final Deque<State> states = new ArrayDeque<>(); // those that wait
    private long dropped;
    private boolean ending;
    private @Nullable RunResult result;
    private @Nullable IOException failure;

    /// Something to be written.
    private sealed interface Entry {
        void write(Encoder encoder) throws IOException;
    }

    private static final class State implements Entry {
        private final Snapshot now;
        private final String hash;
        private boolean dropped;

        State(Snapshot now, String hash) {
            this.now = now;
            this.hash = hash;
        }

        @Override
        public void write(Encoder encoder) throws IOException {
            if (!dropped) {
                encoder.state(now, hash);
            }
        }
    }

    private record Event(RunEvent event, String hash) implements Entry {
        @Override
        public void write(Encoder encoder) throws IOException {
            encoder.event(event, hash);
        }
    }

    private record Heard(Said said) implements Entry {
        @Override
        public void write(Encoder encoder) throws IOException {
            encoder.said(said);
        }
    }

    private record Minds(Duration time, Map<String, Mind.View> minds) implements Entry {
        @Override
        public void write(Encoder encoder) throws IOException {
            encoder.minds(time, minds);
        }
    }

    private Recorder(McapWriter file, Encoder encoder, Behind behind) {
        this.file = file;
        this.encoder = encoder;
        this.behind = behind;
        this.writer = Thread.ofPlatform().name("recorder").daemon().unstarted(this::write);
    }

    /// Begins a recording.
    ///
    /// @param force whether a file that is there may be lost
    /// @param clock real time, by which what is open grows old, in ns
    /// @throws java.nio.file.FileAlreadyExistsException when it is there and may not
    /// @throws IOException when it can't be written
    public static Recorder begin(Path path, boolean force, Origin origin, Behind behind, LongSupplier clock)
            throws IOException {
        var options = force
                ? Set.of(StandardOpenOption.WRITE, StandardOpenOption.CREATE, StandardOpenOption.TRUNCATE_EXISTING)
                : Set.of(StandardOpenOption.WRITE, StandardOpenOption.CREATE_NEW);
        FileChannel channel = FileChannel.open(path, options);
        try {
            var file = new McapWriter(channel, origin.program(), clock);
            var encoder = new Encoder(file, origin.start());
            origin.write(file);
            encoder.map(origin.plan().map());
            file.flush();
            var recorder = new Recorder(file, encoder, behind);
            recorder.writer.start();
            return recorder;
        } catch (IOException | RuntimeException e) {
            channel.close();
            throw e;
        }
    }

    @Override
    public Duration period() {
        return PERIOD;
    }

    @Override
    public void sees(Snapshot now, String hash) {
        lock.lock();
        try {
            while (behind == Behind.WAIT && states.size() >= MOST_STATES && failure == null) {
                changed.awaitUninterruptibly();
            }
            if (states.size() >= MOST_STATES) {
                states.removeFirst().dropped = true;
                dropped++;
            }
            var state = new State(now, hash);
            states.addLast(state);
            add(state);
        } finally {
            lock.unlock();
        }
    }

    @Override
    public void looksInto(Duration time, Map<String, Mind.View> minds) {
        if (!minds.isEmpty()) {
            tell(new Minds(time, Map.copyOf(minds)));
        }
    }

    @Override
    public void happened(RunEvent event, String hash) {
        tell(new Event(event, hash));
    }

    @Override
    public void heard(Said message) {
        tell(new Heard(message));
    }

    private void tell(Entry entry) {
        lock.lock();
        try {
            while (waiting.size() >= MOST_OTHERS && failure == null) {
                changed.awaitUninterruptibly();
            }
            add(entry);
        } finally {
            lock.unlock();
        }
    }

    /// Under the lock.
    private void add(Entry entry) {
        if (failure == null) {
            waiting.addLast(entry);
            changed.signalAll();
        }
    }

    /// The run has ended. To be called before [#close], for how it ended to be in the file.
    public void ended(RunResult how) {
        lock.lock();
        try {
            result = how;
        } finally {
            lock.unlock();
        }
    }

    /// States of the run that were not written as the file was too slow.
    public long dropped() {
        lock.lock();
        try {
            return dropped;
        } finally {
            lock.unlock();
        }
    }

    /// Why nothing more was written; empty while all is well.
    public Optional<IOException> failure() {
        lock.lock();
        try {
            return Optional.ofNullable(failure);
        } finally {
            lock.unlock();
        }
    }

    /// On the recorder's thread.
    private void write() {
        try (file) {
            for (Optional<Entry> next = take(); ; next = take()) {
                if (next.isPresent()) {
                    next.get().write(encoder);
                } else if (isOver()) {
                    break;
                }
                file.tick();
            }
            Outcome.write(file, Optional.ofNullable(result), dropped());
        } catch (IOException e) {
            fail(e);
        } catch (RuntimeException e) {
            fail(new IOException("Recording failed: " + e, e));
        }
    }

    /// The next; empty when there was none for a while, or it is over.
    private Optional<Entry> take() {
        lock.lock();
        try {
            long left = TICK;
            while (waiting.isEmpty() && !ending && left > 0) {
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

    private boolean isOver() {
        lock.lock();
        try {
            return ending && waiting.isEmpty();
        } finally {
            lock.unlock();
        }
    }

    private void fail(IOException why) {
        lock.lock();
        try {
            failure = why;
            waiting.clear();
            states.clear();
            changed.signalAll();
        } finally {
            lock.unlock();
        }
    }

    /// Writes what waits, and the end of the file; then it is whole. Closing twice does nothing.
    @Override
    public void close() {
        lock.lock();
        try {
            ending = true;
            changed.signalAll();
        } finally {
            lock.unlock();
        }
        try {
            writer.join();
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
    }
}
