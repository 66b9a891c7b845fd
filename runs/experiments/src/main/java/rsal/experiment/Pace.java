package rsal.experiment;

import java.time.Duration;
import java.util.Optional;

/// How far an experiment is, and how fast it goes.
///
/// @param wanted how many runs there are
/// @param before how many of them had ended in earlier sessions
/// @param ended how many have ended by now, those before included
/// @param passed since this session began
public record Pace(int wanted, int before, int ended, Duration passed) {
    /// Until all have ended, when runs go on taking as long as they did in this session; empty while none has
    /// ended in it, and when all have.
    public Optional<Duration> left() {
        int done = ended - before;
        return done == 0 || ended == wanted
                ? Optional.empty()
                : Optional.of(passed.multipliedBy(wanted - ended).dividedBy(done));
    }
}
