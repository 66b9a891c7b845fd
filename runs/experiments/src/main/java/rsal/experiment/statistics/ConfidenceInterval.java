package rsal.experiment.statistics;

/// A confidence interval: made again and again from new samples, at least about so many in a hundred hold
/// what is estimated.
public record ConfidenceInterval(double low, double high) {
    /// Of all intervals of this package, two-sided.
    public static final double CONFIDENCE = 0.95;

    public boolean holds(double value) {
        return low <= value && value <= high;
    }
}
