package rsal.agents.pursuit.strategy;

import java.util.Optional;
import rsal.data.Point2d;
import rsal.data.Pose2d;

/// Where a hunter drives, and why.
///
/// @param prey id of the robot that it hunts; empty while it searches
/// @param mapFromGoal where it drives; its heading does not matter
/// @param words what it does, for people: `cutting off prey-1`
public record PursuitOrder(Optional<String> prey, Pose2d mapFromGoal, String words) {
    public PursuitOrder {
        if (!mapFromGoal.isFinite()) {
            throw new IllegalArgumentException("A hunter's goal '%s' must be finite.".formatted(mapFromGoal));
        }
    }

    /// @param word what it does to the prey: `hunting`
    public static PursuitOrder hunt(String prey, Pose2d mapFromGoal, String word) {
        return new PursuitOrder(Optional.of(prey), mapFromGoal, word + " " + prey);
    }

    public static PursuitOrder search(Point2d mapFromGoal) {
        return new PursuitOrder(
                Optional.empty(), new Pose2d(mapFromGoal.x(), mapFromGoal.y(), 0), "searching for prey");
    }
}
