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
public record PlannedThings(String name, List<PlannedThing> each, Optional<Depot> depot) {
    public PlannedThings {
        each = List.copyOf(each);
    }

    /// @param comes when it is there first, since the run's start
    public record PlannedThing(Thing thing, Duration comes) {}

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
