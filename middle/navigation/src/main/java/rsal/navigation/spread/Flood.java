package rsal.navigation.spread;

import java.util.Arrays;
import org.jspecify.annotations.Nullable;

/// Lengths of shortest ways over [Patches] from the nearest of several sources, and which that is: E. Dijkstra, 1959,
/// ordered by R. Dial's buckets (Algorithm 360, CACM 12, 1969), since lengths are small whole numbers. The
/// Voronoi regions of the sources by the ways between, found in one go (M. Erwig, The Graph Voronoi Diagram with
/// Applications, Networks 36, 2000).
///
/// Floods again without allocating. Not safe for several threads at once.
final class Flood {
    static final int DRY = Integer.MAX_VALUE;
    static final int NOBODY = -1;

    private static final int NONE = -1;
    private static final int NOT_QUEUED = -2;

    private final Patches patches;
    private final int[] distances;
    private final int[] owners;
    private final int[] next; // in a bucket
    private final int[] previous;
    private final int[] buckets;
    private int queued;

    Flood(Patches patches) {
        this.patches = patches;
        this.distances = new int[patches.count()];
        this.owners = new int[patches.count()];
        this.next = new int[patches.count()];
        this.previous = new int[patches.count()];
        this.buckets = new int[Integer.highestOneBit(patches.longest()) * 2];
        Arrays.fill(buckets, NONE);
        Arrays.fill(previous, NOT_QUEUED);
        clear();
    }

    void clear() {
        Arrays.fill(distances, DRY);
        Arrays.fill(owners, NOBODY);
    }

    /// Adds a source; of several in one patch the first owns it.
    void source(int patch, int owner) {
        if (distances[patch] > 0) {
            reach(patch, 0, owner);
        }
    }

    /// Lets the sources flood everything that they are nearer to than what was flooded before.
    void flood() {
        flood(null);
    }

    /// @param regions by patch who alone may flood it; if null, anyone may flood anything
    void flood(int @Nullable [] regions) {
        for (int now = 0; queued > 0; now++) {
            int bucket = now & (buckets.length - 1);
            while (buckets[bucket] != NONE) {
                int patch = buckets[bucket];
                unlink(patch);
                int owner = owners[patch];
                int end = patches.first(patch + 1);
                for (int number = patches.first(patch); number < end; number++) {
                    int to = patches.neighbor(number);
                    int distance = now + patches.length(number);
                    if (distance < distances[to] && (regions == null || regions[to] == owner)) {
                        reach(to, distance, owner);
                    }
                }
            }
        }
    }

    private void reach(int patch, int distance, int owner) {
        if (previous[patch] != NOT_QUEUED) {
            unlink(patch);
        }
        distances[patch] = distance;
        owners[patch] = owner;
        int bucket = distance & (buckets.length - 1);
        int second = buckets[bucket];
        next[patch] = second;
        previous[patch] = NONE;
        if (second != NONE) {
            previous[second] = patch;
        }
        buckets[bucket] = patch;
        queued++;
    }

    private void unlink(int patch) {
        int before = previous[patch];
        int after = next[patch];
        if (before == NONE) {
            buckets[distances[patch] & (buckets.length - 1)] = after;
        } else {
            next[before] = after;
        }
        if (after != NONE) {
            previous[after] = before;
        }
        previous[patch] = NOT_QUEUED;
        queued--;
    }

    /// How far a patch is from the nearest source, in parts of a block's side ([Patches#FINENESS]); [#DRY] when none
    /// reached it.
    int distance(int patch) {
        return distances[patch];
    }

    /// Whose source is nearest to a patch, or [#NOBODY].
    int owner(int patch) {
        return owners[patch];
    }

    /// Adds up the squares of distances in each owner's region, by the patches' weights.
    ///
    /// @param sums by owner
    void squares(double[] sums) {
        Arrays.fill(sums, 0);
        for (int patch = 0; patch < owners.length; patch++) {
            int owner = owners[patch];
            if (owner != NOBODY) {
                double distance = distances[patch];
                sums[owner] += patches.weight(patch) * distance * distance;
            }
        }
    }
}
