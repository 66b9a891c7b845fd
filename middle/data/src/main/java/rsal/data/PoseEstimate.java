package rsal.data;

import java.util.List;

/// Where a localizer believes the robot to be.
///
/// As `geometry_msgs/PoseWithCovarianceStamped`, with more than one hypothesis.
///
/// @param mapFromBase pose in the map frame, of the best hypothesis
/// @param covariance of x, y and yaw, of the best hypothesis [m², m·rad, rad²]
/// @param hypotheses all possible ones, the highest weight first; the sum of weights is at most 1
/// @param confidence probability that `mapFromBase` is right, as far as the localizer knows, 0–1
/// @param quality the confidence in a word
public record PoseEstimate(
        Pose2d mapFromBase, Covariance2d covariance, List<Hypothesis> hypotheses, double confidence, Quality quality) {

    /// @param weight share of the belief, 0–1
    public record Hypothesis(double weight, Pose2d mapFromBase, Covariance2d covariance) {
        boolean isFinite() {
            return Double.isFinite(weight) && mapFromBase.isFinite() && covariance.isFinite();
        }

        /// The same after the robot moved.
        Hypothesis moved(Pose2d motion) {
            return new Hypothesis(weight, mapFromBase.compose(motion), covariance);
        }
    }

    /// How well a robot is localized.
    public enum Quality {
        /// What is measured does not fit the map at the best hypothesis, or nothing has been measured yet.
        LOST,
        /// It fits, but elsewhere too, or along some way: a corridor that looks the same everywhere. Or the map that it
        /// fits is one that the robot drew itself, and is probably wrong.
        AMBIGUOUS,
        /// It fits here and nowhere else that could be.
        LOCALIZED
    }

    public PoseEstimate {
        hypotheses = List.copyOf(hypotheses);
    }

    /// One pose that is told, by who knows it.
    public static PoseEstimate of(Pose2d mapFromBase, Covariance2d covariance) {
        return new PoseEstimate(
                mapFromBase, covariance, List.of(new Hypothesis(1, mapFromBase, covariance)), 1, Quality.LOCALIZED);
    }

    /// Whether all of it has a value, each hypothesis too: nothing is NaN or infinite.
    public boolean isFinite() {
        return mapFromBase.isFinite()
                && covariance.isFinite()
                && Double.isFinite(confidence)
                && hypotheses.stream().allMatch(Hypothesis::isFinite);
    }

    /// The same after the robot moved.
    ///
    /// @param motion from where the base was to where it is, in the base frame
    public PoseEstimate moved(Pose2d motion) {
        return new PoseEstimate(
                mapFromBase.compose(motion),
                covariance,
                hypotheses.stream().map(hypothesis -> hypothesis.moved(motion)).toList(),
                confidence,
                quality);
    }
}
