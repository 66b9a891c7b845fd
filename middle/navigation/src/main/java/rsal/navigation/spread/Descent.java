package rsal.navigation.spread;

import java.util.Arrays;

/// Moves places over [Patches] downhill, each to the neighbor from which the squares of ways to all of its region are
/// least, until none is better: S. Lloyd, Least squares quantization in PCM (1982), and J. Cortés et al., Coverage
/// control for mobile sensing networks (IEEE Transactions on Robotics and Automation 20, 2004), in regions that are
/// not convex and by ways that bend around walls as in S. Bhattacharya, R. Ghrist, V. Kumar, Multi-robot coverage
/// and exploration on Riemannian manifolds with boundaries (IJRR 33, 2014), and S.-k. Yun, D. Rus, Distributed
/// coverage with mobile robots on a graph (Robotics and Autonomous Systems 62, 2014).
///
/// Departs from the former in that steps are tried, not computed from a gradient: the sum falls with every step, so
/// that it ends, and it never leaves the ground. All places try their steps in the same flood, as their regions
/// don't touch each other. A place that found no better neighbor tries again only when its region has changed.
final class Descent {
    private static final int MOST_STEPS = 400;
    private static final double ENOUGH = 1e-5; // of the sum; less is not worth a step

    private final Patches patches;
    private final Flood regions;
    private final Flood tries;

    Descent(Patches patches) {
        this.patches = patches;
        this.regions = new Flood(patches);
        this.tries = new Flood(patches);
    }

    /// @param at patches of the places, each another; changed
    /// @param may where places may go
    /// @return the sum of squares in the end
    double descend(int[] at, boolean[] may) {
        var best = at.clone();
        var least = new double[at.length];
        var sums = new double[at.length];
        var owners = new int[patches.count()];
        Arrays.fill(owners, Flood.NOBODY);
        var settled = new boolean[at.length]; // whether trying again would give nothing new
        double before = Double.POSITIVE_INFINITY;
        for (int step = 0; ; step++) {
            regions.clear();
            for (int place = 0; place < at.length; place++) {
                regions.source(at[place], place);
            }
            regions.flood();
            regions.squares(least);
            double sum = 0;
            for (double one : least) {
                sum += one;
            }
            if (step == MOST_STEPS || sum > before * (1 - ENOUGH)) {
                return sum;
            }
            before = sum;
            for (int patch = 0; patch < owners.length; patch++) {
                int owner = regions.owner(patch);
                if (owner != owners[patch]) {
                    unsettle(settled, owners[patch]);
                    unsettle(settled, owner);
                    owners[patch] = owner;
                }
            }
            for (int neighbor = 0; tryNeighbors(neighbor, at, owners, may, settled); neighbor++) {
                tries.squares(sums);
                for (int place = 0; place < at.length; place++) {
                    int to = neighbor(at[place], neighbor);
                    if (isTried(place, to, owners, may, settled) && sums[place] < least[place]) {
                        least[place] = sums[place];
                        best[place] = to;
                    }
                }
            }
            for (int place = 0; place < at.length; place++) {
                settled[place] = best[place] == at[place];
                at[place] = best[place];
            }
        }
    }

    private static void unsettle(boolean[] settled, int place) {
        if (place != Flood.NOBODY) {
            settled[place] = false;
        }
    }

    private static boolean isTried(int place, int to, int[] owners, boolean[] may, boolean[] settled) {
        return !settled[place] && to >= 0 && owners[to] == place && may[to];
    }

    /// Floods each region that is not settled from its place's neighbor of some number.
    ///
    /// @return whether any has so many
    private boolean tryNeighbors(int number, int[] at, int[] owners, boolean[] may, boolean[] settled) {
        tries.clear();
        boolean any = false;
        for (int place = 0; place < at.length; place++) {
            int to = neighbor(at[place], number);
            any |= !settled[place] && to >= 0;
            if (isTried(place, to, owners, may, settled)) {
                tries.source(to, place);
            }
        }
        if (any) {
            tries.flood(owners);
        }
        return any;
    }

    private int neighbor(int patch, int number) {
        int index = patches.first(patch) + number;
        return index < patches.first(patch + 1) ? patches.neighbor(index) : -1;
    }
}
