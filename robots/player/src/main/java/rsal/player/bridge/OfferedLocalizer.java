package rsal.player.bridge;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.jspecify.annotations.Nullable;
import rsal.data.Covariance2d;
import rsal.data.ParticleCloud;
import rsal.data.PoseEstimate;
import rsal.data.Stamped;
import rsal.device.Localizer;
import rsal.player.message.Interface;
import rsal.player.message.Localize;
import rsal.player.message.Pose;
import rsal.player.wire.MalformedException;
import rsal.player.wire.MessageKind;
import rsal.player.wire.Packet;
import rsal.time.Scheduler;

/// A localizer as `localize`.
final class OfferedLocalizer extends OfferedSensor<PoseEstimate> {
    private static final double FARTHEST = 1e6; // m; no map is as large
    private static final double SLACK = 1e-9; // of products, for what is lost where numbers are written as text

    private final Localizer localizer;
    private boolean settling;
    private @Nullable PoseEstimate next; // to believe, once it has settled

    OfferedLocalizer(int index, Localizer localizer, Scheduler scheduler) {
        super(Interface.LOCALIZE, index, localizer, scheduler);
        this.localizer = localizer;
    }

    @Override
    void publish(Stamped<PoseEstimate> reading) {
        PoseEstimate estimate = reading.value();
        var hypotheses = new ArrayList<Localize.Hypothesis>();
        estimate.hypotheses()
                .forEach(each -> hypotheses.add(hypothesis(each.mapFromBase(), each.covariance(), each.weight())));
        if (hypotheses.isEmpty()) {
            hypotheses.add(hypothesis(estimate.mapFromBase(), estimate.covariance(), estimate.confidence()));
        }
        publish(
                Localize.HYPOTHESES,
                reading.time(),
                new Localize.Hypotheses(0, seconds(reading.time()), List.copyOf(hypotheses)));
    }

    private static Localize.Hypothesis hypothesis(rsal.data.Pose2d mapFromBase, Covariance2d c, double weight) {
        return new Localize.Hypothesis(Pose.of(mapFromBase), Localize.sent(c), weight);
    }

    @Override
    public boolean understands(MessageKind kind, int subtype) {
        return kind == MessageKind.REQUEST && (subtype == Localize.SET_POSE || subtype == Localize.PARTICLES);
    }

    @Override
    Optional<Answer> answer(Packet request) throws MalformedException {
        return switch (request.header().subtype()) {
            case Localize.SET_POSE -> believe(request.body(Localize.SetPose.class));
            case Localize.PARTICLES -> particles();
            default -> Optional.empty();
        };
    }

    private Optional<Answer> believe(Localize.SetPose reported) {
        Covariance2d covariance = possible(reported.spread());
        var belief = PoseEstimate.of(reported.mapFromBase().to2d(), covariance);
        boolean credible = belief.isFinite()
                && Math.hypot(reported.mapFromBase().x(), reported.mapFromBase().y()) < FARTHEST
                && isVariance(covariance.xx())
                && isVariance(covariance.yy())
                && isVariance(covariance.thetaTheta());
        if (!credible) {
            return Optional.empty();
        }
        if (settling) {
            next = belief; // of those that come meanwhile the newest counts, so that nothing grows
        } else {
            relocalize(belief);
        }
        return Optional.of(new Answer.Done());
    }

    private void relocalize(PoseEstimate belief) {
        settling = true;
        localizer.relocalize(belief).whenComplete((_, _) -> {
            settling = false;
            PoseEstimate wanted = next;
            next = null;
            if (wanted != null) {
                relocalize(wanted);
            }
        });
    }

    /// Its variances alone where its products can't be: playernav hands over three numbers where Player's library
    /// reads six, so that anything may stand in the others.
    private static Covariance2d possible(Covariance2d c) {
        return areProducts(c) ? c : new Covariance2d(c.xx(), 0, 0, c.yy(), 0, c.thetaTheta());
    }

    /// Whether the matrix is positive semidefinite, if its variances are right.
    private static boolean areProducts(Covariance2d c) {
        double variances = c.xx() * c.yy() * c.thetaTheta();
        double determinant = variances
                + 2 * c.xy() * c.xTheta() * c.yTheta()
                - c.xx() * c.yTheta() * c.yTheta()
                - c.yy() * c.xTheta() * c.xTheta()
                - c.thetaTheta() * c.xy() * c.xy();
        return isProduct(c.xy(), c.xx(), c.yy())
                && isProduct(c.xTheta(), c.xx(), c.thetaTheta())
                && isProduct(c.yTheta(), c.yy(), c.thetaTheta())
                && determinant >= -SLACK * variances;
    }

    private static boolean isVariance(double value) {
        return value >= 0 && value < FARTHEST * FARTHEST;
    }

    private static boolean isProduct(double value, double one, double other) {
        return value * value <= one * other * (1 + SLACK);
    }

    private Optional<Answer> particles() {
        Optional<ParticleCloud> cloud = localizer.particles().map(Stamped::value);
        Optional<PoseEstimate> estimate = localizer.latest().map(Stamped::value);
        return cloud.flatMap(samples ->
                estimate.map(best -> new Answer.Reported(particles(samples, best.mapFromBase(), best.covariance()))));
    }

    private static Localize.Particles particles(ParticleCloud cloud, rsal.data.Pose2d mean, Covariance2d covariance) {
        var particles = new ArrayList<Localize.Particle>();
        float[] poses = cloud.poses();
        for (int i = 0; i < cloud.count(); i++) {
            var at = new Pose(poses[3 * i], poses[3 * i + 1], poses[3 * i + 2]);
            particles.add(new Localize.Particle(at, cloud.weights()[i]));
        }
        double deviation = covariance.positionDeviation();
        return new Localize.Particles(Pose.of(mean), deviation * deviation, particles);
    }
}
