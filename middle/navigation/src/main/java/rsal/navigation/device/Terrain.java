package rsal.navigation.device;

import java.util.HashMap;
import java.util.Map;
import java.util.Optional;
import org.jspecify.annotations.Nullable;
import rsal.data.OccupancyGrid;
import rsal.navigation.grid.Difference;
import rsal.navigation.grid.DistanceField;
import rsal.navigation.wavefront.CostMap;
import rsal.navigation.wavefront.CostMap.Clearance;
import rsal.navigation.wavefront.Wavefront;

/// A map that is drawn again and again, with what is reckoned on it: taken over from the one before where that differs
/// little. Not safe for several threads at once.
final class Terrain {
    private final OccupancyGrid map;
    private final DistanceField toNotFree;
    private final Map<Clearance, Wavefront> ways = new HashMap<>();
    private final Map<Clearance, Wavefront> waysBefore;
    private final Optional<Difference> difference; // from the map before

    private Terrain(
            OccupancyGrid map,
            DistanceField toNotFree,
            Map<Clearance, Wavefront> waysBefore,
            Optional<Difference> difference) {
        this.map = map;
        this.toNotFree = toNotFree;
        this.waysBefore = waysBefore;
        this.difference = difference;
    }

    /// @param before none at first
    static Terrain of(OccupancyGrid map, @Nullable Terrain before) {
        if (before == null) {
            return new Terrain(map, DistanceField.toNotFree(map), Map.of(), Optional.empty());
        }
        Optional<Difference> difference = Difference.between(before.map, map);
        DistanceField toNotFree = difference
                .map(some -> DistanceField.toNotFree(some, before.toNotFree))
                .orElseGet(() -> DistanceField.toNotFree(map));
        return new Terrain(map, toNotFree, before.ways, difference);
    }

    OccupancyGrid map() {
        return map;
    }

    /// How far the next place is that is not known to be free.
    DistanceField toNotFree() {
        return toNotFree;
    }

    /// Ways of robots that keep a clearance. What was found out on the map before counts on, for the goals that they
    /// still have.
    Wavefront ways(Clearance clearance) {
        return ways.computeIfAbsent(clearance, this::reckoned);
    }

    private Wavefront reckoned(Clearance clearance) {
        Wavefront before = waysBefore.get(clearance);
        if (before == null) {
            return new Wavefront(CostMap.of(map, toNotFree, clearance));
        }
        return before.over(difference
                .map(some -> before.map().over(some, toNotFree))
                .orElseGet(() -> CostMap.of(map, toNotFree, clearance)));
    }
}
