package rsal.cli.terminal;

import java.util.concurrent.TimeUnit;

/// When to say that something long still goes on: after 10 s, and then whenever twice as much time has passed, so that
/// nobody waits in doubt and what runs for days leaves no long log.
public final class LifeSigns {
    private long next = TimeUnit.SECONDS.toNanos(10);
    private boolean reportedPause;

    /// @param passed since it began [ns]
    public boolean isDue(long passed) {
        boolean due = passed >= next;
        while (passed >= next) {
            next *= 2;
        }
        return due;
    }

    /// The same of something that can stand still, of which that is said only once.
    ///
    /// @param passed since it began [ns]
    public boolean isDue(long passed, boolean paused) {
        boolean due = isDue(passed) && !(paused && reportedPause);
        reportedPause = paused && (reportedPause || due);
        return due;
    }
}
