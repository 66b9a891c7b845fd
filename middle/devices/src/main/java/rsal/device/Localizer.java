package rsal.device;

import java.util.Optional;
import java.util.concurrent.CompletionStage;
import rsal.data.OccupancyGrid;
import rsal.data.ParticleCloud;
import rsal.data.PoseEstimate;
import rsal.data.Stamped;

/// Finds the robot on a map. Frame of its readings: `map`.
public interface Localizer extends Sensor<PoseEstimate> {
    /// Starts again from a belief about where the robot is. Completes when the next reading follows it.
    CompletionStage<Void> relocalize(PoseEstimate belief);

    /// The map that it was given to find the robot on; empty when it draws its own, or has none.
    default Optional<OccupancyGrid> givenMap() {
        return Optional.empty();
    }

    /// The samples behind the newest reading, for those who want to look; empty when it works without.
    default Optional<Stamped<ParticleCloud>> particles() {
        return Optional.empty();
    }
}
