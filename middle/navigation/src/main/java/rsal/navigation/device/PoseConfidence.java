package rsal.navigation.device;

import java.time.Duration;
import java.time.Instant;
import rsal.data.PoseEstimate;

/// Whether a robot knows well enough where it is to drive by that.
final class PoseConfidence {
    private static final double UNSURE = 1.0; // m
    private static final double HEAVY = 0.5; // weight of the best hypothesis
    private static final Duration LOST = Duration.ofSeconds(2); // someone may stand before its sensors for a moment

    private Instant localized; // when it was last not lost

    PoseConfidence(Instant now) {
        this.localized = now;
    }

    /// Whether it is unsure where it is, as it looks now.
    boolean isUnsure(Instant now, PoseEstimate estimate) {
        if (!isLost(estimate)) {
            localized = now;
        }
        var hypotheses = estimate.hypotheses();
        boolean isAmbiguous = !hypotheses.isEmpty() && hypotheses.getFirst().weight() < HEAVY;
        return Duration.between(localized, now).compareTo(LOST) > 0
                || isAmbiguous
                || estimate.covariance().positionDeviation() > UNSURE;
    }

    static boolean isLost(PoseEstimate estimate) {
        return estimate.quality() == PoseEstimate.Quality.LOST;
    }
}
