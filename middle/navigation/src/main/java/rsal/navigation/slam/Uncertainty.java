package rsal.navigation.slam;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.PriorityQueue;
import rsal.data.Covariance2d;
import rsal.data.Pose2d;

/// How far off poses may be, seen from one of them: the least covariance along any way through a graph, which
/// is above the true one. E. Olson, Robust and Efficient Robotic Mapping (PhD thesis, MIT 2008), section 5.3.
final class Uncertainty {
    private static final double LEVER = 5; // m; what a heading that is off does to places

    private final List<List<Step>> from = new ArrayList<>();

    /// A relation as one end sees the other.
    private record Step(int to, Pose2d fromFromTo, double[] covariance) {}

    private record Open(int pose, Pose2d startFromPose, double[] covariance, double size) {}

    void add(int from, int to, Pose2d fromFromTo, Covariance2d c) {
        while (this.from.size() <= Math.max(from, to)) {
            this.from.add(new ArrayList<>());
        }
        double[] forward = {
            c.xx(), c.xy(), c.xTheta(), c.xy(), c.yy(), c.yTheta(), c.xTheta(), c.yTheta(), c.thetaTheta()
        };
        this.from.get(from).add(new Step(to, fromFromTo, forward));
        this.from.get(to).add(new Step(from, fromFromTo.inverse(), reversed(fromFromTo, forward)));
    }

    /// Forgets all that was told of how two lie to each other.
    void remove(int from, int to) {
        this.from.get(from).removeIf(step -> step.to == to);
        this.from.get(to).removeIf(step -> step.to == from);
    }

    private static double[] reversed(Pose2d pose, double[] covariance) {
        double cos = Math.cos(pose.theta());
        double sin = Math.sin(pose.theta());
        double[] by = {-cos, -sin, sin * pose.x() - cos * pose.y(), sin, -cos, cos * pose.x() + sin * pose.y(), 0, 0, -1
        };
        return spread(by, covariance);
    }

    /// @return by pose the deviation of its place [m] and heading [rad] as seen from `start`; +∞ where no way
    /// leads
    double[][] from(int start, int count) {
        var deviations = new double[count][];
        Arrays.setAll(deviations, _ -> new double[] {Double.POSITIVE_INFINITY, Double.POSITIVE_INFINITY});
        var done = new boolean[count];
        var open =
                new PriorityQueue<Open>(Comparator.comparingDouble(Open::size).thenComparingInt(Open::pose));
        open.add(new Open(start, Pose2d.ORIGIN, new double[9], 0));
        while (!open.isEmpty()) {
            Open next = open.remove();
            if (done[next.pose]) {
                continue;
            }
            done[next.pose] = true;
            double[] c = next.covariance;
            deviations[next.pose] = new double[] {Math.sqrt(largest(c)), Math.sqrt(c[8])};
            for (Step step : from.get(next.pose)) {
                if (!done[step.to]) {
                    Pose2d there = next.startFromPose.compose(step.fromFromTo);
                    double dx = there.x() - next.startFromPose.x();
                    double dy = there.y() - next.startFromPose.y();
                    double[] covariance = spread(new double[] {1, 0, -dy, 0, 1, dx, 0, 0, 1}, c);
                    double cos = Math.cos(next.startFromPose.theta());
                    double sin = Math.sin(next.startFromPose.theta());
                    double[] own = spread(new double[] {cos, -sin, 0, sin, cos, 0, 0, 0, 1}, step.covariance);
                    for (int i = 0; i < 9; i++) {
                        covariance[i] += own[i];
                    }
                    double size = covariance[0] + covariance[4] + LEVER * LEVER * covariance[8];
                    open.add(new Open(step.to, there, covariance, size));
                }
            }
        }
        return deviations;
    }

    private static double largest(double[] c) {
        return (c[0] + c[4]) / 2 + Math.hypot((c[0] - c[4]) / 2, c[1]);
    }

    /// by c byᵀ
    private static double[] spread(double[] by, double[] c) {
        var half = new double[9];
        var whole = new double[9];
        for (int i = 0; i < 3; i++) {
            for (int k = 0; k < 3; k++) {
                half[3 * i + k] = by[3 * i] * c[k] + by[3 * i + 1] * c[3 + k] + by[3 * i + 2] * c[6 + k];
            }
        }
        for (int i = 0; i < 3; i++) {
            for (int k = 0; k < 3; k++) {
                whole[3 * i + k] =
                        half[3 * i] * by[3 * k] + half[3 * i + 1] * by[3 * k + 1] + half[3 * i + 2] * by[3 * k + 2];
            }
        }
        return whole;
    }
}
