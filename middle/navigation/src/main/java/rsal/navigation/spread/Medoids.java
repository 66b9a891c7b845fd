package rsal.navigation.spread;

import java.util.Arrays;
import java.util.random.RandomGenerator;

/// Chooses some of a few thousand [Patches] such that the squares of all ways to the nearest are least, knowing the
/// ways between all.
///
/// Seeds are drawn far from each other: D. Arthur, S. Vassilvitskii, k-means++: The Advantages of Careful Seeding
/// (SODA 2007), with ways in place of straight distances. Then one is swapped for another as long as that helps
/// (L. Kaufman, P. Rousseeuw, Finding Groups in Data, 1990: PAM), eagerly and with what removing each loses kept at
/// hand (E. Schubert, P. Rousseeuw, Fast and eager k-medoids clustering, Information Systems 101, 2021,
/// algorithm 3). Swaps lead out of where S. Lloyd's steps (Least squares quantization in PCM, 1982) get stuck: a place
/// too many in one part of the floor and one too few in another.
///
/// Not safe for several threads at once.
final class Medoids {
    private static final int MOST_ROUNDS = 50;

    private final int size;
    private final double[] weights;
    private final float[] squares;
    private final float beyond;
    private final float[] nearest;
    private final float[] second;
    private final int[] nearestOf;

    Medoids(PatchDistances distances) {
        this.size = distances.size();
        this.weights = distances.weights();
        this.squares = distances.squares();
        this.beyond = distances.beyond();
        this.nearest = new float[size];
        this.second = new float[size];
        this.nearestOf = new int[size];
    }

    /// Draws seeds.
    ///
    /// @param may who may be chosen: at least so many
    int[] seed(int number, boolean[] may, RandomGenerator random) {
        var chosen = new int[number];
        Arrays.fill(nearest, 1);
        for (int i = 0; i < number; i++) {
            chosen[i] = draw(may, random);
            int row = chosen[i] * size;
            for (int to = 0; to < size; to++) {
                nearest[to] = i == 0 ? squares[row + to] : Math.min(nearest[to], squares[row + to]);
            }
        }
        return chosen;
    }

    /// By weight and the square of what is nearest.
    private int draw(boolean[] may, RandomGenerator random) {
        double total = 0;
        for (int i = 0; i < size; i++) {
            total += may[i] ? weights[i] * nearest[i] : 0;
        }
        double left = random.nextDouble() * total;
        int last = 0;
        for (int i = 0; i < size; i++) {
            if (may[i] && nearest[i] > 0) {
                last = i;
                left -= weights[i] * nearest[i];
                if (left < 0) {
                    return i;
                }
            }
        }
        return last;
    }

    /// Draws different patches by their weight alone.
    int[] anywhere(int number, RandomGenerator random) {
        var chosen = new int[number];
        var may = new boolean[size];
        Arrays.fill(may, true);
        Arrays.fill(nearest, 1);
        for (int i = 0; i < number; i++) {
            chosen[i] = draw(may, random);
            nearest[chosen[i]] = 0;
        }
        return chosen;
    }

    /// Swaps while that helps.
    ///
    /// @param chosen changed
    /// @param may who may be chosen
    /// @return the sum of squares in the end
    double swap(int[] chosen, boolean[] may) {
        var losses = new double[chosen.length];
        var changes = new double[chosen.length];
        assign(chosen);
        double sum = sum(losses);
        int sinceLast = 0;
        for (int i = 0; sinceLast < size && i < MOST_ROUNDS * size; i++, sinceLast++) {
            int candidate = i % size;
            if (!may[candidate]) {
                continue;
            }
            double change = change(candidate, losses, changes);
            int best = 0;
            for (int k = 1; k < chosen.length; k++) {
                best = changes[k] < changes[best] ? k : best;
            }
            if (change + changes[best] < -1e-7 * sum) {
                exchange(chosen, best, candidate);
                sum = sum(losses);
                sinceLast = 0;
            }
        }
        return sum;
    }

    /// What adding a candidate changes, and what removing each of the chosen then changes besides.
    private double change(int candidate, double[] losses, double[] changes) {
        System.arraycopy(losses, 0, changes, 0, losses.length);
        int row = candidate * size;
        double change = 0;
        for (int to = 0; to < size; to++) {
            float square = squares[row + to];
            if (square < nearest[to]) {
                change += weights[to] * ((double) square - nearest[to]);
                changes[nearestOf[to]] += weights[to] * ((double) nearest[to] - second[to]);
            } else if (square < second[to]) {
                changes[nearestOf[to]] += weights[to] * ((double) square - second[to]);
            }
        }
        return change;
    }

    /// Of the squares of all.
    ///
    /// @param losses by chosen what removing it would add
    private double sum(double[] losses) {
        Arrays.fill(losses, 0);
        double sum = 0;
        for (int to = 0; to < size; to++) {
            sum += weights[to] * nearest[to];
            losses[nearestOf[to]] += weights[to] * ((double) second[to] - nearest[to]);
        }
        return sum;
    }

    /// Puts a candidate in place of one of the chosen. Afterwards all is as [#assign] has it; the others of the chosen
    /// are looked at only for those to whom the old one was one of the two nearest.
    private void exchange(int[] chosen, int k, int candidate) {
        int oldRow = chosen[k] * size;
        int newRow = candidate * size;
        chosen[k] = candidate;
        for (int to = 0; to < size; to++) {
            float square = squares[newRow + to];
            if (squares[oldRow + to] <= second[to]) {
                assign(chosen, to);
            } else if (square < nearest[to] || (square == nearest[to] && k < nearestOf[to])) {
                second[to] = nearest[to];
                nearest[to] = square;
                nearestOf[to] = k;
            } else if (square < second[to]) {
                second[to] = square;
            }
        }
    }

    /// Finds the two nearest of the chosen for everyone.
    private void assign(int[] chosen) {
        for (int to = 0; to < size; to++) {
            assign(chosen, to);
        }
    }

    /// Finds the two nearest of the chosen for one patch; of two that are equally near, the first.
    private void assign(int[] chosen, int to) {
        float least = beyond;
        float next = beyond;
        int leastOf = 0;
        for (int k = 0; k < chosen.length; k++) {
            float square = squares[chosen[k] * size + to];
            if (square < least) {
                next = least;
                least = square;
                leastOf = k;
            } else if (square < next) {
                next = square;
            }
        }
        nearest[to] = least;
        second[to] = next;
        nearestOf[to] = leastOf;
    }

    /// Lloyd's steps, with the exact medoid of each region in place of its mean, until nothing changes.
    ///
    /// @param chosen changed
    void lloyd(int[] chosen) {
        boolean changed = true;
        for (int round = 0; changed && round < MOST_ROUNDS; round++) {
            assign(chosen);
            changed = false;
            for (int k = 0; k < chosen.length; k++) {
                int medoid = medoid(k, chosen[k]);
                changed |= medoid != chosen[k];
                chosen[k] = medoid;
            }
        }
    }

    private int medoid(int region, int current) {
        int best = current;
        double least = spent(region, current, Double.POSITIVE_INFINITY);
        for (int candidate = 0; candidate < size; candidate++) {
            if (nearestOf[candidate] == region) {
                double sum = spent(region, candidate, least);
                if (sum < least) {
                    least = sum;
                    best = candidate;
                }
            }
        }
        return best;
    }

    private double spent(int region, int from, double atMost) {
        double sum = 0;
        for (int to = 0; to < size && sum <= atMost; to++) {
            if (nearestOf[to] == region) {
                sum += weights[to] * squares[from * size + to];
            }
        }
        return sum;
    }
}
