package rsal.data;

/// What sensors say that measure ranges [m], after REP 117: −∞ too close to measure, +∞ nothing there, NaN broken. And
/// 0,
/// where that is not too close, is no reading either: drivers say so of beams that measured nothing.
public final class Rep117 {
    private Rep117() {}

    /// Whether something was measured; false for nothing there, too close, and no reading.
    ///
    /// @param least shortest range that the sensor measures
    /// @param most longest range that the sensor measures
    public static boolean isHit(double shown, double least, double most) {
        return shown >= least && shown <= most && shown > 0;
    }

    /// How far off something is: what is too close is at the least range, +∞ where nothing is, NaN without a reading.
    ///
    /// @param least shortest range that the sensor measures
    public static double distance(double shown, double least) {
        if (shown < least) {
            return least;
        }
        return shown == 0 ? Double.NaN : shown;
    }
}
