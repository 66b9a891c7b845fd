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
        int end;
        for (int first = 0; first < particles.count; first = end) {
            int cluster = clusterOf[binOf[first]];
            end = first + 1;
            while (end < particles.count && clusterOf[binOf[end]] == cluster) {
                end++;
            }
            sums[cluster].add(particles, first, end);
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
        int left = bins.count(); // nearly always none soon: there is one cluster
        for (int seed = 0; seed < bins.count(); seed++) {
            if (clusterOf[seed] != PoseBins.NONE) {
                continue;
            }
            int waiting = 0;
            open[waiting++] = seed;
            clusterOf[seed] = clusters;
            left--;
            while (waiting > 0 && left > 0) {
                int bin = open[--waiting];
                for (int neighbor = 0; neighbor < 27; neighbor++) {
                    int next = bins.neighbor(bin, neighbor % 3 - 1, neighbor / 3 % 3 - 1, neighbor / 9 - 1);
                    if (next != PoseBins.NONE && clusterOf[next] == PoseBins.NONE) {
                        clusterOf[next] = clusters;
                        open[waiting++] = next;
                        left--;
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

        /// Adds a run of particles. The sums of it are variables, since the compiler would write a field again for each
        /// particle, and wait for it to be read for the next.
        void add(Particles particles, int first, int end) {
            if (Double.isNaN(firstTheta)) {
                firstX = particles.x[first];
                firstY = particles.y[first];
                firstTheta = particles.theta[first];
            }
            double weight = this.weight;
            double x = this.x;
            double y = this.y;
            double turn = this.turn;
            double xx = this.xx;
            double xy = this.xy;
            double yy = this.yy;
            double xTurn = this.xTurn;
            double yTurn = this.yTurn;
            double turnTurn = this.turnTurn;
            for (int i = first; i < end; i++) {
                double w = particles.weight[i];
                double dx = particles.x[i] - firstX;
                double dy = particles.y[i] - firstY;
                double dTheta = Angles.difference(firstTheta, particles.theta[i]);
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
            this.weight = weight;
            this.x = x;
            this.y = y;
            this.turn = turn;
            this.xx = xx;
            this.xy = xy;
            this.yy = yy;
            this.xTurn = xTurn;
            this.yTurn = yTurn;
            this.turnTurn = turnTurn;
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
