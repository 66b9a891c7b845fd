package rsal.python;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.lang.System.Logger;
import java.lang.System.Logger.Level;
import java.nio.charset.StandardCharsets;
import java.util.ArrayDeque;
import java.util.Deque;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.TimeUnit;
import org.jspecify.annotations.Nullable;
import rsal.agent.Agent;
import rsal.frame.FramePipe;
import rsal.time.LockstepScheduler;

/// The process of Python in which all agents in Python of one run live. It starts with the first of them and ends with
/// the last.
///
/// In simulated time the run's thread waits for it, in the turn of the agent, so that equal runs are equal. In real
/// time a thread of its own does, the [Postman]. One thread at a time exchanges frames.
final class PythonWorker {
    private static final Logger LOG = System.getLogger(Agent.class.getName());
    private static final String NOTICE = "\u0001"; // begins lines on stderr that are for us
    private static final int LAST_WORDS = 12; // lines
    private static final int GRACE = 2; // s; of a process that is told to end

    /// By what tells runs apart. Guarded by itself.
    private static final Map<Object, PythonWorker> BY_RUN = new HashMap<>();

    private final Object run;
    private final Process process;
    private final FramePipe frames;
    private final Thread errors;
    private final Deque<String> said = new ArrayDeque<>(); // on stderr, the last lines; guarded by itself
    private final Optional<Postman> postman;
    private int agents; // that live in it; guarded by BY_RUN
    private int numbers; // that were given to agents; guarded by BY_RUN
    private volatile @Nullable String place; // of a turn that takes long
    private volatile boolean debugged;
    private boolean busy; // in simulated time; of the run's thread
    private volatile @Nullable String dead; // why it ended

    /// What Python asks for in an agent's turn.
    interface Peer {
        /// Does what needs no answer.
        ///
        /// @param asked verbs with their arguments, in order
        void perform(List<?> asked);

        /// @return what Python gets as an answer
        /// @throws RuntimeException what Python gets as an [IllegalArgumentException] of its own
        @Nullable
        Object answer(List<?> asked);
    }

    private PythonWorker(Object run) {
        this.run = run;
        try {
            this.process = Interpreter.start("process");
        } catch (IOException e) {
            throw new PythonFailure("Python can't be run: %s.".formatted(e.getMessage()));
        }
        this.frames = new FramePipe(process.getInputStream(), process.getOutputStream());
        this.errors = Thread.ofPlatform().daemon().name("python-errors").start(this::readErrors);
        try {
            Map<?, ?> hello = frames.read();
            if (hello.get("error") instanceof String why) {
                throw new PythonFailure(why);
            }
            if (!Integer.valueOf(FramePipe.VERSION).equals(hello.get("protocol"))
                    || !"little".equals(hello.get("order"))) {
                throw new PythonFailure("The Python package is not of this version of RSAL: %s.".formatted(hello));
            }
        } catch (IOException _) {
            throw ended();
        }
        this.postman = run instanceof LockstepScheduler ? Optional.empty() : Optional.of(new Postman(this));
    }

    /// The one of a run, for one more agent.
    ///
    /// @param run what tells runs apart
    static PythonWorker enter(Object run) {
        synchronized (BY_RUN) {
            PythonWorker worker = BY_RUN.computeIfAbsent(run, PythonWorker::new);
            worker.agents++;
            return worker;
        }
    }

    /// One agent less.
    void leave() {
        synchronized (BY_RUN) {
            agents--;
            if (agents == 0) {
                BY_RUN.remove(run, this);
                postman.ifPresent(Postman::close);
                close();
            }
        }
    }

    /// A number for an agent, of no other one.
    int number() {
        synchronized (BY_RUN) {
            numbers++;
            return numbers;
        }
    }

    /// What brings events in real time; empty in simulated time.
    Optional<Postman> postman() {
        return postman;
    }

    /// Tells the process to end, and ends it if it does not. Returns at once.
    private void close() {
        Thread.ofPlatform().daemon().name("python-end").start(this::endProcess);
    }

    private void endProcess() {
        try {
            if (postman.isEmpty() || !process.waitFor(GRACE, TimeUnit.SECONDS)) {
                process.getOutputStream().close();
            }
            if (!process.waitFor(GRACE, TimeUnit.SECONDS)) {
                process.destroyForcibly();
            }
        } catch (IOException _) {
            process.destroyForcibly();
        } catch (InterruptedException _) {
            process.destroyForcibly();
            Thread.currentThread().interrupt();
        }
    }

