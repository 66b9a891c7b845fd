package rsal.environment;

/// Limits of numbers, for observations and actions.
final class Bounds {
    private Bounds() {}

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
