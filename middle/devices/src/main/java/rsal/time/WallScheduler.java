package rsal.time;

import java.lang.System.Logger;
import java.lang.System.Logger.Level;
import java.time.Duration;
import java.time.Instant;
import java.util.Optional;
import java.util.PriorityQueue;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionStage;
import java.util.concurrent.Executor;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.concurrent.locks.Condition;
import java.util.concurrent.locks.ReentrantLock;
import java.util.function.Consumer;
import java.util.function.Supplier;
import org.jspecify.annotations.Nullable;

/// Real time, for real robots, or the time of another program. Tasks run on one thread of its own, a daemon, by time,
/// then [Phase], then the order in which they were scheduled; tasks that other threads hand in run between them, as
/// does what other threads run exclusively, which get their turns in no particular order.
///
/// Its time is that of the machine when it was made, plus what has passed since: it never jumps. Where it has a
/// [DrivenTime], it is that; what is handed in still runs at once, and what is scheduled [in real time][#inRealTime]
/// when that has come, also while the other time stands.
///
/// What a task throws goes to a handler; a periodic task lives on. It skips the beats that it missed. Unlike the
/// contract of [Scheduler] asks, all methods may be called on any thread. After [#close] nothing runs any more.
@AllowedToReadWallClock("It is where real time enters.")
public final class WallScheduler implements Scheduler, AutoCloseable {
    private static final Logger LOG = System.getLogger(WallScheduler.class.getName());

    private final ReentrantLock lock = new ReentrantLock();
    private final Condition changed = lock.newCondition();
    private final ReentrantLock turn =
            new ReentrantLock(); // of the thread that runs something; never wanted while `lock` is held
    private final Timeline real = new Timeline(new MachineTime());
    private final Timeline timeline; // the real one, or one that is driven
    private final Optional<DrivenTime> driven;
    private final Consumer<? super Throwable> onFailure;
    private final Executor workers;
    private final PhaseTimes times;
    private final Thread thread;
    private final AtomicInteger computing = new AtomicInteger(); // work whose result has not been delivered
    private long order;
    private Instant reached = Instant.EPOCH; // of the thread: the newest time at which nothing was left to do
    private volatile boolean closed; // written while `lock` is held

    /// @param name of its thread (`run-1`)
    /// @param workers where [#compute] runs; not shared with tasks that wait
    /// @param onFailure told what a task threw, on the thread that ran it
    public WallScheduler(String name, Executor workers, Consumer<? super Throwable> onFailure) {
        this(name, workers, onFailure, PhaseTimes.none());
    }

    /// @param times told what phases take; what other threads run exclusively counts as [Phase#THINK], what they hand
    /// in as [Phase#WORLD]
    public WallScheduler(String name, Executor workers, Consumer<? super Throwable> onFailure, PhaseTimes times) {
        this(name, workers, onFailure, times, Optional.empty());
    }

    /// @param driven the time that it follows; empty for that of the machine
    public WallScheduler(
            String name,
            Executor workers,
            Consumer<? super Throwable> onFailure,
            PhaseTimes times,
            Optional<DrivenTime> driven) {
        this.workers = workers;
        this.onFailure = onFailure;
        this.times = times;
        this.driven = driven;
        this.timeline = driven.map(Timeline::new).orElse(real);
        driven.ifPresent(time -> time.onChange(this::look));
        this.thread = Thread.ofPlatform().daemon().name(name).start(this::work);
    }

    /// Logs what tasks throw.
    public WallScheduler(String name, Executor workers) {
        this(name, workers, e -> LOG.log(Level.ERROR, () -> "A task of '%s' failed.".formatted(name), e));
    }

    @Override
    public Instant instant() {
        return timeline.source.instant();
    }

    @Override
    public Scheduler inRealTime() {
        return timeline.equals(real) ? this : new RealTime();
    }

    @Override
    public void execute(Runnable task) {
        timeline.after(0, Phase.WORLD, task);
    }

    @Override
    public void exclusively(Runnable task) {
        run(Phase.THINK, task);
    }

    @Override
    public Task after(Duration delay, Phase phase, Runnable task) {
        return timeline.after(delay.toNanos(), phase, task);
    }

    @Override
    public Task every(Duration period, Phase phase, Runnable task) {
        return timeline.every(period, phase, task);
    }

    @Override
    public <T> CompletionStage<T> compute(Supplier<T> work) {
        var result = new CompletableFuture<T>();
        computing.incrementAndGet();
        workers.execute(() -> {
            try {
                T value = work.get();
                deliver(() -> result.complete(value));
            } catch (RuntimeException | Error e) {
                deliver(() -> result.completeExceptionally(e));
            }
        });
        return result;
    }

    private void deliver(Runnable completion) {
        execute(() -> {
            computing.decrementAndGet();
            completion.run();
        });
    }

    /// Ends its thread once the task that runs now is over, and waits for that unless it is called by that task.
    /// Closing twice does nothing. What wants to run exclusively afterwards is dropped.
    @Override
    public void close() {
        lock.lock();
        try {
            closed = true;
            timeline.due.clear();
            real.due.clear();
            changed.signalAll();
        } finally {
            lock.unlock();
        }
        if (!turn.isHeldByCurrentThread()) {
            boolean interrupted = false;
            while (thread.isAlive()) {
                try {
                    thread.join();
                } catch (InterruptedException _) {
                    interrupted = true;
                }
            }
            run(Phase.WORLD, () -> {}); // the thread that runs something exclusively is done with it by then
            if (interrupted) {
                Thread.currentThread().interrupt();
            }
        }
    }

    private void work() {
        for (Entry next = take(); next != null; next = take()) {
            run(next.phase, next::runUnlessCancelled);
        }
    }

