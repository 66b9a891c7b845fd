package rsal.engine;

import java.util.function.LongFunction;
import java.util.function.LongSupplier;
import rsal.engine.event.Viewers;
import rsal.engine.report.Snapshot;

/// The newest snapshot of a run, and when to make the next: if somebody wants one, but not too often. Made on the
/// run's thread, read and wanted on any.
final class Snapshots {
    private static final long PERIOD = 45_000_000; // ns

    private final LongSupplier clock;
    private final LongFunction<Snapshot> maker;
    private final Viewers viewers = new Viewers();
    private volatile Snapshot newest;
    private volatile boolean wanted;
    private long made; // [ns]

    /// @param clock real time [ns]
    /// @param maker of a snapshot with the sequence number that it is given; called at once for the first, 0
    Snapshots(LongSupplier clock, LongFunction<Snapshot> maker) {
        this.clock = clock;
        this.maker = maker;
        this.newest = maker.apply(0);
    }

    /// Told of each new one.
    Viewers viewers() {
        return viewers;
    }

    Snapshot newest() {
        return newest;
    }

    /// Somebody wants a newer one.
    void want() {
        wanted = true;
    }

    /// How long until it is time for the next [ns]; for ever when nobody wants one.
    long untilDue() {
        return wanted ? made + PERIOD - clock.getAsLong() : Long.MAX_VALUE;
    }

    /// @return whether it was
    boolean makeIfDue() {
        boolean due = untilDue() <= 0;
        if (due) {
            make();
        }
        return due;
    }

    void make() {
        wanted = false;
        made = clock.getAsLong();
        newest = maker.apply(newest.sequence() + 1);
        viewers.publish();
    }
}
