package rsal.navigation.amcl;

/// How likely a pose is right that was known once and has been followed by unbroken odometry since: a right
/// pose in a place that differs from its map against a wrong pose.
///
/// A pose that was found on the map must fit it; one that was followed may be in a room that has changed. What beams do
/// at both was counted in the cases of `rsal bench navigation --only amcl.honest`: with a third of the furniture moved,
/// furniture or people added, or a fifth of the walls drawn elsewhere, 60 to 100 % of the beams of a scan end at walls
/// at the right pose, and 0 to 26 % go through. At wrong poses, refined, 0 to 55 % end at walls, and 15 to 80 % go
/// through. So what tells them apart is how many beams the map explains, and less so how many go through walls.
final class TrackingMonitor extends PoseEvidence {
    private static final double HIT = Math.log(0.75 / 0.28);
    private static final double THROUGH = Math.log(0.08 / 0.4);
    private static final double SHORT = Math.log(0.17 / 0.32);
    private static final double SAME_AS_BEFORE = 0.15; // of what a scan says is new: a wrong wall stays in sight
    private static final double MOST_OF_A_SCAN = 1.5;
    private static final double NEWEST = 0.1; // share of the newest scan in what is followed

    private final double independentBeams;
    private double explained = 1; // share of the beams that end at walls, of the last scans

    /// @param independentBeams number of independent beams for which a scan counts
    TrackingMonitor(double independentBeams) {
        super(new Weights(HIT, THROUGH, SHORT, SAME_AS_BEFORE, MOST_OF_A_SCAN), independentBeams);
        this.independentBeams = independentBeams;
    }

    @Override
    void restart() {
        super.restart();
        explained = 1;
    }

    @Override
    void trust() {
        super.trust();
        explained = 1;
    }

    @Override
    void add(int hits, int through, int shorter) {
        super.add(hits, through, shorter);
        int reported = hits + through + shorter;
        if (reported > 0) {
            explained += NEWEST * Math.min(1, reported / independentBeams) * ((double) hits / reported - explained);
        }
    }

    /// Share of the beams that ended at walls of the map, of the last scans.
    double explained() {
        return explained;
    }

    /// Whether the map explains so little that the robot may be elsewhere.
    boolean isDoubtful() {
        return explained < Challengers.DOUBTFUL;
    }
}
