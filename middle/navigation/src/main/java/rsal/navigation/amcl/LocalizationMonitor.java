package rsal.navigation.amcl;

/// How likely the believed pose is right by what scans say of it alone, whatever else could be.
///
/// What beams do at right and at wrong poses was counted on seven public logs with maps of half of their scans, and
/// on drawn offices and loops after robots had been carried off: at a right pose 2 to 9 % went through walls over
/// ten scans, at wrong ones that had been believed 4 to 35 %. What ends short of a wall may be somebody: it speaks
/// against the pose only when seven of ten beams do, as a robot among robots is right, too.
final class LocalizationMonitor extends PoseEvidence {
    private static final double RIGHT = 0.04; // of the beams that tell go through walls
    private static final double WRONG = 0.16; // the same
    private static final double HIT = Math.log((1 - RIGHT) / (1 - WRONG));
    private static final double THROUGH = Math.log(RIGHT / WRONG);
    private static final double SHORT = -0.4 * HIT;
    private static final double SAME_AS_BEFORE = 0.5; // of what a scan says the one before has said already
    private static final double MOST_OF_A_SCAN =
            3; // of logarithm; who stands before the laser for a moment is no reason

    /// @param independentBeams number of independent beams for which a scan counts
    LocalizationMonitor(double independentBeams) {
        super(new Weights(HIT, THROUGH, SHORT, SAME_AS_BEFORE, MOST_OF_A_SCAN), independentBeams);
    }
}
