package rsal.player.device;

import java.util.List;
import rsal.player.message.Interface;
import rsal.player.message.Ranger;
import rsal.player.wire.Address;

/// Ranges of Player's as ours (REP 117): the longest there is stands for nothing there.
final class Ranges {
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
        return configuration.maxAngle() > configuration.minAngle() && configuration.maxRange() > 0;
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
