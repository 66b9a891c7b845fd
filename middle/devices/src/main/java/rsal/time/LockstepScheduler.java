package rsal.time;

import java.time.Duration;
import java.time.Instant;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.List;
import java.util.PriorityQueue;
import java.util.Queue;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionStage;
import java.util.concurrent.ConcurrentLinkedQueue;
import java.util.concurrent.Executor;
import java.util.concurrent.FutureTask;
import java.util.function.Supplier;
import org.jspecify.annotations.Nullable;

/// Simulated time. It stands still while tasks run, then jumps to the next: tasks run by time, then [Phase], then
/// the order in which they were scheduled. Same tasks, same order, however many workers there are and however
/// fast it is driven.
///
/// The thread that calls [#advance] is the run's thread. Tasks that other threads hand in by [#execute] run at
/// the beginning of the next advance, before time moves; those that the run's own thread hands in run at the same
/// instant, after the task that did.
public final class LockstepScheduler implements Scheduler {
    private final PriorityQueue<Entry> due = new PriorityQueue<>();
    private final Queue<Runnable> fromOutside = new ConcurrentLinkedQueue<>();
    private final ArrayDeque<Runnable> next = new ArrayDeque<>();
    private final List<FutureTask<Runnable>> work = new ArrayList<>();
    private final ArrayDeque<FutureTask<Runnable>> done = new ArrayDeque<>(); // but not completed
    private final Executor workers;
    private final PhaseTimes times;
    private final Instant start;
    private volatile Instant now;
    private volatile @Nullable Thread thread; // none before the first advance: who made it may not be who runs it
    private long nanos;
    private long order;

    /// @param workers where [#compute] runs; `Runnable::run` for one thread
    public LockstepScheduler(Instant start, Executor workers) {
        this(start, workers, PhaseTimes.none());
    }

    /// @param times told what phases take; what other threads handed in counts as the first phase after it
    public LockstepScheduler(Instant start, Executor workers, PhaseTimes times) {
        this.start = start;
        this.now = start;
        this.workers = workers;
        this.times = times;
    }

    /// Starts at the epoch and computes on the caller's thread.
    public LockstepScheduler() {
        this(Instant.EPOCH, Runnable::run);
    }

    @Override
    public Instant instant() {
        return now;
    }

    /// Time since the start.
    public Duration elapsed() {
        return Duration.between(start, now);
    }

    @Override
    public void execute(Runnable task) {
        if (Thread.currentThread().equals(thread)) {
            next.add(task);
        } else {
            fromOutside.add(task);
        }
    }

    @Override
    public Task after(Duration delay, Phase phase, Runnable task) {
        return add(new Entry(Math.addExact(nanos, Math.max(0, delay.toNanos())), phase, 0, task));
    }

    @Override
    public Task every(Duration period, Phase phase, Runnable task) {
        long step = period.toNanos();
        if (step <= 0) {
            throw new IllegalArgumentException("A period must be positive, not '%s'.".formatted(period));
        }
        return add(new Entry(Math.addExact(nanos, step), phase, step, task));
    }

    @Override
    public <T> CompletionStage<T> compute(Supplier<T> supplier) {
        var result = new CompletableFuture<T>();
        work.add(new FutureTask<>(() -> {
            try {
                T value = supplier.get();
                return () -> result.complete(value);
            } catch (RuntimeException | Error e) {
                return () -> result.completeExceptionally(e);
            }
        }));
        return result;
    }

    /// Runs everything that is due within a time from now, then stands there. Only tasks' exceptions end it
    /// early; the task that threw is gone, all others stay.
    public void advance(Duration by) {
        long until = Math.addExact(nanos, by.toNanos());
        times.begin();
        while (step(until)) {
            // each step is one instant
        }
        moveTo(until);
    }

    /// Goes to the next instant at which something is due, if that is not after a time from now, and runs what is
    /// due there. Otherwise goes that far.
    ///
    /// @return whether something was due
    public boolean advanceToNext(Duration atMost) {
        long until = Math.addExact(nanos, atMost.toNanos());
        times.begin();
        boolean ran = step(until);
        if (!ran) {
            moveTo(until);
        }
        return ran;
    }

    /// Runs what other threads handed in, without time passing: for a run that is paused.
    public void runPending() {
        thread = Thread.currentThread();
        for (Runnable task = fromOutside.poll(); task != null; task = fromOutside.poll()) {
            task.run();
        }
        settle();
    }

    /// Forgets all that is due or was handed in: for a run that has no memory left for it.
    public void drop() {
        due.clear();
        fromOutside.clear();
        next.clear();
        work.clear();
        done.clear();
    }

    private boolean step(long until) {
        runPending();
        Entry first = due.peek();
        if (first == null || first.nanos > until) {
            return false;
        }
        moveTo(first.nanos);
        while (first != null && first.nanos == nanos) {
            runPhase(first.phase);
            times.ran(first.phase);
            first = due.peek();
        }
        return true;
    }

    /// Runs what is due in a phase now, then the work that it handed in, until neither is left.
    private void runPhase(Phase phase) {
        Entry entry = due.peek();
        while (entry != null && entry.nanos == nanos && entry.phase.compareTo(phase) <= 0) {
            due.remove();
            if (entry.step > 0 && !entry.cancelled) {
                entry.nanos += entry.step;
                entry.order = order++;
                due.add(entry);
            }
            if (!entry.cancelled) {
                entry.task.run();
                runNext();
            }
            entry = due.peek();
        }
        settle();
    }

    private void runNext() {
        for (Runnable task = next.poll(); task != null; task = next.poll()) {
            task.run();
        }
    }

    private void settle() {
        runNext();
        while (!work.isEmpty() || !done.isEmpty()) {
            runWork();
            while (!done.isEmpty()) {
                completion(done.remove()).run();
                runNext();
            }
        }
    }

    private void runWork() {
        var batch = List.copyOf(work);
        work.clear();
        if (batch.size() > 1) { // one alone is not worth a hand-over
            batch.forEach(workers::execute);
        }
        batch.forEach(FutureTask::run); // helps: each runs only once, here or there
        done.addAll(batch);
    }

    private static Runnable completion(FutureTask<Runnable> done) {
        boolean interrupted = false;
        try {
            while (true) {
                try {
                    return done.get();
                } catch (InterruptedException _) {
                    interrupted = true; // the work is short and must be finished
                } catch (java.util.concurrent.ExecutionException e) {
                    throw new AssertionError("Work keeps its own exceptions.", e);
                }
            }
        } finally {
            if (interrupted) {
                Thread.currentThread().interrupt();
            }
        }
    }

    private void moveTo(long to) {
        if (to != nanos) {
            nanos = to;
            now = start.plusNanos(to);
        }
    }

    private Entry add(Entry entry) {
        entry.order = order++;
        due.add(entry);
        return entry;
    }

    private static final class Entry implements Task, Comparable<Entry> {
        private final Phase phase;
        private final long step;
        private final Runnable task;
        private long nanos;
        private long order;
        private boolean cancelled;

        Entry(long nanos, Phase phase, long step, Runnable task) {
            this.nanos = nanos;
            this.phase = phase;
            this.step = step;
            this.task = task;
        }

        @Override
        public void cancel() {
            cancelled = true;
        }

        /// By time, then phase, then the order in which they were scheduled. As most of a run's tasks are due at the
        /// same
        /// times, it is asked often.
        @Override
        public int compareTo(Entry other) {
            if (nanos != other.nanos) {
                return Long.compare(nanos, other.nanos);
            }
            return phase == other.phase ? Long.compare(order, other.order) : phase.compareTo(other.phase);
        }
    }
}