    private void run(Phase phase, Runnable task) {
        turn.lock();
        boolean whole = turn.getHoldCount() == 1; // else it is part of a task, whose time it is
        if (whole) {
            times.begin();
        }
        try {
            if (!closed) {
                task.run();
            }
        } catch (RuntimeException | Error e) {
            report(e);
        } finally {
            if (whole) {
                times.ran(phase);
            }
            turn.unlock();
        }
    }

    private void report(Throwable failure) {
        try {
            onFailure.accept(failure);
        } catch (RuntimeException | Error e) {
            LOG.log(Level.ERROR, "The handler of failures failed itself.", e);
        }
    }

    /// The next task, when its time has come.
    private @Nullable Entry take() {
        lock.lock();
        try {
            while (!closed) {
                Optional<Entry> nothingLeft = arrival(); // before it is known whether something is left
                Entry next = real.poll(); // first, as it keeps motors safe
                if (next == null) {
                    next = timeline.poll();
                }
                if (next == null && nothingLeft.isPresent()) {
                    next = nothingLeft.get();
                }
                if (next != null) {
                    return next;
                }
                try {
                    changed.awaitNanos(real.untilDue());
                } catch (InterruptedException _) {
                    // a task left its thread interrupted; only close ends it
                }
            }
            return null;
        } finally {
            lock.unlock();
        }
    }

    /// Says that all is done that was due by the newest time, if it is a new one and nobody computes.
    private Optional<Entry> arrival() {
        return driven.filter(time -> computing.get() == 0 && time.instant().isAfter(reached))
                .map(time -> {
                    Instant now = time.instant();
                    return new Entry(0, Phase.OBSERVE, 0, () -> {
                        reached = now;
                        time.reached(now);
                    });
                });
    }

    /// The time that it follows has changed.
    private void look() {
        lock.lock();
        try {
            changed.signalAll();
        } finally {
            lock.unlock();
        }
    }

    /// What is due by one source of time. All but [#after] and [#every] while `lock` is held.
    private final class Timeline {
        private final TimeSource source;
        private final PriorityQueue<Entry> due = new PriorityQueue<>();

        Timeline(TimeSource source) {
            this.source = source;
        }

        Task after(long nanos, Phase phase, Runnable task) {
            return add(new Entry(Math.addExact(source.nanos(), Math.max(0, nanos)), phase, 0, task));
        }

        Task every(Duration period, Phase phase, Runnable task) {
            long step = period.toNanos();
            if (step <= 0) {
                throw new IllegalArgumentException("A period must be positive, not '%s'.".formatted(period));
            }
            return add(new Entry(Math.addExact(source.nanos(), step), phase, step, task));
        }

        private Task add(Entry entry) {
            lock.lock();
            try {
                if (!closed) {
                    entry.order = order++;
                    due.add(entry);
                    if (due.peek() == entry) { // else its thread sleeps no longer than it should
                        changed.signalAll();
                    }
                }
            } finally {
                lock.unlock();
            }
            return entry;
        }

        /// By this source; 0 or less when something is due [ns].
        long untilDue() {
            Entry next = due.peek();
            return next == null ? Long.MAX_VALUE : next.nanos - source.nanos();
        }

        /// The next task, if its time has come; a periodic one is put back for its next beat.
        @Nullable
        Entry poll() {
            while (untilDue() <= 0) {
                Entry next = due.remove();
                if (next.cancelled) {
                    continue;
                }
                if (next.step > 0) {
                    long missed = Math.max(0, (source.nanos() - next.nanos) / next.step);
                    next.nanos += (missed + 1) * next.step;
                    next.order = order++;
                    due.add(next);
                }
                return next;
            }
            return null;
        }
    }

    /// The same by the machine's time.
    private final class RealTime implements Scheduler {
        @Override
        public Instant instant() {
            return real.source.instant();
        }

        @Override
        public Object run() {
            return WallScheduler.this.run();
        }

        @Override
        public void execute(Runnable task) {
            WallScheduler.this.execute(task);
        }

        @Override
        public void exclusively(Runnable task) {
            WallScheduler.this.exclusively(task);
        }

        @Override
        public Task after(Duration delay, Phase phase, Runnable task) {
            return real.after(delay.toNanos(), phase, task);
        }

        @Override
        public Task every(Duration period, Phase phase, Runnable task) {
            return real.every(period, phase, task);
        }

        @Override
        public <T> CompletionStage<T> compute(Supplier<T> work) {
            return WallScheduler.this.compute(work);
        }
    }

    /// That of the machine when it was made, plus what has passed since on the clock that nobody sets.
    private static final class MachineTime implements TimeSource {
        private final Instant start = Instant.now();
        private final long startNanos = System.nanoTime();

        @Override
        public long nanos() {
            return System.nanoTime() - startNanos;
        }

        @Override
        public Instant instant() {
            return start.plusNanos(nanos());
        }
    }

    private static final class Entry implements Task, Comparable<Entry> {
        private final Phase phase;
        private final long step;
        private final Runnable task;
        private long nanos;
        private long order;
        private volatile boolean cancelled;

        Entry(long nanos, Phase phase, long step, Runnable task) {
            this.nanos = nanos;
            this.phase = phase;
            this.step = step;
            this.task = task;
        }

        /// The one that had the turn before may have cancelled it.
        void runUnlessCancelled() {
            if (!cancelled) {
                task.run();
            }
        }

        @Override
        public void cancel() {
            cancelled = true;
        }

        @Override
        public int compareTo(Entry other) {
            int byTime = Long.compare(nanos, other.nanos);
            int byPhase = byTime != 0 ? byTime : phase.compareTo(other.phase);
            return byPhase != 0 ? byPhase : Long.compare(order, other.order);
        }
    }
}
