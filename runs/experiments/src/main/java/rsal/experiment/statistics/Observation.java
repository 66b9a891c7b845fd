package rsal.experiment.statistics;

/// When something happened in a run, or until when it had not: then the time is right-censored, as nobody knows when
/// it would have happened.
///
/// @param time when it happened, or until when the run was watched, from its start; +∞ when it can never happen any
/// more
/// @param happened whether it happened; never at +∞
public record Observation(double time, boolean happened) {
    public Observation {
        if (Double.isNaN(time) || time < 0 || (happened && Double.isInfinite(time))) {
            throw new IllegalArgumentException("Nothing is observed at (%s, %s).".formatted(time, happened));
        }
    }

    public static Observation happened(double time) {
        return new Observation(time, true);
    }

    /// It had not happened when the run ended.
    public static Observation censored(double time) {
        return new Observation(time, false);
    }

    /// It can't happen any more. This is not censored: it is known at all times that it has not happened.
    public static Observation never() {
        return new Observation(Double.POSITIVE_INFINITY, false);
    }
}
