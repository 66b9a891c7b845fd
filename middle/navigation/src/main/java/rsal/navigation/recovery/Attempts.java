package rsal.navigation.recovery;

import java.time.Duration;
import rsal.navigation.recovery.Recovery.Situation;

/// Counts how often a recovery was tried since the robot made progress, so that others get their chance.
final class Attempts {
    private final Duration after;
    private final int times;
    private int begun;

    /// @param after begins when there was no progress for so long
    /// @param times how often until there is progress
    Attempts(Duration after, int times) {
        this.after = after;
        this.times = times;
    }

    boolean isDue(Situation situation) {
        if (situation.tried() == 0) {
            begun = 0;
        }
        return begun < times && situation.isStuck(after);
    }

    void begin() {
        begun++;
    }
}
