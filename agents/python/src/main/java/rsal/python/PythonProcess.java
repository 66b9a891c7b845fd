package rsal.python;

import java.io.BufferedReader;
import java.io.EOFException;
import java.io.IOException;
import java.io.InputStreamReader;
import java.lang.System.Logger;
import java.lang.System.Logger.Level;
import java.nio.charset.StandardCharsets;
import java.time.Duration;
import java.util.ArrayDeque;
import java.util.Deque;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.TimeUnit;
import org.jspecify.annotations.Nullable;
import rsal.agent.Agent;
import rsal.frame.FramePipe;

/// A process of Python that waits for agents, has some, or has ended. One thread at a time exchanges frames with it.
final class PythonProcess {
    private static final Logger LOG = System.getLogger(Agent.class.getName());
    private static final String NOTICE = "\u0001"; // begins lines on stderr that are for us
    private static final String AT = NOTICE + "at ";
    private static final int LAST_WORDS = 12; // lines
    private static final int GRACE = 2; // s; of a process that is told to end
    private static final Duration PATIENCE = Duration.ofSeconds(60); // for its first words

    private final Process process;
    private final FramePipe frames;
    private final Thread errors;
    private final Deque<String> said = new ArrayDeque<>(); // on stderr, the last lines; guarded by itself
    private volatile Optional<Place> place = Optional.empty(); // of a turn that takes long
    private volatile boolean debugged;
    private volatile @Nullable String dead; // why it ended
    private boolean greeted;

    /// Where Python is in a turn that takes long.
    ///
    /// @param agent number of the one whose turn it is
    record Place(int agent, String words) {}

    /// Starts one. Returns before it is ready.
    ///
    /// @throws PythonFailure when there is no Python that could be started
    PythonProcess() {
        try {
            this.process = Interpreter.start("process");
        } catch (IOException e) {
            throw new PythonFailure("Python can't be run: %s.".formatted(e.getMessage()));
        }
        this.frames = new FramePipe(process.getInputStream(), process.getOutputStream());
        this.errors = Thread.ofPlatform().daemon().name("python-errors").start(this::readErrors);
    }

    /// Waits until it is ready.
    ///
    /// @return whether it was not known to be ready
    /// @throws PythonFailure when it can't have agents
    boolean greet() {
        if (greeted) {
            return false;
        }
        Map<?, ?> hello = hello();
        if (hello.get("error") instanceof String why) {
            throw new PythonFailure(why);
        }
        if (!Integer.valueOf(FramePipe.VERSION).equals(hello.get("protocol")) || !"little".equals(hello.get("order"))) {
            throw new PythonFailure("The Python package is not of this version of RSAL: %s.".formatted(hello));
        }
        greeted = true;
        return true;
    }

    private Map<?, ?> hello() {
        try (var time = AnswerTime.of(process, PATIENCE)) {
            try {
                return frames.read();
            } catch (IOException e) {
                throw time.isOver() ? ended("Python can't be run: " + time.words()) : ended(e);
            }
        }
    }

    boolean isAlive() {
        return process.isAlive();
    }

    /// @throws PythonFailure when it has ended
    /// @throws IllegalArgumentException when that is too long for a frame; then nothing was written
    void write(FramePipe.Content content) {
        String gone = dead;
        if (gone != null) {
            throw new PythonFailure(gone);
        }
        place = Optional.empty();
        try {
            frames.write(content);
        } catch (FramePipe.TooLong e) {
            throw new IllegalArgumentException(e.getMessage(), e);
        } catch (IOException e) {
            throw ended(e);
        }
    }

    /// The words of the next frame.
    ///
    /// @throws PythonFailure when it has ended
    Map<?, ?> read() {
        String gone = dead;
        if (gone != null) {
            throw new PythonFailure(gone);
        }
        try {
            return frames.read();
        } catch (IOException e) {
            throw ended(e);
        }
    }

    /// Tells it to end, and ends it if it does not. Returns at once.
    ///
    /// @param patience how long it may go on before it is told [s]
    void close(int patience) {
        Thread.ofPlatform().daemon().name("python-end").start(() -> end(patience));
    }

    private void end(int patience) {
        try {
            if (!process.waitFor(patience, TimeUnit.SECONDS)) {
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

    /// It gets no more frames, and ends by that.
    void hangUp() {
        try {
            process.getOutputStream().close();
        } catch (IOException _) {
            process.destroyForcibly();
        }
    }

    /// Ends it at once: its code never returns. May be called on any thread.
    void kill() {
        process.destroyForcibly();
    }

    /// Why it is no more, with its last words.
    private PythonFailure ended(IOException why) {
        hangUp();
        if (why instanceof EOFException || !process.isAlive()) {
            return ended("Python ended%s".formatted(exitCode()));
        }
        String code = exitCode(); // a frame that can't be read: it does not fit any more
        return ended("Python's answer can't be read: %s Then it ended%s".formatted(why.getMessage(), code));
    }

    private PythonFailure ended(String why) {
        String words = "%s.%s".formatted(why, lastWords());
        dead = words;
        return new PythonFailure(words);
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
        if (line.startsWith(AT)) {
            String[] words = line.substring(AT.length()).split(" ", 2);
            place = Optional.of(new Place(Integer.parseInt(words[0]), words[1]));
        } else if (line.startsWith(NOTICE + "debug")) {
            debugged = true;
        } else {
            synchronized (said) {
                said.addLast(line);
                if (said.size() > LAST_WORDS) {
                    said.removeFirst();
                }
            }
            LOG.log(Level.WARNING, () -> "Python (stderr): " + line);
        }
    }

    /// Where Python is, when a turn takes more than a second. May be asked on any thread.
    Optional<Place> place() {
        return place;
    }

    /// Whether somebody looks into Python with a debugger, so that turns may take as long as that needs. May be asked
    /// on any thread.
    boolean isDebugged() {
        return debugged;
    }
}
