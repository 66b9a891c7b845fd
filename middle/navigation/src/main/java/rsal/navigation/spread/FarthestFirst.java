package rsal.navigation.spread;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.function.ToDoubleFunction;

/// Chooses places, each as far as can be from those before: T. Gonzalez, Clustering to minimize the maximum
/// intercluster distance (Theoretical Computer Science 38, 1985), at most twice the least greatest distance;
/// and S. Ravi, D. Rosenkrantz, G. Tayi, Heuristic and special case algorithms for dispersion problems
/// (Operations Research 42, 1994), at least half of the greatest least distance. Departs from them in that each
/// place is tried as the first, and the best few results are kept, for swaps.
final class FarthestFirst {
    private static final int KEPT = 8;

    private FarthestFirst() {}

    /// @param may what can be chosen
    /// @param costs what is least for the best
    /// @return different ones, the best first; empty when there is no room for so many anywhere
    static List<int[]> from(Candidates candidates, int[] may, int number, ToDoubleFunction<int[]> costs) {
        record Start(int[] chosen, double cost) {}
        var starts = new ArrayList<Start>();
        for (int first : may) {
            int[] chosen = extended(candidates, may, new int[] {first}, number);
            if (chosen.length == number) {
                Arrays.sort(chosen);
                starts.add(new Start(chosen, costs.applyAsDouble(chosen)));
            }
        }
        starts.sort(Comparator.comparingDouble(Start::cost));
        var best = new ArrayList<int[]>();
        for (Start start : starts) {
            if (best.size() < KEPT && best.stream().noneMatch(other -> Arrays.equals(other, start.chosen))) {
                best.add(start.chosen);
            }
        }
        return best;
    }

    /// @param chosen at least one
    /// @return these and more, as far as there is room
    static int[] extended(Candidates candidates, int[] may, int[] chosen, int number) {
        int[] all = Arrays.copyOf(chosen, number);
        var nearest = new float[may.length];
        Arrays.fill(nearest, Float.POSITIVE_INFINITY);
        for (int place : chosen) {
            approach(candidates, may, nearest, place);
        }
        for (int k = chosen.length; k < number; k++) {
            int farthest = -1;
            for (int i = 0; i < may.length; i++) {
                farthest = nearest[i] > 0 && (farthest < 0 || nearest[i] > nearest[farthest]) ? i : farthest;
            }
            if (farthest < 0) {
                return Arrays.copyOf(all, k);
            }
            all[k] = may[farthest];
            approach(candidates, may, nearest, may[farthest]);
        }
        return all;
    }

    private static void approach(Candidates candidates, int[] may, float[] nearest, int place) {
        for (int i = 0; i < may.length; i++) {
            float length = candidates.length(place, may[i]);
            if (length < nearest[i]) {
                boolean isTooNear = candidates.areTooNear(place, may[i]);
                nearest[i] = isTooNear ? 0 : length;
            }
        }
    }
}
