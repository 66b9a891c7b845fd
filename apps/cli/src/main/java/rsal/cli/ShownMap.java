package rsal.cli;

import java.util.List;
import java.util.Locale;
import rsal.data.OccupancyGrid;
import rsal.map.Maps;
import rsal.settings.FileSource;
import rsal.settings.InvalidSettings;
import rsal.settings.Location;
import rsal.settings.Value;

/// A map, for `rsal show` and `rsal list`.
///
/// @param columns of cells
/// @param resolution side of a cell [m]
/// @param originX of the lower left corner, in the map frame [m]
/// @param free share of the cells that are known to be
record ShownMap(
        String map,
        int columns,
        int rows,
        double resolution,
        double originX,
        double originY,
        double free,
        double occupied,
        double unknown) {
    static ShownMap of(String name) {
        OccupancyGrid grid = new Maps(FileSource.disk()).read(name, Location.of(name));
        return new ShownMap(
                name,
                grid.width(),
                grid.height(),
                grid.resolution(),
                grid.originX(),
                grid.originY(),
                share(grid, OccupancyGrid.FREE),
                share(grid, OccupancyGrid.OCCUPIED),
                share(grid, OccupancyGrid.UNKNOWN));
    }

    /// What files of maps say, two of it at least; nothing else that can be shown does.
    private static final List<String> MARKS =
            List.of("image", "drawing", "resolution", "origin", "mode", "negate", "occupied_thresh", "free_thresh");

    /// Whether a name is that of a map: a built-in one, or a file of ROS's, also one in which something is missing:
    /// whoever reads it tells what.
    static boolean is(String name) {
        if (Maps.builtIn().contains(name)) {
            return true;
        }
        if (!name.endsWith(".yaml") && !name.endsWith(".yml")) {
            return false;
        }
        try {
            Value.Mapping file = FileSource.disk().yaml(name, Location.of(name));
            return file.find("rsal").isEmpty()
                    && file.find("scenario").isEmpty()
                    && MARKS.stream()
                                    .filter(mark -> file.find(mark).isPresent())
                                    .count()
                            > 1;
        } catch (InvalidSettings _) {
            return false; // whoever reads it next tells why
        }
    }

    private static double share(OccupancyGrid grid, byte kind) {
        int count = 0;
        for (byte cell : grid.cells()) {
            count += cell == kind ? 1 : 0;
        }
        return (double) count / grid.cells().length;
    }

    /// `63.0 × 15.6 m, 1259 × 312 cells of 0.05 m`.
    String size() {
        return String.format(
                Locale.ROOT,
                "%.1f × %.1f m, %d × %d cells of %s m",
                columns * resolution,
                rows * resolution,
                columns,
                rows,
                resolution);
    }

    /// For people.
    String text() {
        return String.format(
                Locale.ROOT,
                "%s: a map, %s%nfrom (%.2f, %.2f) to (%.2f, %.2f); %.0f %% free, %.0f %% occupied, %.0f %% unknown%n%n"
                        + "In a scenario: world: {map: %s}%nWith a log:    rsal localize LOG --map %s%n",
                map,
                size(),
                originX,
                originY,
                originX + columns * resolution,
                originY + rows * resolution,
                100 * free,
                100 * occupied,
                100 * unknown,
                map,
                map);
    }
}
