package rsal.navigation.amcl;

/// Whether more beams go through walls than usual, which is a reason to look elsewhere. What is above the usual share
/// is summed up, as E. Page does to find changes (Continuous Inspection Schemes, Biometrika 41, 1954).
final class MisfitMonitor {
    private static final double NEWEST = 0.1; // share of the newest scan in what is followed
    private static final double NO_MISFIT = 0.02; // share of beams; as many may go through walls anywhere
    private static final double MOST_MISFIT = 0.2; // the same, of one scan, or a moment would do
    private static final double DOUBTFUL = 0.5; // sum of misfits
    private static final double USUAL_FOR = 0.99; // share of what is usual that is left by each update

    private double misfit; // share of the beams that went through walls, of the last scans
    private double usual; // as many did when nothing elsewhere fitted better
    private double doubt; // sum of what misfits were above that

    void restart() {
        misfit = 0;
        usual = 0;
        doubt = 0;
    }

    /// Takes up how many of the beams of a scan went through walls.
    void add(int through, int reported) {
        if (reported > 0) {
            double now = (double) through / reported;
            misfit += NEWEST * (now - misfit);
            usual *= USUAL_FOR;
            doubt = Math.max(0, doubt + Math.min(MOST_MISFIT, now - usual - NO_MISFIT));
        }
    }

    boolean isDoubtful() {
        return doubt > DOUBTFUL;
    }

    /// It was looked elsewhere: what is now is usual.
    void settle() {
        doubt = 0;
        usual = misfit;
    }
}
