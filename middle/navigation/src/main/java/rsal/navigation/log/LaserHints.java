package rsal.navigation.log;

import java.util.Optional;

/// What a person knows of the laser that a log was made with.
///
/// @param fieldOfView between its first and its last beam, for logs that do not say it [rad]
/// @param rangeMax ranges from here on hit nothing [m]
/// @param upsideDown whether the laser was mounted upside down, so that its ranges go clockwise in the log
/// @param topic that has its scans, for logs with several topics of scans; empty for the one with the most
public record LaserHints(double fieldOfView, double rangeMax, boolean upsideDown, Optional<String> topic) {
    /// Half a turn, and 50 m: less than lasers of SICK send for nothing, more than they see.
    public static final LaserHints DEFAULT = new LaserHints(Math.PI, 50, false, Optional.empty());

    public LaserHints {
        if (!(fieldOfView > 0 && fieldOfView <= 2 * Math.PI)) {
            throw new IllegalArgumentException(
                    "A field of view must be in (0, 2 π] rad, not '%s'.".formatted(fieldOfView));
        }
        if (!(rangeMax > 0)) {
            throw new IllegalArgumentException(
                    "The longest range must be more than 0 m, not '%s'.".formatted(rangeMax));
        }
    }
}
