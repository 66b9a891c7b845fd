package rsal.agents.pursuit.strategy;

import rsal.data.OccupancyGrid;

/// Maps that tests draw.
final class Maps {
    /// An aisle around a block: 12 m × 10 m with walls of 1 m, and aisles 2 m wide.
    static final OccupancyGrid RING = drawn(
            "############",
            "#..........#",
            "#..........#",
            "#..######..#",
            "#..######..#",
            "#..######..#",
            "#..######..#",
            "#..........#",
            "#..........#",
            "############");
    /// Three rooms beside a corridor.
    static final OccupancyGrid ROOMS = drawn(
            "##############",
            "#....#....#..#",
            "#....#....#..#",
            "#....#....#..#",
            "##.####.####.#",
            "#............#",
            "#............#",
            "##############");

    private Maps() {}

    /// Cells of 0.1 m; the lower left corner is the origin.
    ///
    /// @param rows a letter for each square meter, `#` for a wall; the northernmost first
    static OccupancyGrid drawn(String... rows) {
        int width = rows[0].length() * 10;
        int height = rows.length * 10;
        var cells = new byte[width * height];
        for (int row = 0; row < height; row++) {
            for (int column = 0; column < width; column++) {
                boolean wall = rows[rows.length - 1 - row / 10].charAt(column / 10) == '#';
                cells[row * width + column] = wall ? OccupancyGrid.OCCUPIED : OccupancyGrid.FREE;
            }
        }
        return new OccupancyGrid(width, height, 0.1, 0, 0, cells);
    }
}
