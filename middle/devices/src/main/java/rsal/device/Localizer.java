package rsal.device;

import java.util.Optional;
import java.util.concurrent.CompletionStage;
import rsal.data.ParticleCloud;
import rsal.data.PoseEstimate;
import rsal.data.Stamped;

/// Finds the robot on a map. Frame of its readings: `map`.
public interface Localizer extends Sensor<PoseEstimate> {
    /// Starts again from a belief about where the robot is. Completes when the next reading follows it.
    CompletionStage<Void> relocalize(PoseEstimate belief);

    /// The samples behind the newest reading, for those who want to look; empty when it works without.
    default Optional<Stamped<ParticleCloud>> particles() {
        return Optional.empty();
    }
}
