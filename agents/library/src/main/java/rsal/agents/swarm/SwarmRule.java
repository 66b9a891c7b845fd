package rsal.agents.swarm;

import java.util.Optional;
import rsal.agents.formation.FormationSlots;
import rsal.data.Point2d;

/// How one robot decides where it drives by its neighbors. Keeps what it needs to remember; is asked on one thread.
public interface SwarmRule {
    /// What a robot without anything to do wants.
    Point2d STAND = new Point2d(0, 0);

    /// @return the velocity that the robot should have [m/s], in the map frame; [#STAND] to stand. Longer ones than
    /// [SwarmView#speed] are shortened.
    Point2d velocity(SwarmView view);

    /// Where the robot should be in a formation, for metrics; empty where there is none. Asked after each decision.
    default Optional<FormationSlots> slots() {
        return Optional.empty();
    }
}
