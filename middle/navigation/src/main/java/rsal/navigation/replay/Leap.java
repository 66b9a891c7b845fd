package rsal.navigation.replay;

import java.time.Duration;
import rsal.data.Angles;
import rsal.navigation.replay.RecordedDrive.Stop;

/// A step of a log's odometry that no robot makes: its counters were reset, overflowed, or somebody set the odometry.
///
/// @param line of the scan behind it
/// @param meters how far it leads
/// @param radians how far it turns, not negative
/// @param seconds it takes, above 0
public record Leap(int line, double meters, double radians, double seconds) {
    private static final double FASTEST = 5; // m/s; of robots that map floors
    private static final double FASTEST_TURN = 7; // rad/s; 400° a second
    private static final double LEAST_METERS = 0.3; // less is a matter of when scans were stamped
    private static final double LEAST_RADIANS = 0.5;

    /// Whether it can't be that the robot drove so.
    static boolean isBetween(Stop before, Stop after) {
        return between(before, after).isLeap();
    }

    static Leap between(Stop before, Stop after) {
        return new Leap(
                after.line(),
                before.odomFromBase().distanceTo(after.odomFromBase()),
                Math.abs(Angles.difference(
                        before.odomFromBase().theta(), after.odomFromBase().theta())),
                Duration.between(before.time(), after.time()).toNanos() * 1e-9);
    }

    private boolean isLeap() {
        return seconds > 0
                && ((meters > LEAST_METERS && meters > FASTEST * seconds)
                        || (radians > LEAST_RADIANS && radians > FASTEST_TURN * seconds));
    }
}
