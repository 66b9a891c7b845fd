package rsal.navigation.spread;

/// Moves places over [Patches] downhill, each to the neighbor from which the squares of ways to all of its region are
/// least, until none is better: S. Lloyd, Least squares quantization in PCM (1982), and J. Cortés et al., Coverage
/// control for mobile sensing networks (IEEE Transactions on Robotics and Automation 20, 2004), in regions that are
/// not convex and by ways that bend around walls as in S. Bhattacharya, R. Ghrist, V. Kumar, Multi-robot coverage
/// and exploration on Riemannian manifolds with boundaries (IJRR 33, 2014), and S.-k. Yun, D. Rus, Distributed
/// coverage with mobile robots on a graph (Robotics and Autonomous Systems 62, 2014).
///
/// Departs from the former in that steps are tried, not computed from a gradient: the sum falls with every step, so
/// that it ends, and it never leaves the ground. All places try their steps in the same flood, as their regions
/// don't touch each other.
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
                owners[patch] = regions.owner(patch);
            }
            for (int neighbor = 0; tryNeighbors(neighbor, at, owners, may); neighbor++) {
                tries.squares(sums);
                for (int place = 0; place < at.length; place++) {
                    int to = neighbor(at[place], neighbor);
                    if (to >= 0 && owners[to] == place && may[to] && sums[place] < least[place]) {
                        least[place] = sums[place];
                        best[place] = to;
                    }
                }
            }
            System.arraycopy(best, 0, at, 0, at.length);
        }
    }

    /// Floods each region from its place's neighbor of some number.
    ///
    /// @return whether any has so many
    private boolean tryNeighbors(int number, int[] at, int[] owners, boolean[] may) {
        tries.clear();
        boolean any = false;
        for (int place = 0; place < at.length; place++) {
            int to = neighbor(at[place], number);
            any |= to >= 0;
            if (to >= 0 && owners[to] == place && may[to]) {
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
