package rsal.python;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.List;
import java.util.Optional;
import rsal.agent.RunPreparation;

/// Processes of Python that are started before a run needs one, as long as many runs are to come. Each has loaded numpy
/// and RSAL's modules, and no file of an agent. It has the agents of one run only: what a module keeps is never there
/// in the next run.
///
/// No process is started ahead before the first run has needed one. Safe for any thread.
final class ProcessesAhead {
    private static final List<Many> PREPARED = new ArrayList<>(); // guarded by the class
    private static final Deque<PythonProcess> READY = new ArrayDeque<>(); // guarded by the class
    private static int begun; // processes that are being started; guarded by the class

    /// Runs that are to come.
    private static final class Many implements RunPreparation {
        private final int atOnce;
        private int left;

        Many(int atOnce, int left) {
            this.atOnce = atOnce;
            this.left = left;
        }

        @Override
        public void close() {
            forget(this);
        }
    }

    private ProcessesAhead() {}

    static synchronized RunPreparation prepare(int atOnce, int inAll) {
        var many = new Many(atOnce, inAll);
        PREPARED.add(many);
        return many;
    }

    private static synchronized void forget(Many many) {
        PREPARED.remove(many);
        while (READY.size() > wanted()) {
            READY.removeLast().close(0);
        }
    }

    /// How many processes may be ready. On the lock.
    private static int wanted() {
        return PREPARED.stream()
                .mapToInt(many -> Math.clamp(many.left, 0, many.atOnce))
                .sum();
    }

    /// One for a run: a process that was started ahead, or a new one.
    ///
    /// @throws PythonFailure when there is no Python that could be started
    static PythonProcess take() {
        return poll().filter(PythonProcess::isAlive).orElseGet(PythonProcess::new);
    }

    private static synchronized Optional<PythonProcess> poll() {
        if (!PREPARED.isEmpty()) {
            PREPARED.getFirst().left--;
        }
        return Optional.ofNullable(READY.pollFirst());
    }

    /// Starts those for the next runs, when the processor is not needed to start one for this run. Returns at once.
    static synchronized void startNext() {
        if (READY.size() + begun < wanted()) {
            Thread.ofPlatform().daemon().name("python-ahead").start(ProcessesAhead::startAll);
        }
    }

    private static void startAll() {
        while (begin()) {
            Optional<PythonProcess> started = Optional.empty();
            try {
                started = Optional.of(new PythonProcess()); // not on the lock
            } catch (PythonFailure _) {
                return; // a run that needs one says why
            } finally {
                begun(started);
            }
        }
    }

    private static synchronized boolean begin() {
        boolean isWanted = READY.size() + begun < wanted();
        begun += isWanted ? 1 : 0;
        return isWanted;
    }

    private static synchronized void begun(Optional<PythonProcess> started) {
        begun--;
        started.ifPresent(process -> {
            if (READY.size() < wanted()) {
                READY.add(process);
            } else {
                process.close(0); // the runs are over
            }
        });
    }

    /// For tests.
    static synchronized int ready() {
        return READY.size();
    }
}
