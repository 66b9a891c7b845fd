package rsal.navigation.amcl;

import java.util.Arrays;
import rsal.data.ParticleCloud;

/// Weighted poses in the map frame [m, rad], in flat arrays. Only the first `count` entries count; their weights
/// sum to 1.
final class Particles {
    final double[] x;
    final double[] y;
    final double[] theta;
    final double[] weight;
    int count;

    Particles(int capacity) {
        x = new double[capacity];
        y = new double[capacity];
        theta = new double[capacity];
        weight = new double[capacity];
    }

    int capacity() {
        return x.length;
    }

    void add(double x, double y, double theta) {
        this.x[count] = x;
        this.y[count] = y;
        this.theta[count] = theta;
        count++;
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
