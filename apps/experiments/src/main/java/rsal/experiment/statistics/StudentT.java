package rsal.experiment.statistics;

/// Student's t distribution.
final class StudentT {
    private static final int HALVINGS = 200; // more than a double has bits

    private StudentT() {}

    /// How probable it is that a value is at most t away from 0: Abramowitz and Stegun, Handbook of
    /// Mathematical Functions, equations 26.7.3 (an odd number of degrees of freedom) and 26.7.4 (an even
    /// one).
    ///
    /// @param freedom degrees of it, at least 1
    static double within(double t, int freedom) {
        double angle = Math.atan(t / Math.sqrt(freedom));
        double cosine = Math.cos(angle);
        boolean odd = freedom % 2 == 1;
        double term = odd ? cosine : 1;
        double sum = 0;
        for (int power = odd ? 1 : 0; power <= freedom - 2; power += 2) {
            sum += term;
            term *= cosine * cosine * (power + 1) / (power + 2);
        }
        return odd ? 2 / Math.PI * (angle + Math.sin(angle) * sum) : Math.sin(angle) * sum;
    }

    /// How far from 0 values are at most with a probability.
    ///
    /// @param freedom degrees of it, at least 1
    static double critical(double probability, int freedom) {
        double low = 0;
        double high = 1;
        while (within(high, freedom) < probability) {
            high *= 2;
        }
        for (int i = 0; i < HALVINGS && low < high; i++) {
            double middle = (low + high) / 2;
            if (middle == low || middle == high) {
                break;
            }
            if (within(middle, freedom) < probability) {
                low = middle;
            } else {
                high = middle;
            }
        }
        return high;
    }
}
