package rsal.navigation.spread;

import java.util.Arrays;
import java.util.BitSet;
import rsal.data.OccupancyGrid;
import rsal.data.Point2d;
import rsal.navigation.grid.DistanceField;

/// Makes the part of the floor great that is in straight sight of some places, up to 30 m away: one after
/// the other that adds most (G. Nemhauser, L. Wolsey, M. Fisher, An analysis of approximations for
/// maximizing submodular set functions, Mathematical Programming 14, 1978), then swaps. Departs from them
/// in that at most 500 places are tried, which are spread evenly over the numbers of all, and that places
/// keep twice the clearance. So their bound, 63 % of the best, does not hold for all places: only for the
/// best of those that are tried, where there is so much room that the clearance forbids none.
final class ViewChoice {
    private static final int MOST_TRIED = 500;
    private static final int MOST_SWAPS = 100;
    private static final double SIGHT = 30; // m

    private final Candidates candidates;
    private final int[] may;
    private final BitSet[] seen; // by number in may

    ViewChoice(Candidates candidates, int[] may) {
        this.candidates = candidates;
        int step = Math.max(1, (may.length + MOST_TRIED - 1) / MOST_TRIED);
        this.may = new int[(may.length + step - 1) / step];
        Arrays.setAll(this.may, i -> may[i * step]);
        OccupancyGrid map = candidates.ground().map();
        DistanceField toNotFree = DistanceField.toNotFree(map);
        this.seen = new BitSet[this.may.length];
        for (int i = 0; i < seen.length; i++) {
            seen[i] = seen(candidates.place(this.may[i]), toNotFree);
        }
    }

    private BitSet seen(Point2d from, DistanceField toNotFree) {
        var all = new BitSet(candidates.count());
        for (int i = 0; i < candidates.count(); i++) {
            Point2d to = candidates.place(i);
            double distance = from.distanceTo(to);
            double direction = Math.atan2(to.y() - from.y(), to.x() - from.x());
            if (distance <= SIGHT && toNotFree.castRay(from.x(), from.y(), direction, distance) >= distance) {
                all.set(i);
            }
        }
        return all;
    }

    /// @return empty when there is no room for so many
    int[] choose(int number) {
        var numbers = new int[number];
        int count = 0;
        var covered = new BitSet(candidates.count());
        for (; count < number; count++) {
            int best = -1;
            long most = -1;
            for (int i = 0; i < may.length; i++) {
                long added = weight(seen[i], covered);
                if (added > most && !candidates.isTooNear(may[i], chosen(numbers, count), -1)) {
                    most = added;
                    best = i;
                }
            }
            if (best < 0) {
                return new int[0];
            }
            numbers[count] = best;
            covered.or(seen[best]);
        }
        swap(numbers);
        return chosen(numbers, count);
    }

    private void swap(int[] numbers) {
        for (int swaps = 0; swaps < MOST_SWAPS; swaps++) {
            int which = -1;
            int what = -1;
            long most = covered(numbers, -1, new BitSet());
            for (int k = 0; k < numbers.length; k++) {
                var others = new BitSet(candidates.count());
                long kept = covered(numbers, k, others);
                for (int i = 0; i < may.length; i++) {
                    long now = kept + weight(seen[i], others);
                    if (now > most && !candidates.isTooNear(may[i], chosen(numbers, numbers.length), k)) {
                        most = now;
                        which = k;
                        what = i;
                    }
                }
            }
            if (which < 0) {
                return;
            }
            numbers[which] = what;
        }
    }

    private int[] chosen(int[] numbers, int count) {
        return Arrays.stream(numbers, 0, count).map(number -> may[number]).toArray();
    }

    /// @param into what all but one see
    /// @return its weight
    private long covered(int[] numbers, int but, BitSet into) {
        for (int k = 0; k < numbers.length; k++) {
            if (k != but) {
                into.or(seen[numbers[k]]);
            }
        }
        return weight(into, new BitSet());
    }

    /// Of what some see and others do not [cells].
    private long weight(BitSet some, BitSet others) {
        long weight = 0;
        for (int i = some.nextSetBit(0); i >= 0; i = some.nextSetBit(i + 1)) {
            weight += others.get(i) ? 0 : candidates.weight(i);
        }
        return weight;
    }

    /// Share of the floor that is in sight of some of the places that may be chosen.
    double share(int[] chosen) {
        var all = new BitSet(candidates.count());
        for (int place : chosen) {
            for (int i = 0; i < may.length; i++) {
                if (may[i] == place) {
                    all.or(seen[i]);
                }
            }
        }
        long total = 0;
        for (int i = 0; i < candidates.count(); i++) {
            total += candidates.weight(i);
        }
        return (double) weight(all, new BitSet()) / total;
    }

    /// What may be chosen. Not to be written to.
    int[] may() {
        return may;
    }
}
