package rsal.navigation.amcl;

import java.util.Arrays;
import rsal.data.ParticleCloud;

/// Weighted poses in the map frame [m, rad], in flat arrays. Only the first `count` entries count; their weights
/// sum to 1. The arrays grow when they have to: of a thousand robots hardly any needs as many as it may have.
final class Particles {
    private static final int FEW = 256;

    private final int capacity;
    double[] x;
    double[] y;
    double[] theta;
    double[] weight;
    int count;

    Particles(int capacity) {
        this.capacity = capacity;
        int room = Math.min(FEW, capacity);
        x = new double[room];
        y = new double[room];
        theta = new double[room];
        weight = new double[room];
    }

    /// How many there may be.
    int capacity() {
        return capacity;
    }

    private void makeRoom(int least) {
        int room = Math.min(Math.max(2 * x.length, least), capacity);
        x = Arrays.copyOf(x, room);
        y = Arrays.copyOf(y, room);
        theta = Arrays.copyOf(theta, room);
        weight = Arrays.copyOf(weight, room);
    }

    void add(double x, double y, double theta) {
        if (count == this.x.length) {
            makeRoom(count + 1);
        }
        this.x[count] = x;
        this.y[count] = y;
        this.theta[count] = theta;
        count++;
    }

    /// Becomes those of others, some of them several times. Their weights are not taken.
    void take(Particles others, int[] which, int count) {
        if (count > x.length) {
            makeRoom(count);
        }
        for (int i = 0; i < count; i++) {
            int other = which[i];
            x[i] = others.x[other];
            y[i] = others.y[other];
            theta[i] = others.theta[other];
        }
        this.count = count;
    }

    void weighEqually() {
        Arrays.fill(weight, 0, count, 1.0 / count);
    }

    /// How many equally weighted particles would say as much: A. Kong, J. Liu, W. Wong, Sequential Imputations
    /// and Bayesian Missing Data Problems (1994).
    double effectiveCount() {
        double squares = 0;
        for (int i = 0; i < count; i++) {
            squares += weight[i] * weight[i];
        }
        return 1 / squares;
    }

    ParticleCloud cloud() {
        var poses = new float[3 * count];
        var weights = new float[count];
        for (int i = 0; i < count; i++) {
            poses[3 * i] = (float) x[i];
            poses[3 * i + 1] = (float) y[i];
            poses[3 * i + 2] = (float) theta[i];
            weights[i] = (float) weight[i];
        }
        return new ParticleCloud(poses, weights);
    }
}
