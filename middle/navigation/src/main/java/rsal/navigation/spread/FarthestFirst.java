package rsal.navigation.spread;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.function.ToDoubleFunction;

/// Chooses places, each as far as can be from those before: T. Gonzalez, Clustering to minimize the maximum
/// intercluster distance (Theoretical Computer Science 38, 1985); and S. Ravi, D. Rosenkrantz, G. Tayi,
/// Heuristic and special case algorithms for dispersion problems (Operations Research 42, 1994). Departs
/// from them in three ways. Each place is tried as the first, and the best few results are kept, for swaps.
/// Places keep twice the clearance in a straight line. Only some places may be chosen, but distances from
/// all of them count. So neither of their bounds holds here: at most twice the least greatest distance, at
/// least half of the greatest least distance.
final class FarthestFirst {
    private static final int MOST_KEPT = 8;
    private static final int LEAST_KEPT = 2;
    private static final int PLACES_KEPT = 256; // in all; swaps take longer the more places there are

    private FarthestFirst() {}

    /// @param may what can be chosen
    /// @param costs what is least for the best
    /// @return different ones, the best first: 8, or fewer for many places; empty when there is no room
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
        int kept = Math.clamp(PLACES_KEPT / number, LEAST_KEPT, MOST_KEPT);
        var best = new ArrayList<int[]>();
        for (Start start : starts) {
            if (best.size() < kept && best.stream().noneMatch(other -> Arrays.equals(other, start.chosen))) {
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
            // also where another is nearer by path: paths along cells and straight lines are ordered differently
            nearest[i] =
                    candidates.areTooNear(place, may[i]) ? 0 : Math.min(nearest[i], candidates.length(place, may[i]));
        }
    }
}
