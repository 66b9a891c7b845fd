package rsal.time;

import java.time.InstantSource;

/// Where a [WallScheduler] has its time from. Any thread may ask.
interface TimeSource extends InstantSource {
    /// Since it began; never goes back [ns].
    long nanos();
}
