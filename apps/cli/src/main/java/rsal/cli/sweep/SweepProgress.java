package rsal.cli.sweep;

import java.io.PrintWriter;
import java.time.Duration;
import java.util.List;
import rsal.cli.terminal.Terminal;
import rsal.experiment.Pace;
import rsal.experiment.Row;
import rsal.scenario.text.Counted;
import rsal.time.AllowedToReadWallClock;

/// Tells on stderr how far a sweep is: on a terminal by a bar with the time left, elsewhere by a line now and
/// then. Runs that broke are told at once. Safe for several threads.
@AllowedToReadWallClock("Says how long it still takes.")
final class SweepProgress {
    private static final long PERIOD_NANOS = 10_000_000_000L; // between lines, where there is no terminal
    private static final int WIDTH = 30; // of the bar
    private static final String CLEAR_LINE = "\r\033[K";

    private final PrintWriter err;
    private final int wanted;
    private final boolean terminal = Terminal.showsProgress();
    private long began;
    private long reported;
    private int before; // had ended in an earlier session
    private int ended;
    private int broken;
    private boolean inProgress;

    /// @param wanted how many runs there are
    SweepProgress(PrintWriter err, int wanted) {
        this.err = err;
        this.wanted = wanted;
    }

    synchronized void begin(List<Row> there, int jobs) {
        inProgress = true;
        before = there.size();
        ended = before;
        broken = (int) there.stream().filter(Row::isBroken).count();
        began = System.nanoTime();
        reported = began;
        err.println(
                before == 0
                        ? "%s, %d at once; Ctrl-C interrupts.".formatted(Counted.of(wanted, "run"), jobs)
                        : "%s, of which %d are done, %d at once; Ctrl-C interrupts."
                                .formatted(Counted.of(wanted, "run"), before, jobs));
        draw();
    }

    synchronized void ended(Row row) {
        ended++;
        if (row.isBroken()) {
            broken++;
            clear();
            err.println("Run %d broke: %s".formatted(row.run(), row.reason()));
        }
        long now = System.nanoTime();
        if (terminal) {
            draw();
        } else if (now - reported >= PERIOD_NANOS) {
            reported = now;
            err.println(line(ended, before, wanted, broken, Duration.ofNanos(now - began)));
        }
    }

    /// No more runs are done.
    synchronized void end() {
        inProgress = false;
        clear();
    }

    /// The process ends; too early, unless [#end] was said.
    ///
    /// @param folder where the rows are
    synchronized void interrupted(String folder) {
        if (!inProgress) {
            return;
        }
        clear();
        err.println("Interrupted: %d of %d runs are in %s. Continue by the same command with --resume."
                .formatted(ended, wanted, folder));
        err.flush();
    }

    private void draw() {
        if (terminal) {
            err.print(CLEAR_LINE + bar(ended, wanted) + " "
                    + line(ended, before, wanted, broken, Duration.ofNanos(System.nanoTime() - began)));
            err.flush();
        }
    }

    private void clear() {
        if (terminal) {
            err.print(CLEAR_LINE);
            err.flush();
        }
    }

    static String bar(int ended, int wanted) {
        int full = (int) ((long) ended * WIDTH / Math.max(1, wanted));
        return "━".repeat(full) + "┄".repeat(WIDTH - full);
    }

    /// `12/40, 1 broken, 2 min 5 s left`: as long as runs have taken so far in this session.
    static String line(int ended, int before, int wanted, int broken, Duration passed) {
        String line = "%d/%d".formatted(ended, wanted) + (broken > 0 ? ", %d broken".formatted(broken) : "");
        return new Pace(wanted, before, ended, passed)
                .left()
                .map(left -> line + ", %s left".formatted(words(left)))
                .orElse(line);
    }

    private static String words(Duration time) {
        if (time.toHours() > 0) {
            return "%d h %d min".formatted(time.toHours(), time.toMinutesPart());
        }
        return time.toMinutes() > 0
                ? "%d min %d s".formatted(time.toMinutes(), time.toSecondsPart())
                : "%d s".formatted(time.toSeconds());
    }
}
