package rsal.ros2.device;

import java.time.Instant;
import java.time.InstantSource;

/// Tells when something was measured, in the run's time, by the stamps of a robot whose clock is another one.
///
/// The message that was fastest on its way tells how far the clocks are apart: that of the last 10 to 20 s, as clocks
/// drift and robots set them.
final class RobotClock {
    private static final long WINDOW = 10_000_000_000L; // ns

    private final InstantSource run;
    private long windowEnds = Long.MIN_VALUE;
    private long least = Long.MAX_VALUE; // of this window: the run's time less the stamp [ns]
    private long before = Long.MAX_VALUE; // of the window before

    RobotClock(InstantSource run) {
        this.run = run;
    }

    private static long nanoseconds(Instant time) {
        return time.getEpochSecond() * 1_000_000_000 + time.getNano();
    }

    /// @param stamp of a message that has just come [ns]; 0 where it has none
    /// @return when it was measured; never later than now
    Instant time(long stamp) {
        Instant instant = run.instant();
        if (stamp == 0) {
            return instant;
        }
        long now = nanoseconds(instant);
        if (now >= windowEnds) {
            before = windowEnds == Long.MIN_VALUE ? Long.MAX_VALUE : least;
            least = Long.MAX_VALUE;
            windowEnds = now + WINDOW;
        }
        least = Math.min(least, now - stamp);
        long time = stamp + Math.min(least, before);
        return time > now ? instant : instant.minusNanos(now - time);
    }

    /// What the robot's clock says now [ns]; 0 before it has sent anything.
    long stamp() {
        long apart = Math.min(least, before);
        return apart == Long.MAX_VALUE ? 0 : nanoseconds(run.instant()) - apart;
    }
}
