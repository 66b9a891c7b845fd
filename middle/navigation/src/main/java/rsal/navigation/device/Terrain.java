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

/// A map that is drawn again and again, with what is computed on it: taken over from the one before where that differs
/// little. Not safe for several threads at once.
final class Terrain {
    private final OccupancyGrid map;
    private final DistanceField toNotFree;
    private final Map<Clearance, Wavefront> ways = new HashMap<>(); // that somebody asked for
    private final Map<Clearance, Wavefront> takenOver = new HashMap<>(); // that nobody did yet

    private Terrain(OccupancyGrid map, DistanceField toNotFree) {
        this.map = map;
        this.toNotFree = toNotFree;
    }

    /// @param before none at first
    static Terrain of(OccupancyGrid map, @Nullable Terrain before) {
        if (before == null) {
            return new Terrain(map, DistanceField.toNotFree(map));
        }
        Optional<Difference> difference = Difference.between(before.map, map);
        var now = new Terrain(
                map,
                difference
                        .map(some -> DistanceField.toNotFree(some, before.toNotFree))
                        .orElseGet(() -> DistanceField.toNotFree(map)));
        before.ways.forEach((clearance, ways) -> {
            CostMap costs =
                    difference.map(some -> ways.map().over(some, now.toNotFree)).orElseGet(() -> now.costs(clearance));
            now.takenOver.put(clearance, ways.over(costs));
        });
        return now;
    }

    OccupancyGrid map() {
        return map;
    }

    /// How far the next place is that is not known to be free.
    DistanceField toNotFree() {
        return toNotFree;
    }

    /// Paths of robots that keep a clearance. What was found out on the map before counts on, for the goals that they
    /// still have, if somebody asked for them there.
    Wavefront wavefront(Clearance clearance) {
        return ways.computeIfAbsent(
                clearance, c -> Optional.ofNullable(takenOver.remove(c)).orElseGet(() -> new Wavefront(costs(c))));
    }

    private CostMap costs(Clearance clearance) {
        return CostMap.of(map, toNotFree, clearance);
    }
}
