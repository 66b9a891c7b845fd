package rsal.navigation.amcl;

/// How likely the believed pose is right by what scans say of it alone, whatever else could be: a sequential test of
/// a right pose against a wrong one. A. Wald, Sequential Tests of Statistical Hypotheses (Annals of Mathematical
/// Statistics 16, 1945), with bounds at which the sum is held, as E. Page does to find changes (Continuous Inspection
/// Schemes, Biometrika 41, 1954): what was right for an hour may be wrong in a second.
///
/// What beams do at right and at wrong poses was counted on seven public logs with maps of half of their scans, and
/// on drawn offices and loops after robots had been carried off: at a right pose 2 to 9 % went through walls over
/// ten scans, at wrong ones that had been believed 4 to 35 %. What ends short of a wall may be somebody: it speaks
/// against the pose only when seven of ten beams do, as a robot among robots is right, too.
final class LocalizationMonitor {
    private static final double RIGHT = 0.04; // of the beams that tell go through walls
    private static final double WRONG = 0.16; // the same
    private static final double HIT = Math.log((1 - RIGHT) / (1 - WRONG));
    private static final double THROUGH = Math.log(RIGHT / WRONG);
    private static final double SHORT = -0.4 * HIT;
    private static final double SAME_AS_BEFORE = 0.5; // of what a scan says the one before has said already
    private static final double MOST_OF_A_SCAN =
            3; // of logarithm; who stands before the laser for a moment is no reason
    private static final double MOST = 8;
    private static final double LEAST = -4;
    private static final double PLAUSIBLE = 3;
    private static final double REFUTED = -2;

    private final double independentBeams;
    private double log; // of the odds of a right pose

    /// @param independentBeams number of independent beams for which a scan counts
    LocalizationMonitor(double independentBeams) {
        this.independentBeams = independentBeams;
    }

    /// For a pose of which nothing is known: as likely right as wrong.
    void restart() {
        log = 0;
    }

    /// For a pose that somebody knows to be right.
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
        double said = hits * HIT + through * THROUGH + shorter * SHORT;
        double counted = SAME_AS_BEFORE * Math.min(1, independentBeams / reported) * said;
        log = Math.clamp(log + Math.clamp(counted, -MOST_OF_A_SCAN, MOST_OF_A_SCAN), LEAST, MOST);
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
