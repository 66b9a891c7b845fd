package rsal.python;

import java.time.Instant;
import java.util.HashMap;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.ConcurrentHashMap;
import rsal.time.LockstepScheduler;

/// The process of Python in which all agents in Python of one run live. It starts with the first of them and ends with
/// the last.
///
/// In simulated time the run's thread waits for it, in the turn of the agent, so that equal runs are equal. In real
/// time a thread of its own does, the [Postman]. One thread at a time exchanges frames.
final class PythonWorker {
    private static final int GRACE = 2; // s; of a process that still has something to do in real time

    /// By what tells runs apart. Processes of several runs start side by side.
    private static final Map<Object, PythonWorker> BY_RUN = new ConcurrentHashMap<>();

    private final Object run;
    private final PythonProcess process;
    private final PythonTurns turns;
    private final Optional<Postman> postman;
    private volatile Optional<Instant> turnBegan = Optional.empty();
    private int agents; // that live in it; changed where BY_RUN is computed
    private final Map<Integer, String> names = new HashMap<>(); // of all that ever did, by number; guarded by itself

    private PythonWorker(Object run) {
        this.run = run;
        this.process = ProcessesAhead.take();
        this.turns = new PythonTurns(process);
        this.postman = run instanceof LockstepScheduler ? Optional.empty() : Optional.of(new Postman(this));
    }

    /// The one of a run, for one more agent.
    ///
    /// @param run what tells runs apart
    /// @throws PythonFailure when there is no Python that could have it
    static PythonWorker enter(Object run) {
        PythonWorker worker = BY_RUN.compute(run, (_, known) -> {
            PythonWorker its = known == null ? new PythonWorker(run) : known;
            its.agents++;
            return its;
        });
        try {
            if (worker.process.greet()) { // not on the lock: other runs start theirs meanwhile
                ProcessesAhead.startNext();
            }
            return worker;
        } catch (RuntimeException e) {
            worker.leave();
            throw e;
        }
    }

    /// One agent less.
    void leave() {
        boolean isEmpty = BY_RUN.compute(run, (_, _) -> --agents == 0 ? null : this) == null;
        if (isEmpty) {
            postman.ifPresent(Postman::close);
            process.close(postman.isEmpty() ? 0 : GRACE);
        }
    }

    /// A number for an agent, of no other one.
    int number(String name) {
        synchronized (names) {
            int number = names.size() + 1;
            names.put(number, name);
            return number;
        }
    }

    /// On the thread that exchanges frames: in simulated time the run's, else the postman's.
    PythonTurns turns() {
        return turns;
    }

    /// What brings events in real time; empty in simulated time.
    Optional<Postman> postman() {
        return postman;
    }

    /// In real time, an event is brought now.
    void begin(Instant now) {
        turnBegan = Optional.of(now);
    }

    void end() {
        turnBegan = Optional.empty();
    }

    /// When the event was brought that Python deals with now; empty for none. May be asked on any thread.
    Optional<Instant> turnBegan() {
        return turnBegan;
    }

    /// Python gets no more events: its process ends.
    void hangUp() {
        process.hangUp();
    }

    /// Ends the process: code in it never returns. All its agents fail. May be called on any thread.
    void kill() {
        process.kill();
    }

    /// Where Python is, when a turn takes more than a second, for one of its agents. Another one may be the reason. May
    /// be asked on any thread.
    Optional<String> place(int agent) {
        return process.place().map(place -> {
            synchronized (names) {
                return place.agent() == agent || place.agent() == 0
                        ? place.words()
                        : "%s of agent '%s'".formatted(place.words(), names.get(place.agent()));
            }
        });
    }

    /// Whether somebody looks into Python with a debugger. May be asked on any thread.
    boolean isDebugged() {
        return process.isDebugged();
    }
}
