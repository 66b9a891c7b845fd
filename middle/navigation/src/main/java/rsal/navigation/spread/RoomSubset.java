package rsal.navigation.spread;

import java.util.Arrays;

/// Chooses some of at most a few dozen places by branch and bound: the two that are nearest to each other
/// as far apart as possible, then the place that is farthest from all as near as possible. The first is
/// exact. The second is the best of the first 2000 choices that are equally far apart, so it is exact where
/// there are no more. Tries the lengths of paths between places in order by bisection, each by a search for
/// so many places of which all pairs are at least as far apart: a clique, as in E. Erkut, The discrete
/// p-dispersion problem (European Journal of Operational Research 46, 1990).
final class RoomSubset {
    private static final long MOST_STEPS = 2_000_000;
    private static final int MOST_COMPARED = 2_000; // choices that are equally far apart

    private final Candidates candidates;
    private final int[] places;
    private final int number;
    private final int[] chosen;
    private int[] best = new int[0];
    private double leastGreatest = Double.POSITIVE_INFINITY;
    private long steps;
    private int compared;

    private RoomSubset(Candidates candidates, int[] places, int number) {
        this.candidates = candidates;
        this.places = places;
        this.number = number;
        this.chosen = new int[number];
    }

    /// @param number at most as many as there are places
    /// @return empty when the search takes too long to be exact
    static int[] best(Candidates candidates, int[] places, int number) {
        return new RoomSubset(candidates, places, number).search();
    }

    private int[] search() {
        double[] lengths = lengths();
        int low = 0;
        int high = lengths.length - 1;
        while (low < high) {
            int middle = (low + high + 1) >>> 1;
            steps = 0;
            if (isPossible(0, 0, lengths[middle])) {
                low = middle;
            } else if (steps > MOST_STEPS) {
                return new int[0];
            } else {
                high = middle - 1;
            }
        }
        steps = 0;
        compare(0, 0, lengths.length == 0 ? 0 : lengths[low]);
        return best;
    }

    private double[] lengths() {
        var lengths = new double[places.length * (places.length - 1) / 2];
        int next = 0;
        for (int i = 0; i < places.length; i++) {
            for (int j = 0; j < i; j++) {
                lengths[next++] = candidates.length(places[i], places[j]);
            }
        }
        Arrays.sort(lengths);
        return lengths;
    }

    /// Whether the choice can be completed with places from one on, all at least so far apart.
    private boolean isPossible(int count, int from, double least) {
        if (count == number) {
            return true;
        }
        for (int i = from; i <= places.length - (number - count) && steps++ <= MOST_STEPS; i++) {
            if (isFar(places[i], count, least)) {
                chosen[count] = places[i];
                if (isPossible(count + 1, i + 1, least)) {
                    return true;
                }
            }
        }
        return false;
    }

    private boolean isFar(int place, int count, double least) {
        for (int k = 0; k < count; k++) {
            if (candidates.length(place, chosen[k]) < least) {
                return false;
            }
        }
        return true;
    }

    private void compare(int count, int from, double least) {
        if (count == number) {
            double greatest = candidates.greatest(chosen);
            compared++;
            if (greatest < leastGreatest) {
                leastGreatest = greatest;
                best = chosen.clone();
            }
            return;
        }
        for (int i = from; i <= places.length - (number - count); i++) {
            if (compared >= MOST_COMPARED || (steps++ > MOST_STEPS && best.length > 0)) {
                return;
            }
            if (isFar(places[i], count, least)) {
                chosen[count] = places[i];
                compare(count + 1, i + 1, least);
            }
        }
    }
}
