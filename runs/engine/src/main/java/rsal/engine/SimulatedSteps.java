package rsal.engine;

import java.time.Duration;
import rsal.system.Bridge;
import rsal.time.AllowedToReadWallClock;
import rsal.time.LockstepScheduler;

/// The steps of a run whose time is simulated. Each is made at once, or in parts between which programs behind a bridge
/// are heard and waited for. Of the run's thread.
@AllowedToReadWallClock("It says how long steps took.")
final class SimulatedSteps {
    private static final long SHORT_REST = 500_000; // [ns], after which it looks again whether it may go on
    private static final long LONGER_REST = 2_000_000; // [ns]; what arrives mostly wakes it before

    private final Duration step;
    private final Pacer pacer;
    private final Pausing pausing;
    private final StepTimes times;
    private Duration left; // of the step that is under way
    private long took; // that one so far [ns]

    SimulatedSteps(Duration step, Pacer pacer, Pausing pausing, StepTimes times) {
        this.step = step;
        this.pacer = pacer;
        this.pausing = pausing;
        this.times = times;
        left = step;
    }

    /// Makes a step or a part of one, if the run may go on.
    ///
    /// @param elapsed simulated time so far [ns]
    /// @return after which time to ask again [ns] if it may not; 0 or less when it went on
    long goOn(LockstepScheduler time, RunAssembly run, long elapsed) {
        Bridge.Pace pace = run.bridges().pace();
        pacer.limit(pace == Bridge.Pace.UNFOLLOWED ? 1 : Double.POSITIVE_INFINITY, elapsed);
        long early = pausing.isPaused() ? 0 : pacer.early(elapsed);
        if (early > 0) {
            return early;
        }
        boolean isAwaited = pace == Bridge.Pace.AWAITED && !pausing.isCompleting();
        if (isAwaited || (pacer.isAhead(elapsed) && run.bridges().isAwaited())) {
            time.runPending(); // what such a program asks meanwhile
            return isAwaited ? LONGER_REST : SHORT_REST;
        }
        Duration grain = run.bridges().grain(left);
        long from = System.nanoTime();
        time.advance(grain);
        took += System.nanoTime() - from;
        left = left.minus(grain);
        if (left.isZero()) {
            times.took(took);
            took = 0;
            left = step;
            pausing.stepped();
        } else {
            pausing.stepBegun();
        }
        return 0;
    }
}
