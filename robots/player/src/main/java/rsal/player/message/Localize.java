package rsal.player.message;

import java.util.List;
import rsal.data.Covariance2d;
import rsal.player.wire.Times;

/// Interface `localize`: where a robot is on a map. Covariances stand as xx, yy, θθ, xy, yθ, θx [m², rad²]; up to
/// Player 3.0 only the first three ([Version30]).
public final class Localize {
    public static final int HYPOTHESES = 1;

    public static final int SET_POSE = 1;
    public static final int PARTICLES = 2;

    private Localize() {}

    /// In the order in which it is sent.
    public static double[] sent(Covariance2d c) {
        return new double[] {c.xx(), c.yy(), c.thetaTheta(), c.xy(), c.yTheta(), c.xTheta()};
    }

    private static Covariance2d read(double[] c) {
        return new Covariance2d(c[0], c[3], c[5], c[1], c[4], c[2]);
    }

    /// @param weight among all of them
    public record Hypothesis(Pose mapFromBase, @Times(6) double[] covariance, double weight) {
        public Covariance2d spread() {
            return read(covariance);
        }
    }

    /// @param pending readings that were not looked at yet
    /// @param pendingTime of the oldest of those [s]
    /// @param hypotheses likeliest first
    public record Hypotheses(int pending, double pendingTime, List<Hypothesis> hypotheses) {}

    public record SetPose(Pose mapFromBase, @Times(6) double[] covariance) {
        public Covariance2d spread() {
            return read(covariance);
        }
    }

    public record Particle(Pose mapFromBase, double weight) {}

    public record Particles(Pose mean, double variance, List<Particle> particles) {}
}
