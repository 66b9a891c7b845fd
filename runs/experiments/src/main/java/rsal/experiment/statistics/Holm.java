package rsal.experiment.statistics;

import java.util.Comparator;
import java.util.stream.IntStream;

/// p-values of several comparisons, corrected so that the probability of one false alarm or more among all of them is
/// at most as great as with one: S. Holm, A simple sequentially rejective multiple test procedure, Scandinavian
/// Journal of Statistics 6(2), 1979.
public final class Holm {
    private Holm() {}

    /// @param pValues of each comparison, 0 to 1
    /// @return the corrected ones, in the same order
    public static double[] corrected(double... pValues) {
        var corrected = new double[pValues.length];
        double greatest = 0;
        int left = pValues.length;
        for (int i : IntStream.range(0, pValues.length)
                .boxed()
                .sorted(Comparator.comparingDouble(i -> pValues[i]))
                .toList()) {
            greatest = Math.max(greatest, Math.min(1, left * pValues[i]));
            corrected[i] = greatest;
            left--;
        }
        return corrected;
    }
}
