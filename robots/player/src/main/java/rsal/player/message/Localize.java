package rsal.player.message;

import java.util.List;
import rsal.player.wire.Times;

/// Interface `localize`: where a robot is on a map. Covariances stand as xx, yy, θθ, xy, yθ, θx [m², rad²]; up to
/// Player 3.0 only the first three ([Version30]).
public final class Localize {
    public static final int HYPOTHESES = 1;

    public static final int SET_POSE = 1;
    public static final int PARTICLES = 2;

    private Localize() {}

    /// @param weight among all of them
    public record Hypothesis(Pose mapFromBase, @Times(6) double[] covariance, double weight) {}

    /// @param pending readings that were not looked at yet
    /// @param pendingTime of the oldest of those [s]
    /// @param hypotheses likeliest first
    public record Hypotheses(int pending, double pendingTime, List<Hypothesis> hypotheses) {}

    public record SetPose(Pose mapFromBase, @Times(6) double[] covariance) {}

    public record Particle(Pose mapFromBase, double weight) {}

    public record Particles(Pose mean, double variance, List<Particle> particles) {}
}
