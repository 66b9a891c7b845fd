package rsal.navigation.spread;

import java.util.Arrays;

/// Finds few places such that everything is within a distance of one of them, and the least such distance for a
/// number of places by bisection: J. Mihelič, B. Robič, Solving the k-center problem efficiently with a
/// dominating set algorithm (Journal of Computing and Information Technology 13, 2005). Places are left out one
/// after the other, those first that have few others near, unless something is near to them alone.
final class DominatingChoice {
    private static final int BISECTIONS = 14;

    private final Candidates candidates;
    private final int[] may;

    DominatingChoice(Candidates candidates, int[] may) {
        this.candidates = candidates;
        this.may = may;
    }

    /// @return empty when some of them would be too near to each other
    int[] choose(int number) {
        double low = 0;
        double high = candidates.greatest(new int[] {may[0]});
        int[] best = new int[] {may[0]};
        for (int step = 0; step < BISECTIONS; step++) {
            double middle = (low + high) / 2;
            int[] chosen = dominating(middle, number);
            if (chosen.length == 0) {
                low = middle;
            } else {
                high = middle;
                best = chosen;
            }
        }
        for (int k = 0; k < best.length; k++) {
            if (candidates.isTooNear(best[k], best, k)) {
                return new int[0];
            }
        }
        return FarthestFirst.extended(candidates, may, best, number);
    }

    /// @return at most so many, or none when the method needs more
    private int[] dominating(double within, int most) {
        var near = new int[candidates.count()]; // how many that may be chosen are near
        for (int place : may) {
            for (int i = 0; i < near.length; i++) {
                near[i] += candidates.length(place, i) <= within ? 1 : 0;
            }
        }
        for (int count : near) {
            if (count == 0) {
                return new int[0];
            }
        }
        var scores = near.clone();
        var left = may.clone();
        int leftOver = left.length;
        var chosen = new int[most];
        int count = 0;
        while (leftOver > 0) {
            int next = 0;
            for (int k = 1; k < leftOver; k++) {
                next = scores[left[k]] < scores[left[next]] ? k : next;
            }
            int place = left[next];
            left[next] = left[--leftOver];
            boolean isNeeded = false;
            for (int i = 0; i < near.length && !isNeeded; i++) {
                isNeeded = near[i] == 1 && candidates.length(place, i) <= within;
            }
            if (isNeeded && count == most) {
                return new int[0];
            }
            for (int i = 0; i < near.length; i++) {
                if (candidates.length(place, i) <= within && near[i] > 0) {
                    near[i] = isNeeded ? 0 : near[i] - 1;
                    scores[i] += isNeeded ? 0 : 1;
                }
            }
            if (isNeeded) {
                chosen[count++] = place;
            }
        }
        return Arrays.copyOf(chosen, count);
    }
}
