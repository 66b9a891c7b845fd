package rsal.player.device;

import java.util.List;
import rsal.data.Pose2d;
import rsal.player.message.Interface;
import rsal.player.message.Pose3;
import rsal.player.message.Ranger;
import rsal.player.wire.Address;

/// Ranges of Player's as ours (REP 117): the longest there is stands for nothing there.
final class Ranges {
    static final double WIDEST = 2 * Math.PI + 0.1; // [rad]; what is said to see more is wrong

    private Ranges() {}

    /// What to ask of a device that measures ranges.
    ///
    /// @param geometry the request for that, where it is no `ranger`
    static List<Integer> questions(Address device, int geometry) {
        return device.interf() == Interface.RANGER.code()
                ? List.of(Ranger.GEOMETRY, Ranger.CONFIGURATION)
                : List.of(geometry);
    }

    /// Whether a configuration says anything: some drivers leave it at 0 until they know better.
    static boolean isKnown(Ranger.Configuration configuration) {
        double width = configuration.maxAngle() - configuration.minAngle();
        return width > 0 && width < WIDEST && configuration.maxRange() > 0;
    }

    /// Where the elements of a ranger are: in the frame of the ranger, as Stage has it; but some drivers say
    /// of one what they say of the ranger.
    static List<Pose2d> places(Ranger.Geometry geometry) {
        Pose2d baseFromRanger = geometry.pose().to2d();
        return geometry.poses().stream()
                .map(Pose3::to2d)
                .map(place -> place.equals(baseFromRanger) ? place : baseFromRanger.compose(place))
                .toList();
    }

    static float[] of(double[] ranges, double min, double max) {
        var ours = new float[ranges.length];
        for (int i = 0; i < ours.length; i++) {
            ours[i] = one((float) ranges[i], (float) min, (float) max);
        }
        return ours;
    }

    static float[] of(float[] ranges, double min, double max) {
        var ours = new float[ranges.length];
        for (int i = 0; i < ours.length; i++) {
            ours[i] = one(ranges[i], (float) min, (float) max);
        }
        return ours;
    }

    private static float one(float range, float min, float max) {
        if (range >= max) {
            return Float.POSITIVE_INFINITY;
        }
        return range < min ? Float.NEGATIVE_INFINITY : range;
    }
}
