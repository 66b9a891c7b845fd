package rsal.testkit;

import java.util.Collections;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import rsal.data.OccupancyGrid;
import rsal.data.Point2d;
import rsal.data.Pose2d;

/// A map drawn in text, so that one can see the case:
///
/// ```java
/// var map = DrawnMap.grid(0.5, """
///         #####
///         #..@#
///         #####""");
/// ```
///
/// `#` is a wall, `.` and blank are free, `?` is unknown; any other sign is free and marks a place. The lower left
/// corner is the map's origin (0, 0).
///
/// @param places middles of the marked cells, each sign once
public record DrawnMap(OccupancyGrid grid, Map<Character, Point2d> places) {
    public DrawnMap {
        places = Collections.unmodifiableMap(new TreeMap<>(places));
    }

    /// @param resolution side of a cell [m]
    public static DrawnMap grid(double resolution, String drawing) {
        List<String> lines = drawing.lines().toList();
        int height = lines.size();
        int width = lines.stream().mapToInt(String::length).max().orElse(0);
        var grid = new OccupancyGrid(width, height, resolution, 0, 0, new byte[width * height]);
        var places = new TreeMap<Character, Point2d>();
        for (int row = 0; row < height; row++) {
            String line = lines.get(height - 1 - row);
            for (int column = 0; column < line.length(); column++) {
                char sign = line.charAt(column);
                grid.cells()[row * width + column] = switch (sign) {
                    case '#' -> OccupancyGrid.OCCUPIED;
                    case '?' -> OccupancyGrid.UNKNOWN;
                    default -> OccupancyGrid.FREE;
                };
                if ("#?. ".indexOf(sign) < 0 && places.put(sign, new Point2d(grid.x(column), grid.y(row))) != null) {
                    throw new IllegalArgumentException("Place '%s' is drawn twice.".formatted(sign));
                }
            }
        }
        return new DrawnMap(grid, places);
    }

    /// The middle of a marked cell.
    public Point2d place(char sign) {
        Point2d place = places.get(sign);
        if (place == null) {
            throw new IllegalArgumentException(
                    "No place '%s' is drawn; there are %s.".formatted(sign, places.keySet()));
        }
        return place;
    }

    /// A marked place, looking in a direction.
    public Pose2d pose(char sign, double degrees) {
        return Pose2d.ofDegrees(place(sign).x(), place(sign).y(), degrees);
    }
}
