package rsal.navigation.amcl;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import rsal.data.Angles;
import rsal.data.Covariance2d;
import rsal.data.Pose2d;
import rsal.data.PoseEstimate;
import rsal.data.PoseEstimate.Hypothesis;
import rsal.data.PoseEstimate.Quality;

/// Sums particles up: particles in neighboring bins of the pose space are one hypothesis.
final class Clusters {
    private static final double BIN = 0.4; // m
    private static final int HEADINGS = 18;
    private static final int MOST = 10;

    private final PoseBins bins = new PoseBins(BIN, HEADINGS);
    private int[] binOf = {};
    private int[] clusterOf = {};
    private int[] open = {};

    PoseEstimate estimate(Particles particles) {
        bins.clear();
        if (particles.count > binOf.length) {
            int room = particles.x.length;
            binOf = new int[room];
            clusterOf = new int[room];
            open = new int[room];
        }
        for (int i = 0; i < particles.count; i++) {
            binOf[i] = bins.add(particles.x[i], particles.y[i], particles.theta[i]);
        }
        int clusters = connect();
        var sums = new Sum[clusters];
        Arrays.setAll(sums, _ -> new Sum());
        for (int i = 0; i < particles.count; i++) {
            sums[clusterOf[binOf[i]]].add(particles.weight[i], particles.x[i], particles.y[i], particles.theta[i]);
        }
        var hypotheses = new ArrayList<Hypothesis>();
        Arrays.stream(sums)
                .sorted(Comparator.comparingDouble((Sum s) -> s.weight).reversed())
                .limit(MOST)
                .filter(s -> s.weight > 0)
                .forEach(s -> hypotheses.add(s.hypothesis()));
        Hypothesis best = hypotheses.getFirst();
        return new PoseEstimate(best.mapFromBase(), best.covariance(), hypotheses, best.weight(), Quality.AMBIGUOUS);
    }

    /// Gives each bin the number of its cluster.
    private int connect() {
        Arrays.fill(clusterOf, 0, bins.count(), PoseBins.NONE);
        int clusters = 0;
        for (int seed = 0; seed < bins.count(); seed++) {
            if (clusterOf[seed] != PoseBins.NONE) {
                continue;
            }
            int waiting = 0;
            open[waiting++] = seed;
            clusterOf[seed] = clusters;
            while (waiting > 0) {
                int bin = open[--waiting];
                for (int neighbor = 0; neighbor < 27; neighbor++) {
                    int next = bins.neighbor(bin, neighbor % 3 - 1, neighbor / 3 % 3 - 1, neighbor / 9 - 1);
                    if (next != PoseBins.NONE && clusterOf[next] == PoseBins.NONE) {
                        clusterOf[next] = clusters;
                        open[waiting++] = next;
                    }
                }
            }
            clusters++;
        }
        return clusters;
    }

    /// Weighted moments. Headings are summed as differences to the first one: a cluster is not wider than half a
    /// turn where this matters.
    private static final class Sum {
        private double weight;
        private double firstTheta = Double.NaN;
        private double x;
        private double y;
        private double turn;
        private double xx;
        private double xy;
        private double yy;
        private double xTurn;
        private double yTurn;
        private double turnTurn;
        private double firstX;
        private double firstY;

        void add(double w, double px, double py, double theta) {
            if (Double.isNaN(firstTheta)) {
                firstX = px;
                firstY = py;
                firstTheta = theta;
            }
            double dx = px - firstX;
            double dy = py - firstY;
            double dTheta = Angles.difference(firstTheta, theta);
            weight += w;
            x += w * dx;
            y += w * dy;
            turn += w * dTheta;
            xx += w * dx * dx;
            xy += w * dx * dy;
            yy += w * dy * dy;
            xTurn += w * dx * dTheta;
            yTurn += w * dy * dTheta;
            turnTurn += w * dTheta * dTheta;
        }

        Hypothesis hypothesis() {
            double mx = x / weight;
            double my = y / weight;
            double mTurn = turn / weight;
            var mean = new Pose2d(firstX + mx, firstY + my, firstTheta + mTurn);
            var covariance = new Covariance2d(
                    xx / weight - mx * mx,
                    xy / weight - mx * my,
                    xTurn / weight - mx * mTurn,
                    yy / weight - my * my,
                    yTurn / weight - my * mTurn,
                    turnTurn / weight - mTurn * mTurn);
            return new Hypothesis(Math.min(1, weight), mean, covariance);
        }
    }
}
