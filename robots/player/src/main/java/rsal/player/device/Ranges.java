package rsal.player.device;

/// Ranges of Player's as ours (REP 117): the longest there is stands for nothing there.
final class Ranges {
    private Ranges() {}

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