    /// Python gets no more events: its process ends.
    void hangUp() {
        try {
            process.getOutputStream().close();
        } catch (IOException _) {
            process.destroyForcibly();
        }
    }

    /// Sends an event, and does what Python asks for until its turn is over.
    ///
    /// @throws PythonFailure when the agent has failed, or the process has
    void exchange(FramePipe.Content event, Peer peer) {
        String gone = dead;
        if (gone != null) {
            throw new PythonFailure(gone);
        }
        try {
            busy = postman.isEmpty();
            place = null;
            frames.write(event);
            RuntimeException refused = null;
            while (true) {
                Map<?, ?> words = frames.read();
                try {
                    if (refused == null) {
                        peer.perform(FromWords.list(words.get("do")));
                    }
                } catch (RuntimeException e) {
                    refused = e;
                }
                if (words.get("ask") instanceof List<?> question) {
                    answer(question, refused, peer);
                } else if (refused != null) {
                    throw refused;
                } else if (words.get("failed") instanceof Map<?, ?> failure) {
                    throw PythonFailure.of(failure);
                } else {
                    return;
                }
            }
        } catch (IOException _) {
            throw ended();
        } finally {
            busy = false;
        }
    }

    /// Whether the run's thread exchanges frames now: another event has to come after that. On the run's thread.
    boolean isBusy() {
        return busy;
    }

    private void answer(List<?> question, @Nullable RuntimeException refused, Peer peer) throws IOException {
        Object value = null;
        RuntimeException why = refused;
        if (why == null) {
            try {
                value = peer.answer(question);
            } catch (RuntimeException e) {
                why = e;
            }
        }
        Object answer = value;
        String error = why == null ? null : String.valueOf(why.getMessage());
        frames.write(to -> {
            if (error != null) {
                to.put("error", error);
            } else {
                to.put("value", Optional.ofNullable(answer));
            }
        });
    }

    /// An agent has ended: nothing of it is needed any more.
    void forget(int agent) {
        if (dead == null) {
            try {
                frames.write(to -> to.put("agent", agent).put("end", true));
            } catch (IOException _) {
                ended(); // the other agents learn that at their next turns
            }
        }
    }

    /// Why the process is no more, with its last words.
    private PythonFailure ended() {
        String why = dead;
        if (why == null) {
            try {
                process.getOutputStream().close();
            } catch (IOException _) {
                // it can't be told anything any more
            }
            why = "Python ended%s.%s".formatted(exitCode(), lastWords());
            dead = why;
        }
        return new PythonFailure(why);
    }

    private String exitCode() {
        try {
            if (process.waitFor(GRACE, TimeUnit.SECONDS)) {
                errors.join(TimeUnit.SECONDS.toMillis(GRACE));
                return " with code " + process.exitValue();
            }
        } catch (InterruptedException _) {
            Thread.currentThread().interrupt();
        }
        process.destroyForcibly();
        return "";
    }

    private String lastWords() {
        synchronized (said) {
            return said.isEmpty() ? "" : " Its last words: " + String.join(" | ", said);
        }
    }

    private void readErrors() {
        try (var lines = new BufferedReader(new InputStreamReader(process.getErrorStream(), StandardCharsets.UTF_8))) {
            for (String line = lines.readLine(); line != null; line = lines.readLine()) {
                hear(line);
            }
        } catch (IOException _) {
            // the process has ended
        }
    }

    private void hear(String line) {
        if (line.startsWith(NOTICE + "at ")) {
            place = line.substring(NOTICE.length() + "at ".length());
        } else if (line.startsWith(NOTICE + "debug")) {
            debugged = true;
        } else {
            synchronized (said) {
                said.addLast(line);
                if (said.size() > LAST_WORDS) {
                    said.removeFirst();
                }
            }
            LOG.log(Level.INFO, () -> "python: " + line);
        }
    }

    /// Where Python is, when a turn takes more than a second. May be asked on any thread.
    Optional<String> place() {
        return Optional.ofNullable(place);
    }

    /// Whether somebody looks into Python with a debugger, so that turns may take as long as that needs. May be asked
    /// on
    /// any thread.
    boolean isDebugged() {
        return debugged;
    }
}
