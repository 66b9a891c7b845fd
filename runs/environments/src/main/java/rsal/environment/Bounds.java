package rsal.environment;

/// Limits of numbers, for observations and actions.
final class Bounds {
    private Bounds() {}

    /// Writes a position, each coordinate of which is at most as large as a limit.
    ///
    /// @param at index of x; y follows
    static void put(double x, double y, float max, float[] to, int at) {
        to[at] = Math.clamp((float) x, -max, max);
        to[at + 1] = Math.clamp((float) y, -max, max);
    }

    /// @param times how often
    /// @param one limits of each time
    /// @return them one after the other
    static float[] repeated(int times, float... one) {
        var all = new float[times * one.length];
        for (int i = 0; i < times; i++) {
            System.arraycopy(one, 0, all, i * one.length, one.length);
        }
        return all;
    }
}
