package rsal.cli.bench;

import java.io.PrintWriter;
import rsal.time.AllowedToReadWallClock;

/// Tells on stderr how far a benchmark is: each result, what takes long now and then, and how far it came when a
/// signal ends it. Safe for several threads.
@AllowedToReadWallClock("Tells something every few seconds.")
final class BenchProgress {
    private static final long PERIOD_NANOS = 5_000_000_000L;

    private final PrintWriter err;
    private final int wanted;
    private final Thread atExit = new Thread(this::printInterrupted, "interrupted");
    private long reported = System.nanoTime();
    private int measured;

    /// @param wanted how many results there will be at most
    BenchProgress(PrintWriter err, int wanted) {
        this.err = err;
        this.wanted = wanted;
        Runtime.getRuntime().addShutdownHook(atExit);
        err.println("Measuring %d; Ctrl-C ends it.".formatted(wanted));
    }

    /// @param result `sim.empty.1 120 M/s`
    synchronized void measured(String result) {
        measured++;
        err.println("%d/%d %s".formatted(measured, wanted, result));
        reported = System.nanoTime();
    }

    /// @param what `barn.dwa, worlds: 12 of 300`
    synchronized void reached(String what) {
        long now = System.nanoTime();
        if (now - reported >= PERIOD_NANOS) {
            reported = now;
            err.println("  " + what);
        }
    }

    /// All is measured.
    void end() {
        Runtime.getRuntime().removeShutdownHook(atExit);
    }

    private void printInterrupted() {
        err.println("Interrupted: %d of %d were measured; their values are above.".formatted(measured, wanted));
    }
}
