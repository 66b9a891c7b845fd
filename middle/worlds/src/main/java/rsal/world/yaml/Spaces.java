package rsal.world.yaml;

import java.util.LinkedHashMap;
import rsal.data.FreeSpace;
import rsal.data.OccupancyGrid;
import rsal.settings.InvalidSettings;
import rsal.settings.Location;

/// The free space of a map with different clearances. Keeps those that were asked for last, as each is about as large
/// as the map, and makes no more than a reader has time for.
final class Spaces {
    private static final long MOST_KEPT = 64_000_000; // cells of all that are kept
    private static final long MOST_MADE = 2_000_000_000; // cells of all

    private final OccupancyGrid map;
    private final long mostMade;
    private final LinkedHashMap<Integer, FreeSpace> kept = new LinkedHashMap<>(); // by reach, last asked for last
    private long made; // cells

    Spaces(OccupancyGrid map) {
        this(map, MOST_MADE);
    }

    Spaces(OccupancyGrid map, long mostMade) {
        this.map = map;
        this.mostMade = mostMade;
    }

    /// @param clearance around a robot [m]
    /// @param asked where
    /// @throws InvalidSettings when there were too many different ones
    FreeSpace with(double clearance, Location asked) {
        int reach = FreeSpace.reach(map, clearance);
        FreeSpace known = kept.remove(reach);
        FreeSpace space = known == null ? made(clearance, asked) : known;
        kept.put(reach, space);
        return space;
    }

    private FreeSpace made(double clearance, Location asked) {
        long cells = map.cells().length;
        made += cells;
        if (made > mostMade) {
            throw new InvalidSettings(
                    asked,
                    "Free places are looked for with too many different clearances for a map of %d cells."
                            .formatted(cells),
                    "Use the same 'clearance' for more robots.");
        }
        while (!kept.isEmpty() && (kept.size() + 1) * cells > MOST_KEPT) {
            kept.pollFirstEntry();
        }
        return new FreeSpace(map, clearance);
    }
}
