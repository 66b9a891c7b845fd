package rsal.navigation.device;

import java.time.Duration;
import java.time.Instant;
import java.util.List;
import java.util.Locale;
import rsal.data.Angles;
import rsal.data.Pose2d;
import rsal.data.PoseEstimate;
import rsal.data.PoseEstimate.Hypothesis;

/// Whether a robot knows well enough where it is to drive by that.
final class PoseConfidence {
    private static final double UNSURE = 1.0; // m
    private static final double HEAVY = 0.5; // share of the best hypothesis, and of those that lead it the same way
    private static final double SAME_HEADING = Math.PI / 4; // rad
    private static final Duration LOST = Duration.ofSeconds(2); // someone may stand before its sensors for a moment
    private static final Duration HIDDEN = Duration.ofSeconds(15); // robots of the team do so where they meet

    private Instant localized; // when it was last not lost

    PoseConfidence(Instant now) {
        this.localized = now;
    }

    /// Whether it is unsure where it is, as it looks now. Hypotheses less than 1 m apart, as along a corridor, lead the
    /// robot the same way, so they count together.
    ///
    /// @param isAmongOthers whether robots of the team may hide the walls from its sensors
    boolean isUnsure(Instant now, PoseEstimate estimate, boolean isAmongOthers) {
        if (!isLost(estimate)) {
            localized = now;
        }
        Duration most = isAmongOthers ? HIDDEN : LOST;
        return Duration.between(localized, now).compareTo(most) > 0
                || isAmbiguous(estimate.mapFromBase(), estimate.hypotheses())
                || estimate.covariance().positionDeviation() > UNSURE;
    }

    /// Why it is unsure: for people.
    static String doubt(PoseEstimate estimate) {
        if (isLost(estimate)) {
            return "what it sees does not fit the map there";
        }
        if (isAmbiguous(estimate.mapFromBase(), estimate.hypotheses())) {
            return "%d places fit what it sees".formatted(estimate.hypotheses().size());
        }
        return String.format(Locale.ROOT, "by %.1f m", estimate.covariance().positionDeviation());
    }

    private static boolean isAmbiguous(Pose2d best, List<Hypothesis> hypotheses) {
        double all = 0;
        double near = 0;
        for (Hypothesis hypothesis : hypotheses) {
            Pose2d pose = hypothesis.mapFromBase();
            all += hypothesis.weight();
            if (pose.distanceTo(best) < UNSURE
                    && Math.abs(Angles.difference(best.theta(), pose.theta())) < SAME_HEADING) {
                near += hypothesis.weight();
            }
        }
        return near < HEAVY * all;
    }

    static boolean isLost(PoseEstimate estimate) {
        return estimate.quality() == PoseEstimate.Quality.LOST;
    }
}
