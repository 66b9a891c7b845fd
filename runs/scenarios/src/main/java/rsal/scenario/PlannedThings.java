package rsal.scenario;

import java.time.Duration;
import java.util.List;
import java.util.Optional;
import rsal.data.Point2d;
import rsal.device.SimulationControl.Thing;

/// Things of one kind that a scenario puts into its simulated world.
///
/// @param name what the scenario calls them together
/// @param each in the order in which they come
/// @param depot where they are to be brought; empty when they are not
/// @param reach which robots are to get to each; empty when none are
public record PlannedThings(String name, List<PlannedThing> each, Optional<Depot> depot, Optional<Reach> reach) {
    public PlannedThings {
        each = List.copyOf(each);
    }

    /// @param comes when it is there first, since the run's start
    public record PlannedThing(Thing thing, Duration comes) {}

    /// When somebody has got to a thing.
    ///
    /// @param role of robots that count; empty for all
    /// @param within how far a robot's middle may be from the thing's, with no wall between [m]
    /// @param stays for how long it must be there on end
    public record Reach(Optional<String> role, double within, Duration stays) {
        /// Whether robots of a role count.
        public boolean counts(String one) {
            return role.isEmpty() || role.get().equals(one);
        }
    }

    /// Discs on the floor.
    ///
    /// @param mapFromMiddles of each
    /// @param radius [m]
    public record Depot(List<Point2d> mapFromMiddles, double radius) {
        public Depot {
            mapFromMiddles = List.copyOf(mapFromMiddles);
        }

        /// Whether a place is nearer to one of them than that.
        ///
        /// @param beyond its border [m]
        public boolean holds(Point2d mapFromPlace, double beyond) {
            return mapFromMiddles.stream().anyMatch(middle -> middle.distanceTo(mapFromPlace) <= radius + beyond);
        }
    }
}
