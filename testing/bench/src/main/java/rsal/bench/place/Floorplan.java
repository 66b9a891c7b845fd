package rsal.bench.place;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import rsal.data.OccupancyGrid;

/// A rectangular room with walls in it, its lower left corner at the origin. Immutable.
///
/// @param width [m]
/// @param height [m]
public record Floorplan(double width, double height, List<Wall> walls) {
    private static final double CELL = 0.05; // m

    /// From its lower left corner to its upper right one [m].
    record Wall(double left, double bottom, double right, double top) {}

    public Floorplan {
        walls = List.copyOf(walls);
    }

    public static Floorplan room(double width, double height) {
        return new Floorplan(width, height, List.of());
    }

    /// The same with a wall more.
    public Floorplan with(double left, double bottom, double right, double top) {
        var all = new ArrayList<>(walls);
        all.add(new Wall(left, bottom, right, top));
        return new Floorplan(width, height, all);
    }

    /// Cells whose middle is in a wall, and the outermost ones, are occupied.
    public OccupancyGrid grid() {
        int columns = (int) Math.round(width / CELL);
        int rows = (int) Math.round(height / CELL);
        byte[] cells = new byte[columns * rows];
        Arrays.fill(cells, OccupancyGrid.FREE);
        for (int row = 0; row < rows; row++) {
            for (int column = 0; column < columns; column++) {
                boolean edge = row == 0 || column == 0 || row == rows - 1 || column == columns - 1;
                double x = (column + 0.5) * CELL;
                double y = (row + 0.5) * CELL;
                if (edge || walls.stream().anyMatch(wall -> holds(wall, x, y))) {
                    cells[row * columns + column] = OccupancyGrid.OCCUPIED;
                }
            }
        }
        return new OccupancyGrid(columns, rows, CELL, 0, 0, cells);
    }

    private static boolean holds(Wall wall, double x, double y) {
        return x > wall.left() && x < wall.right() && y > wall.bottom() && y < wall.top();
    }
}
