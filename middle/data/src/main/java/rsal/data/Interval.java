package rsal.data;

/// All numbers from one to another, both included.
public record Interval(double least, double most) {
    public Interval {
        if (!(least <= most)) {
            throw new IllegalArgumentException(
                    "An interval reaches from its least to its most, not from %s to %s.".formatted(least, most));
        }
    }

    /// As far to both sides of 0.
    public static Interval around0(double most) {
        return new Interval(-most, most);
    }

    public boolean contains(double value) {
        return value >= least && value <= most;
    }

    /// The nearest number of the interval. NaN stays NaN.
    public double clamp(double value) {
        return Math.max(least, Math.min(most, value));
    }

    /// How far it reaches to both sides of 0; 0 when 0 is not inside.
    public double reach() {
        return Math.max(0, Math.min(-least, most));
    }
}
