package rsal.navigation.spread;

import java.util.ArrayList;
import java.util.Arrays;

/// Makes the greatest distance from anywhere to the nearest of some places small (p-center), from
/// farthest-first choices and from one that dominates the floor ([DominatingChoice]), by swaps: N. Mladenović,
/// M. Labbé, P. Hansen, Solving the p-center problem with tabu search and variable neighborhood search
/// (Networks 42, 2003), whose observation is used that only places nearer to the farthest one than all chosen
/// can help. Departs from them in that there is no search beyond the best swaps; several starts are swapped
/// instead.
final class NearChoice {
    private static final int MOST_SWAPS = 200;

    private final Candidates candidates;
    private final int[] may;
    private final float[] nearest;
    private final float[] second;
    private final int[] nearestOf;

    NearChoice(Candidates candidates, int[] may) {
        this.candidates = candidates;
        this.may = may;
        this.nearest = new float[candidates.count()];
        this.second = new float[candidates.count()];
        this.nearestOf = new int[candidates.count()];
    }

    /// @return empty when there is no room
    int[] choose(int number) {
        int[] best = new int[0];
        double least = Double.POSITIVE_INFINITY;
        var starts = new ArrayList<>(FarthestFirst.from(candidates, may, number, candidates::greatest));
        int[] dominating = new DominatingChoice(candidates, may).choose(number);
        if (dominating.length == number) {
            starts.add(dominating);
        }
        for (int[] start : starts) {
            swap(start);
            double greatest = candidates.greatest(start);
            if (greatest < least) {
                least = greatest;
                best = start;
            }
        }
        return best;
    }

    private void swap(int[] chosen) {
        for (int swaps = 0; swaps < MOST_SWAPS; swaps++) {
            int farthest = assign(chosen);
            float greatest = nearest[farthest];
            int which = -1;
            int what = -1;
            for (int candidate : may) {
                if (candidates.length(candidate, farthest) < greatest) {
                    for (int k = 0; k < chosen.length; k++) {
                        float now = swapped(candidate, k, greatest);
                        if (now < greatest && !candidates.isTooNear(candidate, chosen, k)) {
                            greatest = now;
                            which = k;
                            what = candidate;
                        }
                    }
                }
            }
            if (which < 0) {
                return;
            }
            chosen[which] = what;
        }
    }

    /// The greatest distance with a candidate in place of one of the chosen, or some distance that is not less
    /// than the bound.
    private float swapped(int candidate, int k, float bound) {
        float greatest = 0;
        for (int i = 0; i < nearest.length; i++) {
            float other = nearestOf[i] == k ? second[i] : nearest[i];
            greatest = Math.max(greatest, Math.min(other, candidates.length(candidate, i)));
            if (greatest >= bound) {
                return greatest;
            }
        }
        return greatest;
    }

    /// @return the candidate that is farthest from all chosen
    private int assign(int[] chosen) {
        Arrays.fill(nearest, Float.POSITIVE_INFINITY);
        Arrays.fill(second, Float.POSITIVE_INFINITY);
        int farthest = 0;
        for (int i = 0; i < nearest.length; i++) {
            for (int k = 0; k < chosen.length; k++) {
                float length = candidates.length(chosen[k], i);
                if (length < nearest[i]) {
                    second[i] = nearest[i];
                    nearest[i] = length;
                    nearestOf[i] = k;
                } else if (length < second[i]) {
                    second[i] = length;
                }
            }
            farthest = nearest[i] > nearest[farthest] ? i : farthest;
        }
        return farthest;
    }
}
