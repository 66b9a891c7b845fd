package rsal.experiment;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.util.HashSet;
import java.util.Map;
import java.util.Queue;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.ConcurrentLinkedQueue;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.atomic.AtomicReference;
import java.util.function.Consumer;
import java.util.stream.Collectors;
import org.jspecify.annotations.Nullable;
import rsal.agent.RunPreparation;
import rsal.engine.LiveRun;
import rsal.engine.RunBuilder;
import rsal.engine.report.RunBroken;
import rsal.engine.report.RunResult;
import rsal.experiment.Recordings.Recording;
import rsal.scenario.RunPlan;
import rsal.settings.InvalidSettings;
import rsal.settings.Location;

/// Does the runs of an experiment that have no row yet, several at once. That changes nothing in them, as
/// their time is simulated: each is what it would be alone. What goes wrong in one becomes its row, and the
/// others go on.
///
/// Runs go on in threads of their own; a thread in which an agent never returns is left behind when the run
/// is given up.
public final class SweepRun implements AutoCloseable {
    private final Sweep sweep;
    private final SweepFolder folder;
    private final int jobs;
    private final int cores;
    private final Recordings recordings;
    private final Consumer<? super Row> listener;
    private final Queue<Trial> waiting = new ConcurrentLinkedQueue<>();
    private final Set<LiveRun> inProgress = ConcurrentHashMap.newKeySet();
    private final AtomicReference<@Nullable Throwable> failure = new AtomicReference<>();
    private volatile boolean closed;

    /// With all cores of the machine, unrecorded.
    ///
    /// @param jobs how many runs at once
    /// @param listener told of each row once it is on the disk, by one thread at a time; must be quick
    public SweepRun(Sweep sweep, SweepFolder folder, int jobs, Consumer<? super Row> listener) {
        this(sweep, folder, jobs, Runtime.getRuntime().availableProcessors(), Recordings.NONE, listener);
    }

    /// @param jobs how many runs at once
    /// @param cores how many of them the runs may keep busy in all; a run takes one at least
    /// @param listener told of each row once it is on the disk, by one thread at a time; must be quick
    public SweepRun(
            Sweep sweep,
            SweepFolder folder,
            int jobs,
            int cores,
            Recordings recordings,
            Consumer<? super Row> listener) {
        this.sweep = sweep;
        this.folder = folder;
        this.jobs = jobs;
        this.cores = cores;
        this.recordings = recordings;
        this.listener = listener;
        var done = new HashSet<Integer>();
        folder.rows().forEach(row -> done.add(row.run()));
        sweep.trials().stream().filter(trial -> !done.contains(trial.number())).forEach(waiting::add);
    }

    /// How many runs are still to be done.
    public int left() {
        return waiting.size() + inProgress.size();
    }

    /// Does one of the runs again that have a row, the quickest. When it comes out otherwise, something has
    /// changed of which the scenario's text says nothing: an agent, a map, RSAL.
    ///
    /// @throws InvalidSettings when it does
    /// @throws InterruptedException when this thread is
    public void checkRepeatable() throws InterruptedException {
        Row quickest = null;
        for (Row row : folder.rows()) {
            if (!row.isBroken() && (quickest == null || seconds(row) < seconds(quickest))) {
                quickest = row;
            }
        }
        if (quickest == null) {
            return;
        }
        Row again = row(sweep.trials().get(quickest.run() - 1), Recordings.NONE);
        if (!closed && !again.eventHash().equals(quickest.eventHash())) {
            throw new InvalidSettings(
                    Location.of("--resume"),
                    "Run '%d' has another result now: its event hash was %s and is %s."
                            .formatted(
                                    quickest.run(),
                                    shortened(quickest.eventHash()),
                                    again.isBroken() ? again.reason() : shortened(again.eventHash())),
                    "Something that it uses has changed since: an agent, a map, or RSAL itself. Start a new sweep in another folder.");
        }
    }

    private static double seconds(Row row) {
        return row.wallSeconds().orElse(Double.POSITIVE_INFINITY);
    }

    private static String shortened(String hash) {
        return hash.substring(0, Math.min(8, hash.length()));
    }

    /// Does all runs, and returns when they have ended or this is closed.
    ///
    /// @throws InterruptedException when this thread is; the runs are given up
    /// @throws UncheckedIOException when a row or a recording can't be written; the runs under way are given up
    public void run() throws InterruptedException {
        RunPreparation preparation = RunPreparation.of(jobs, waiting.size());
        var ended = new CountDownLatch(jobs);
        for (int i = 1; i <= jobs; i++) {
            Thread.ofPlatform().daemon().name("sweep-" + i).start(() -> {
                try {
                    work();
                } catch (InterruptedException | RuntimeException | Error e) {
                    failure.compareAndSet(null, e);
                    close();
                } finally {
                    ended.countDown();
                }
            });
        }
        try {
            ended.await();
        } finally {
            close();
            preparation.close();
        }
        switch (failure.get()) {
            case null -> {}
            case RuntimeException e -> throw e;
            case Error e -> throw e;
            case Throwable e -> throw new IllegalStateException("A worker was interrupted.", e);
        }
        if (folder.rows().size() == sweep.trials().size()) {
            folder.complete();
        }
    }

    private void work() throws InterruptedException {
        for (Trial next = waiting.poll(); next != null && !closed; next = waiting.poll()) {
            Row row = row(next, recordings);
            synchronized (this) {
                if (closed) { // it ended because of that
                    return;
                }
                folder.append(row);
                listener.accept(row);
            }
        }
    }

    private Row row(Trial trial, Recordings recorded) throws InterruptedException {
        Map<String, Object> arguments = sweep.arguments(trial.combination());
        RunPlan plan;
        try {
            plan = sweep.plan(trial);
        } catch (InvalidSettings e) {
            return Row.broken(
                    trial,
                    arguments,
                    e.problems().stream().map(p -> p.message()).collect(Collectors.joining(" ")));
        } catch (RuntimeException | OutOfMemoryError e) {
            return Row.broken(trial, arguments, reason(e));
        }
        try (Recording recording = recorded.begin(trial, plan)) {
            return row(trial, plan, recording);
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    private Row row(Trial trial, RunPlan plan, Recording recording) throws InterruptedException {
        Map<String, Object> arguments = sweep.arguments(trial.combination());
        RunBuilder builder = LiveRun.of(plan).helpers(Math.max(1, cores / jobs));
        recording.observer().ifPresent(builder::observer);
        try (LiveRun run = builder.start()) {
            inProgress.add(run);
            try {
                if (closed) {
                    run.stop();
                }
                RunResult result = run.result().toCompletableFuture().get();
                recording.ended(result);
                return Row.of(trial, plan.arguments(), result);
            } finally {
                inProgress.remove(run);
            }
        } catch (ExecutionException e) {
            return Row.broken(trial, arguments, reason(e.getCause()));
        } catch (OutOfMemoryError e) {
            return Row.broken(trial, arguments, reason(e));
        }
    }

    private static String reason(@Nullable Throwable cause) {
        if (cause != null && RunBroken.lackOfMemory(cause).isPresent()) {
            return "There was not enough memory. Maybe fewer --jobs, or more memory: JAVA_TOOL_OPTIONS=-Xmx4g.";
        }
        return cause instanceof RunBroken ? String.valueOf(cause.getMessage()) : String.valueOf(cause);
    }

    /// Ends the runs under way without a row, and begins no more. Any thread may do so; nothing happens the
    /// second time.
    @Override
    public synchronized void close() {
        closed = true;
        waiting.clear();
        inProgress.forEach(LiveRun::stop);
    }
}
