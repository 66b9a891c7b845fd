package rsal.cli.terminal;

import java.io.PrintWriter;
import java.time.Duration;
import java.util.Locale;
import java.util.Set;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import rsal.engine.LiveRun;
import rsal.engine.report.RunEvent;
import rsal.engine.report.RunResult;
import rsal.scenario.RunPlan;
import rsal.time.AllowedToReadWallClock;

/// Tells on stderr how a run goes: what happens, and how far it is; on a terminal by a line that is drawn over and
/// over, elsewhere by one now and then, ever more seldom.
@AllowedToReadWallClock("Tells people that it still goes on.")
public final class Progress {
    private static final long PERIOD_MILLIS = 250;
    private static final String PRINT = "print"; // of agents
    private static final String HEALTH = "health"; // of devices
    private static final Set<String> KINDS = Set.of(
            "bridge", "caught", "collision", "fault", HEALTH, "mapped", "operator", PRINT, "uncaught", "unreached");
    private static final String CLEAR_LINE = "\r\033[K";

    private final PrintWriter err;
    private final boolean quiet;
    private final boolean terminal = Terminal.showsProgress();
    private final LifeSigns signs = new LifeSigns();
    private final HealthLines health = new HealthLines();
    private final RunRate rate = new RunRate();
    private long began;
    private long lastEvent;

    /// @param quiet without what agents print
    public Progress(PrintWriter err, boolean quiet) {
        this.err = err;
        this.quiet = quiet;
    }

    /// Waits for the end of a run, and tells nothing.
    ///
    /// @throws Exception what broke the run
    public static RunResult awaitSilently(LiveRun run) throws Exception {
        try {
            return run.result().toCompletableFuture().get();
        } catch (ExecutionException e) {
            throw e.getCause() instanceof Exception cause ? cause : e;
        }
    }

    /// Waits for the end of a run.
    ///
    /// @throws Exception what broke the run
    public RunResult await(LiveRun run) throws Exception {
        RunPlan plan = run.plan();
        err.printf("Running %s:%s with seed %d%n", plan.scenario().name(), plan.configuration(), plan.seed());
        began = System.nanoTime();
        CompletableFuture<RunResult> result = run.result().toCompletableFuture();
        while (true) {
            try {
                RunResult ended = result.get(PERIOD_MILLIS, TimeUnit.MILLISECONDS);
                show(run);
                health.rest().forEach(this::print);
                clear();
                return ended;
            } catch (TimeoutException _) {
                show(run);
            } catch (ExecutionException e) {
                clear();
                throw e.getCause() instanceof Exception cause ? cause : e;
            }
        }
    }

    private void show(LiveRun run) {
        for (RunEvent event : run.events(lastEvent)) {
            lastEvent = event.sequence();
            if (tells(event) && !isHeld(event)) {
                print(event);
            }
        }
        Duration now = run.elapsed(); // rather than a snapshot of all robots, of which nothing is shown here
        health.due(now).forEach(this::print);
        rate.reach(now, System.nanoTime(), run.isPaused());
        boolean isReal = run.plan().clock() == RunPlan.Clock.WALL;
        if (terminal) {
            err.print(CLEAR_LINE + line(now, run.isPaused(), rate.value(), isReal));
            err.flush();
        } else if (signs.isDue(System.nanoTime() - began, run.isPaused())) {
            err.println(line(now, run.isPaused(), rate.value(), isReal));
        }
    }

    private boolean isHeld(RunEvent event) {
        return switch (event.kind()) {
            case PRINT -> quiet;
            case HEALTH -> !health.tells(event);
            default -> false;
        };
    }

    private void print(RunEvent event) {
        clear();
        err.println(line(event));
    }

    /// @param now simulated time since the run's start
    /// @param rate simulated over real time
    /// @param isReal whether the robots of the run must be found first, while its time stands at 0
    static String line(Duration now, boolean paused, double rate, boolean isReal) {
        if (isReal && now.isZero()) {
            return "           waiting for robots";
        }
        if (paused) {
            return String.format(Locale.ROOT, "%8.1f s  paused", seconds(now));
        }
        return String.format(Locale.ROOT, "%8.1f s  running at %s × real time", seconds(now), rate(rate));
    }

    /// In two or three digits: `0.94`, `33.8`, `1,250`.
    private static String rate(double rate) {
        return String.format(Locale.ROOT, rate < 1 ? "%.2g" : rate < 100 ? "%.3g" : "%,.0f", rate);
    }

    /// Whether people want to know without a page.
    static boolean tells(RunEvent event) {
        return KINDS.contains(event.kind());
    }

    /// `    12.3 s  hunter-1: ran into wall`.
    static String line(RunEvent event) {
        String subject = event.subject().isEmpty() ? "" : event.subject() + ": ";
        return String.format(Locale.ROOT, "%8.1f s  %s%s", seconds(event.time()), subject, event.text());
    }

    private void clear() {
        if (terminal) {
            err.print(CLEAR_LINE);
            err.flush();
        }
    }

    private static double seconds(Duration time) {
        return time.toNanos() / 1e9;
    }
}
