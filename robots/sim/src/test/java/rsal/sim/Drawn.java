package rsal.sim;

import rsal.data.OccupancyGrid;

/// Maps drawn as text: `#` is occupied, `?` unknown, all else free. The lower left corner is (0, 0).
public final class Drawn {
    private Drawn() {}

    public static OccupancyGrid grid(double resolution, String picture) {
        String[] lines = picture.strip().lines().toArray(String[]::new);
        int width = lines[0].length();
        int height = lines.length;
        byte[] cells = new byte[width * height];
        for (int row = 0; row < height; row++) {
            for (int column = 0; column < width; column++) {
                cells[row * width + column] = switch (lines[height - 1 - row].charAt(column)) {
                    case '#' -> OccupancyGrid.OCCUPIED;
                    case '?' -> OccupancyGrid.UNKNOWN;
                    default -> OccupancyGrid.FREE;
                };
            }
        }
        return new OccupancyGrid(width, height, resolution, 0, 0, cells);
    }

    /// An empty room of so many meters, with walls of one cell of 0.1 m around it.
    public static OccupancyGrid room(double length, double depth) {
        int width = (int) Math.round(length * 10);
        int height = (int) Math.round(depth * 10);
        byte[] cells = new byte[width * height];
        for (int i = 0; i < cells.length; i++) {
            int column = i % width;
            int row = i / width;
            boolean edge = column == 0 || row == 0 || column == width - 1 || row == height - 1;
            cells[i] = edge ? OccupancyGrid.OCCUPIED : OccupancyGrid.FREE;
        }
        return new OccupancyGrid(width, height, 0.1, 0, 0, cells);
    }
}
