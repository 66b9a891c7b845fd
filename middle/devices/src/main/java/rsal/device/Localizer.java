package rsal.device;

import java.util.Optional;
import java.util.concurrent.CompletionStage;
import rsal.data.OccupancyGrid;
import rsal.data.ParticleCloud;
import rsal.data.PoseEstimate;
import rsal.data.Stamped;

/// Finds the robot on a map. Frame of its readings: `map`.
public interface Localizer extends Sensor<PoseEstimate> {
    /// Starts again from a given estimate of the robot's pose. Completes when the next reading follows it.
    CompletionStage<Void> relocalize(PoseEstimate belief);

    /// The given map on which it localizes the robot; empty if it draws its own map, or has none.
    default Optional<OccupancyGrid> givenMap() {
        return Optional.empty();
    }

    /// The particles of the newest reading, for display; empty if it has none.
    default Optional<Stamped<ParticleCloud>> particles() {
        return Optional.empty();
    }
}
