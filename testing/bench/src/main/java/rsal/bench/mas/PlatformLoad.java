package rsal.bench.mas;

import java.time.Duration;
import java.util.function.Consumer;
import java.util.function.LongSupplier;
import rsal.bench.measurement.Stopwatch;

/// What agents take for what they do.
///
/// @param cpu share of a core
/// @param rate how often per second they do it
record PlatformLoad(double cpu, double rate) {
    /// After they have been at it for a while.
    ///
    /// @param count how often they have done it so far
    /// @param pass lets time pass for them
    static PlatformLoad of(LongSupplier count, Consumer<Duration> pass) {
        pass.accept(HostBench.WARM);
        var watch = new Stopwatch(); // before they are asked, which takes a while on some systems: at the end, too
        long before = count.getAsLong();
        pass.accept(HostBench.WINDOW);
        double cpu = watch.cpu();
        double wall = watch.wall();
        return new PlatformLoad(cpu / wall, (count.getAsLong() - before) / wall);
    }

    /// Time of processors for each [s].
    double each() {
        return cpu / rate;
    }
}
