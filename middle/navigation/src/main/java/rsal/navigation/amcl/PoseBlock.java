package rsal.navigation.amcl;

import java.util.Arrays;

/// So many poses as a [LikelihoodField] judges at once, in its cells, and what it finds: few enough to stay in the
/// processor's fastest cache. Room to work in; not safe for several threads at once.
final class PoseBlock {
    static final int SIZE = 256;

    final float[] x = new float[SIZE];
    final float[] y = new float[SIZE];
    final float[] cos = new float[SIZE]; // times cells per meter
    final float[] sin = new float[SIZE]; // the same
    final int[] cell = new int[SIZE]; // where a beam ends
    final float[] sum = new float[SIZE]; // of logarithms
    final int[] outside = new int[SIZE]; // how many beams end outside the map
    private final Directions directions = new Directions(SIZE);

    /// Some of the particles, of which nothing is found yet.
    void take(Particles particles, int first, int count, double originX, double originY, double cellsPerMeter) {
        directions.of(particles.theta, first, count);
        for (int i = 0; i < count; i++) {
            cos[i] = (float) (directions.cos[i] * cellsPerMeter);
            sin[i] = (float) (directions.sin[i] * cellsPerMeter);
            x[i] = (float) ((particles.x[first + i] - originX) * cellsPerMeter);
            y[i] = (float) ((particles.y[first + i] - originY) * cellsPerMeter);
        }
        Arrays.fill(sum, 0, count, 0);
        Arrays.fill(outside, 0, count, 0);
    }
}
