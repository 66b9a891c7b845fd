package rsal.player.device;

import java.util.List;
import java.util.Optional;
import rsal.data.Angles;
import rsal.data.Covariance2d;
import rsal.data.Pose2d;
import rsal.data.PoseEstimate.Hypothesis;
import rsal.player.message.Localize.Particle;

/// What particles say together.
final class Moments {
    private Moments() {}

    /// Their mean, of headings that of their directions, with their covariance; empty when none of them weighs.
    static Optional<Hypothesis> of(List<Particle> particles) {
        List<Particle> whole = particles.stream().filter(Moments::counts).toList();
        double sum = whole.stream().mapToDouble(Particle::weight).sum();
        if (whole.isEmpty() || !Double.isFinite(sum)) {
            return Optional.empty();
        }
        double x = 0;
        double y = 0;
        double cos = 0;
        double sin = 0;
        for (Particle one : whole) {
            double share = one.weight() / sum;
            x += share * one.mapFromBase().x();
            y += share * one.mapFromBase().y();
            cos += share * Math.cos(one.mapFromBase().theta());
            sin += share * Math.sin(one.mapFromBase().theta());
        }
        var mean = new Pose2d(x, y, Math.atan2(sin, cos));
        var covariance = new Covariance2d(0, 0, 0, 0, 0, 0);
        for (Particle one : whole) {
            covariance = covariance.plus(product(mean, one).times(one.weight() / sum));
        }
        return Optional.of(new Hypothesis(1, mean, covariance));
    }

    private static boolean counts(Particle particle) {
        return particle.mapFromBase().to2d().isFinite() && particle.weight() > 0 && Double.isFinite(particle.weight());
    }

    private static Covariance2d product(Pose2d mean, Particle one) {
        double x = one.mapFromBase().x() - mean.x();
        double y = one.mapFromBase().y() - mean.y();
        double theta = Angles.difference(mean.theta(), one.mapFromBase().theta());
        return new Covariance2d(x * x, x * y, x * theta, y * y, y * theta, theta * theta);
    }
}
