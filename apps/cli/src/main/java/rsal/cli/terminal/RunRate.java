package rsal.cli.terminal;

import java.time.Duration;
import java.util.concurrent.TimeUnit;

/// Simulated over real time of late, by looks at both every now and then.
final class RunRate {
    private static final long MEASURED_OVER = TimeUnit.MILLISECONDS.toNanos(500);

    private long fromReal; // [ns]
    private long fromSimulated; // [ns]
    private boolean begun;
    private double value;

    /// @param simulated time since the run's start
    /// @param real time, of a clock that never goes back [ns]
    /// @param paused whether the simulated one stands still, so that nothing is to be measured
    void reach(Duration simulated, long real, boolean paused) {
        boolean restarts = paused || !begun;
        if (restarts) {
            value = 0;
        } else if (real - fromReal >= MEASURED_OVER) {
            value = (double) (simulated.toNanos() - fromSimulated) / (real - fromReal);
            restarts = true;
        }
        if (restarts) {
            fromReal = real;
            fromSimulated = simulated.toNanos();
            begun = !paused;
        }
    }

    /// 0 while it is paused or has only just begun.
    double value() {
        return value;
    }
}
