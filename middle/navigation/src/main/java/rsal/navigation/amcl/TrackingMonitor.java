package rsal.navigation.amcl;

/// How likely a pose is right that was known once and has been followed by unbroken odometry since: the same sequential
/// test as [LocalizationMonitor], of a right pose in a place that differs from its map against a wrong pose.
///
/// A pose that was found on the map must fit it; one that was followed may be in a room that has changed. What beams do
/// at both was counted in the cases of `rsal bench navigation --only amcl.honest`: with a third of the furniture moved,
/// furniture or people added, or a fifth of the walls drawn elsewhere, 60 to 100 % of the beams of a scan end at walls
/// at the right pose, and 0 to 26 % go through. At wrong poses, refined, 0 to 55 % end at walls, and 15 to 80 % go
/// through. So what tells them apart is how many beams the map explains, and less so how many go through walls.
final class TrackingMonitor {
    private static final double HIT = Math.log(0.75 / 0.28);
    private static final double THROUGH = Math.log(0.08 / 0.4);
    private static final double SHORT = Math.log(0.17 / 0.32);
    private static final double SAME_AS_BEFORE = 0.15; // of what a scan says is new: a wrong wall stays in sight
    private static final double MOST_OF_A_SCAN = 1.5;
    private static final double MOST = 8;
    private static final double LEAST = -4;
    private static final double PLAUSIBLE = 3;
    private static final double REFUTED = -2;
    private static final double NEWEST = 0.1; // share of the newest scan in what is followed

    private final double independentBeams;
    private double log; // of the odds of a right pose
    private double explained = 1; // share of the beams that end at walls, of the last scans

    /// @param independentBeams number of independent beams for which a scan counts
    TrackingMonitor(double independentBeams) {
        this.independentBeams = independentBeams;
    }

    /// For a pose of which nothing is known: as likely right as wrong.
    void restart() {
        log = 0;
        explained = 1;
    }

    /// For a pose that is known to be right.
    void trust() {
        log = MOST;
        explained = 1;
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
        explained += NEWEST * Math.min(1, reported / independentBeams) * ((double) hits / reported - explained);
    }

    /// Share of the beams that ended at walls of the map, of the last scans.
    double explained() {
        return explained;
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
