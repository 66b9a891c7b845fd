package rsal.scenario.installed;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.Function;
import rsal.data.FreeSpace;
import rsal.data.OccupancyGrid;
import rsal.scene.Scene;
import rsal.settings.Problem;

/// What follows from a map alone, for runs on the same map: its walls, and where there is room. A map is recognized by
/// its very cells, of which [rsal.map.KnownMaps] gives the same for the same file. Keeps the newest few. Any thread may
/// ask.
public final class MapFacts {
    private static final int MOST_SCENES = 4;
    private static final int MOST_SPACES = 16; // each takes up to 4 B for a cell of its map

    private final Map<Mapped, Scene> scenes = new LinkedHashMap<>(); // the oldest first
    private final Map<Room, FreeSpace> spaces = new LinkedHashMap<>();

    private record Mapped(OccupancyGrid map, List<Problem> warnings) {}

    /// @param clearance in cells
    /// @param passage in cells
    private record Room(OccupancyGrid map, int clearance, int passage) {}

    /// The world of a map, as [Scene#of(OccupancyGrid, List)].
    public synchronized Scene scene(OccupancyGrid map, List<Problem> warnings) {
        return newest(
                scenes,
                MOST_SCENES,
                new Mapped(map, List.copyOf(warnings)),
                key -> Scene.of(key.map(), key.warnings()));
    }

    /// As [FreeSpace].
    ///
    /// @param clearance half the side of a square around a cell's middle that must be free [m]
    /// @param passage the same for what connects them, at most the clearance [m]
    public synchronized FreeSpace freeSpace(OccupancyGrid map, double clearance, double passage) {
        return newest(
                spaces,
                MOST_SPACES,
                new Room(map, FreeSpace.reach(map, clearance), FreeSpace.reach(map, passage)),
                _ -> new FreeSpace(map, clearance, passage));
    }

    private static <K, V> V newest(Map<K, V> known, int most, K key, Function<K, V> compute) {
        V found = known.computeIfAbsent(key, compute);
        if (known.size() > most) {
            known.remove(known.keySet().iterator().next());
        }
        return found;
    }
}
