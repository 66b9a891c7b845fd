package rsal.navigation.spread;

/// Makes the least distance between two of some places great (max-min dispersion), from farthest-first choices
/// by swaps of one place for another, as in E. Erkut, The discrete p-dispersion problem (European Journal of
/// Operational Research 46, 1990). Departs from it in that equal distances are told apart by the sum of all
/// distances to the nearest, so that swaps go on where two pairs are equally near.
final class ApartChoice {
    private static final int MOST_SWAPS = 200;
    private static final double TIE = 1e-3; // of the mean distance to the nearest; never more than a step of a path

    private final Candidates candidates;
    private final int[] may;
    private final double[] nearest; // by candidate, of the chosen
    private final double[] second;
    private final int[] nearestOf; // index in the chosen

    ApartChoice(Candidates candidates, int[] may) {
        this.candidates = candidates;
        this.may = may;
        this.nearest = new double[candidates.count()];
        this.second = new double[candidates.count()];
        this.nearestOf = new int[candidates.count()];
    }

    /// @return empty when there is no room
    int[] choose(int number) {
        int[] best = new int[0];
        double most = Double.NEGATIVE_INFINITY;
        for (int[] start : FarthestFirst.from(candidates, may, number, chosen -> -score(chosen))) {
            swap(start);
            double score = score(start);
            if (score > most) {
                most = score;
                best = start;
            }
        }
        return best;
    }

    private double score(int[] chosen) {
        double least = Double.POSITIVE_INFINITY;
        double sum = 0;
        for (int i = 0; i < chosen.length; i++) {
            double nearest = nearest(chosen[i], chosen, i);
            least = Math.min(least, nearest);
            sum += Double.isFinite(nearest) ? nearest : 0;
        }
        return chosen.length < 2 ? 0 : least + TIE * sum / chosen.length;
    }

    private double nearest(int place, int[] chosen, int but) {
        double nearest = Double.POSITIVE_INFINITY;
        for (int k = 0; k < chosen.length; k++) {
            nearest = k == but ? nearest : Math.min(nearest, candidates.length(place, chosen[k]));
        }
        return nearest;
    }

    /// Which two of the chosen are nearest to each that may be.
    private void assign(int[] chosen) {
        for (int candidate : may) {
            nearest[candidate] = Double.POSITIVE_INFINITY;
            second[candidate] = Double.POSITIVE_INFINITY;
            for (int k = 0; k < chosen.length; k++) {
                double length = candidates.length(candidate, chosen[k]);
                if (length < nearest[candidate]) {
                    second[candidate] = nearest[candidate];
                    nearest[candidate] = length;
                    nearestOf[candidate] = k;
                } else {
                    second[candidate] = Math.min(second[candidate], length);
                }
            }
        }
    }

    private void swap(int[] chosen) {
        double score = score(chosen);
        for (int swaps = 0; swaps < MOST_SWAPS; swaps++) {
            int which = -1;
            int what = -1;
            double most = score + 1e-6;
            assign(chosen);
            for (int k = 0; k < chosen.length; k++) {
                int before = chosen[k];
                for (int candidate : may) {
                    // only what is farther from the others than the least distance can help
                    double toOthers = nearestOf[candidate] == k ? second[candidate] : nearest[candidate];
                    if (toOthers > score * (1 - TIE) && !candidates.isTooNear(candidate, chosen, k)) {
                        chosen[k] = candidate;
                        double now = score(chosen);
                        if (now > most) {
                            most = now;
                            which = k;
                            what = candidate;
                        }
                        chosen[k] = before;
                    }
                }
            }
            if (which < 0) {
                return;
            }
            chosen[which] = what;
            score = most;
        }
    }
}
