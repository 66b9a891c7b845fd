package rsal.engine;

import java.util.function.LongSupplier;

/// Holds a run back to the speed that is asked for, and measures the one it has. A run that can't keep up is late
/// and stays late; it does not hurry afterwards.
final class Pacer {
    private static final long MOST_LATE = 250_000_000;
    private static final long MEASURED_OVER = 500_000_000;

    private final LongSupplier clock;
    private double speed;
    private double most = Double.POSITIVE_INFINITY;
    private long fromReal;
    private long fromSimulated;
    private long rateFromReal;
    private long rateFromSimulated;
    private double rate;

    /// @param clock real time [ns]
    /// @param speed simulated over real time; +∞ for as fast as it can
    Pacer(LongSupplier clock, double speed) {
        this.clock = clock;
        this.speed = speed;
        restart(0);
    }

    double speed() {
        return speed;
    }

    void speed(double factor, long simulated) {
        speed = factor;
        restart(simulated);
    }

    /// Holds it back further, for as long as another limit is not set.
    ///
    /// @param factor simulated over real time; +∞ for no limit but the speed
    void limit(double factor, long simulated) {
        if (most != factor) {
            most = factor;
            fromReal = clock.getAsLong();
            fromSimulated = simulated;
        }
    }

    /// Begins again, after a pause.
    void restart(long simulated) {
        fromReal = clock.getAsLong();
        fromSimulated = simulated;
        rateFromReal = fromReal;
        rateFromSimulated = simulated;
        rate = 0;
    }

    /// How much too early it is [ns]; 0 or less when it is not.
    long early(long simulated) {
        double wanted = Math.min(speed, most);
        if (wanted == Double.POSITIVE_INFINITY) {
            return 0;
        }
        long now = clock.getAsLong();
        long due = fromReal + (long) ((simulated - fromSimulated) / wanted);
        if (now - due > MOST_LATE) {
            fromReal = now;
            fromSimulated = simulated;
        }
        return due - now;
    }

    /// Whether it goes as fast as it can, and is faster than real time.
    boolean isAhead(long simulated) {
        return speed == Double.POSITIVE_INFINITY && simulated - fromSimulated > clock.getAsLong() - fromReal;
    }

    /// Simulated over real time of late; 0 when it has only just begun.
    double rate(long simulated) {
        long now = clock.getAsLong();
        if (now - rateFromReal >= MEASURED_OVER) {
            rate = (double) (simulated - rateFromSimulated) / (now - rateFromReal);
            rateFromReal = now;
            rateFromSimulated = simulated;
        }
        return rate;
    }
}
