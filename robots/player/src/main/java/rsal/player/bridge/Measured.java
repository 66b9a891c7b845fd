package rsal.player.bridge;

/// Ranges as Player has them: what hit nothing, or is broken, has the longest range there is; what is too near has 0.
final class Measured {
    private Measured() {}

    static float[] floats(float[] ranges, double rangeMax) {
        var floats = new float[ranges.length];
        for (int i = 0; i < ranges.length; i++) {
            floats[i] = one(ranges[i], (float) rangeMax);
        }
        return floats;
    }

    static double[] doubles(float[] ranges, double rangeMax) {
        var doubles = new double[ranges.length];
        for (int i = 0; i < ranges.length; i++) {
            doubles[i] = one(ranges[i], (float) rangeMax);
        }
        return doubles;
    }

    private static float one(float range, float rangeMax) {
        return range <= rangeMax ? Math.max(0, range) : rangeMax;
    }
}
