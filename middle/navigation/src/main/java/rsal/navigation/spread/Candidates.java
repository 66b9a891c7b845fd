package rsal.navigation.spread;

import java.util.Arrays;
import rsal.data.OccupancyGrid;
import rsal.data.Point2d;

/// Places of which some are chosen for a team: the middles of at most 2000 [Patches] of a [ReachableSpace],
/// with the lengths of the paths between all pairs. Immutable.
final class Candidates {
    private static final int ROOMY_PER_PLACE = 4;

    private final ReachableSpace ground;
    private final Patches patches;
    private final int count;
    private final float[] lengths; // of paths [m], by pair
    private final Point2d[] places; // in the map frame [m]

    Candidates(ReachableSpace ground) {
        this.ground = ground;
        int side = Patches.side(ground.cells().length, PatchDistances.MOST);
        this.patches = Patches.atMost(ground, new Patches(ground, side), 1, PatchDistances.MOST);
        this.count = patches.count();
        OccupancyGrid map = ground.map();
        double unit = patches.side() * map.resolution() / Patches.FINENESS; // m
        this.lengths = PatchDistances.between(patches).squares();
        for (int pair = 0; pair < lengths.length; pair++) {
            lengths[pair] = (float) (Math.sqrt(lengths[pair]) * unit);
        }
        this.places = new Point2d[count];
        for (int i = 0; i < count; i++) {
            places[i] = map.middle(patches.place(i));
        }
    }

    ReachableSpace ground() {
        return ground;
    }

    int count() {
        return count;
    }

    /// Of the path between two [m].
    float length(int from, int to) {
        return lengths[from * count + to];
    }

    /// In the map frame [m].
    Point2d place(int candidate) {
        return places[candidate];
    }

    /// Number of the cell that it is in.
    int cell(int candidate) {
        return patches.place(candidate);
    }

    /// How many cells of the ground it stands for.
    int weight(int candidate) {
        return patches.weight(candidate);
    }

    /// Where robots may stand: where two fit side by side, so that none blocks a door; anywhere when less than
    /// half of the ground is so wide, or little for so many.
    int[] standing(int number) {
        var may = new int[count];
        int roomy = 0;
        for (int i = 0; i < count; i++) {
            if (patches.roomy()[i]) {
                may[roomy++] = i;
            }
        }
        if (roomy >= count / 2 && roomy >= (long) ROOMY_PER_PLACE * number) {
            return Arrays.copyOf(may, roomy);
        }
        Arrays.setAll(may, i -> i);
        return may;
    }

    /// Whether two are nearer to each other than twice the clearance, straight.
    boolean areTooNear(int one, int other) {
        Point2d from = places[one];
        Point2d to = places[other];
        double least = 2 * ground.clearance();
        return Math.abs(from.x() - to.x()) < least
                && Math.abs(from.y() - to.y()) < least
                && from.distanceTo(to) < least;
    }

    /// Whether one is too near to any of some others.
    ///
    /// @param but index of the one that does not count, or -1
    boolean isTooNear(int candidate, int[] chosen, int but) {
        for (int k = 0; k < chosen.length; k++) {
            if (k != but && areTooNear(candidate, chosen[k])) {
                return true;
            }
        }
        return false;
    }

    /// The one that is nearest to a place, straight.
    int nearest(Point2d place) {
        int nearest = 0;
        for (int i = 1; i < count; i++) {
            nearest = places[i].distanceTo(place) < places[nearest].distanceTo(place) ? i : nearest;
        }
        return nearest;
    }

    /// Least path between two of some [m]; infinite for fewer.
    double least(int[] chosen) {
        double least = Double.POSITIVE_INFINITY;
        for (int i = 0; i < chosen.length; i++) {
            for (int j = 0; j < i; j++) {
                least = Math.min(least, length(chosen[i], chosen[j]));
            }
        }
        return least;
    }

    /// Greatest path from any candidate to the nearest of some [m].
    double greatest(int[] chosen) {
        double greatest = 0;
        for (int i = 0; i < count; i++) {
            double nearest = Double.POSITIVE_INFINITY;
            for (int place : chosen) {
                nearest = Math.min(nearest, length(place, i));
            }
            greatest = Math.max(greatest, nearest);
        }
        return greatest;
    }
}
