package rsal.data;

import java.util.List;

/// Where a localizer believes the robot to be. `mapFromBase` and `covariance` are the best hypothesis;
/// `hypotheses` are all that are still held, heaviest first, weights summing to 1 at most.
public record PoseEstimate(Pose2d mapFromBase, Covariance2d covariance, List<Hypothesis> hypotheses) {

    /// @param weight share of the belief, 0–1
    public record Hypothesis(double weight, Pose2d mapFromBase, Covariance2d covariance) {}

    public PoseEstimate {
        hypotheses = List.copyOf(hypotheses);
    }

    public static PoseEstimate of(Pose2d mapFromBase, Covariance2d covariance) {
        return new PoseEstimate(mapFromBase, covariance, List.of(new Hypothesis(1, mapFromBase, covariance)));
    }
}
