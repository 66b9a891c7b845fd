package rsal.navigation.amcl;

/// A sequential test of a right pose against a wrong one by what becomes of beams there: A. Wald, Sequential Tests
/// of Statistical Hypotheses (Annals of Mathematical Statistics 16, 1945). The sum is held within bounds, as E. Page
/// does to find changes (Continuous Inspection Schemes, Biometrika 41, 1954): what was right for an hour may be
/// wrong in a second.
abstract class PoseEvidence {
    private static final double MOST = 8;
    private static final double LEAST = -4;
    private static final double PLAUSIBLE = 3;
    private static final double REFUTED = -2;

    private final Weights weights;
    private final double independentBeams;
    private double log; // of the odds of a right pose

    /// What beams say: logarithms of how much likelier they are at a right pose than at a wrong one.
    ///
    /// @param hit of a beam that ends at a wall
    /// @param through of one that goes through a wall
    /// @param shorter of one that ends before a wall
    /// @param fresh share of what a scan says that the one before has not said already
    /// @param mostOfAScan bound of what one scan says
    record Weights(double hit, double through, double shorter, double fresh, double mostOfAScan) {}

    /// @param independentBeams number of independent beams for which a scan counts
    PoseEvidence(Weights weights, double independentBeams) {
        this.weights = weights;
        this.independentBeams = independentBeams;
    }

    /// For a pose of which nothing is known: as likely right as wrong.
    void restart() {
        log = 0;
    }

    /// For a pose that is known to be right.
    void trust() {
        log = MOST;
    }

    /// Takes up what became of the beams of a scan.
    ///
    /// @param shorter ended before a wall
    void add(int hits, int through, int shorter) {
        int reported = hits + through + shorter;
        if (reported == 0) {
            return;
        }
        double said = hits * weights.hit + through * weights.through + shorter * weights.shorter;
        double counted = weights.fresh * Math.min(1, independentBeams / reported) * said;
        log = Math.clamp(log + Math.clamp(counted, -weights.mostOfAScan, weights.mostOfAScan), LEAST, MOST);
    }

    /// That the pose is right, from 0.02 to 1.
    double probability() {
        return 1 / (1 + Math.exp(-log));
    }

    /// Whether scans speak for the pose, 20 to 1 at least.
    boolean isPlausible() {
        return log >= PLAUSIBLE;
    }

    /// Whether scans speak for the pose at all.
    boolean speaksFor() {
        return log > 0;
    }

    /// Whether scans speak against the pose, 7 to 1 at least.
    boolean isRefuted() {
        return log <= REFUTED;
    }
}
