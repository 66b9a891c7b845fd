package rsal.ros2.device;

import java.time.Instant;
import java.time.InstantSource;

/// Tells when something was measured, in the run's time, by the stamps of a robot whose clock is another one.
///
/// It learns from one stream of messages, the odometry. The message that was fastest on its way tells how far
/// the clocks are apart: that of the last 10 to 20 s, as clocks drift. A clock that was set or stood still,
/// as that of a simulator that was paused, is learned again. Where a robot's time does not go as fast as
/// ours, as in a slow simulator, messages are dated when they come. All times in [ns].
final class RobotClock {
    private static final long SECOND = 1_000_000_000;
    private static final long WINDOW = 10 * SECOND;
    private static final long SET = SECOND; // a step of more is none of the network
    private static final double SAME_PACE = 0.02; // share; clocks of computers drift by 0.0001

    private final InstantSource run;
    private final boolean isShared;
    private boolean isKnown;
    private boolean isOfOurPace = true;
    private long newest; // stamp
    private long heard; // when it came, in the run's time
    private long windowBegan; // in the run's time
    private long firstStamp; // of this window
    private long least; // of this window: the run's time less the stamp
    private long before; // of the window before
    private int resets;

    /// @param isShared whether the robot has the run's clock: then stamps are the run's time
    RobotClock(InstantSource run, boolean isShared) {
        this.run = run;
        this.isShared = isShared;
    }

    private static long nanoseconds(Instant time) {
        return time.getEpochSecond() * SECOND + time.getNano();
    }

    /// @param stamp of odometry that has just come; 0 where it has none
    /// @return whether the robot's time went back, as when its simulator was reset
    boolean learn(long stamp) {
        if (stamp == 0) {
            return false;
        }
        long now = nanoseconds(run.instant());
        long apart = now - stamp;
        boolean wentBack = isKnown && stamp < newest - SET;
        boolean wasSet = wentBack || apart < apart() - SET;
        boolean stoodStill = now - heard > SET && apart > apart() + SET;
        if (!isKnown || wasSet || stoodStill) {
            isKnown = true;
            isOfOurPace = true;
            before = Long.MAX_VALUE;
            begin(now, stamp);
        } else if (now - windowBegan >= WINDOW) {
            double pace = (double) (stamp - firstStamp) / (now - windowBegan);
            isOfOurPace = Math.abs(pace - 1) < SAME_PACE;
            before = isOfOurPace ? least : Long.MAX_VALUE;
            begin(now, stamp);
        }
        resets += wentBack ? 1 : 0;
        newest = stamp;
        heard = now;
        least = Math.min(least, apart);
        return wentBack;
    }

    private void begin(long now, long stamp) {
        windowBegan = now;
        firstStamp = stamp;
        least = now - stamp;
    }

    private long apart() {
        return Math.min(least, before);
    }

    /// @param stamp of a message that has just come; 0 where it has none
    /// @return when it was measured; never later than now
    Instant time(long stamp) {
        Instant instant = run.instant();
        if (isShared && stamp != 0) {
            Instant then = Instant.ofEpochSecond(0, stamp);
            return then.isAfter(instant) ? instant : then;
        }
        if (stamp == 0 || !isKnown || !isOfOurPace) {
            return instant;
        }
        long now = nanoseconds(instant);
        long time = stamp + apart();
        return time > now ? instant : instant.minusNanos(now - time);
    }

    /// How often the robot's time went back so far.
    int resets() {
        return resets;
    }

    /// What the robot's clock says now; 0 before it has sent anything.
    long stamp() {
        if (isShared) {
            return nanoseconds(run.instant());
        }
        if (!isKnown) {
            return 0;
        }
        return isOfOurPace ? nanoseconds(run.instant()) - apart() : newest;
    }
}
