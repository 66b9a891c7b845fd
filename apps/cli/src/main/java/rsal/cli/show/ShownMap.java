package rsal.cli.show;

import java.util.List;
import java.util.Locale;
import rsal.cli.terminal.FileError;
import rsal.data.OccupancyGrid;
import rsal.map.Maps;
import rsal.settings.FileSource;
import rsal.settings.Location;

/// A map, for `rsal show` and `rsal list`.
///
/// @param columns of cells
/// @param resolution side of a cell [m]
/// @param originX of the lower left corner, in the map frame [m]
/// @param free share of the cells that are known to be
/// @param warnings of what in its files has no effect, or may not mean what their author thinks
public record ShownMap(
        String map,
        int columns,
        int rows,
        double resolution,
        double originX,
        double originY,
        double free,
        double occupied,
        double unknown,
        List<FileError> warnings) {
    public static Maps.Found find(String name) {
        return new Maps(FileSource.disk()).find(name, Location.of(name));
    }

    public static ShownMap of(String name, Maps.Found found) {
        OccupancyGrid grid = found.grid();
        return new ShownMap(
                name,
                grid.width(),
                grid.height(),
                grid.resolution(),
                grid.originX(),
                grid.originY(),
                share(grid, OccupancyGrid.FREE),
                share(grid, OccupancyGrid.OCCUPIED),
                share(grid, OccupancyGrid.UNKNOWN),
                FileError.of(found.warnings()));
    }

    private static double share(OccupancyGrid grid, byte kind) {
        int count = 0;
        for (byte cell : grid.cells()) {
            count += cell == kind ? 1 : 0;
        }
        return (double) count / grid.cells().length;
    }

    /// `63.0 × 15.6 m, 1259 × 312 cells of 0.05 m`.
    public String size() {
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
