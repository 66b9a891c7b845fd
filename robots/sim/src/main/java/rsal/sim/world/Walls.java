package rsal.sim.world;

import rsal.data.OccupancyGrid;

/// The occupied cells of a map. Unknown cells are no walls. The map is fenced: no robot leaves it, but a ray that
/// does meets nothing.
///
/// Each cell knows its chessboard distance to the nearest occupied one (two sweeps: Rosenfeld and Pfaltz, Distance
/// Functions on Digital Pictures, 1968), so that rays and collision checks can skip the empty square around it.
public final class Walls {
    private static final int FARTHEST = Byte.MAX_VALUE;

    private final double resolution;
    private final double cellsPerMeter;
    private final double left; // of the fence, which is one cell wide
    private final double bottom;
    private final int width; // with the fence
    private final int height;
    private final byte[] distance; // [cells]; 0 in walls and in the fence

    public Walls(OccupancyGrid map) {
        resolution = map.resolution();
        cellsPerMeter = 1 / resolution;
        left = map.originX() - resolution;
        bottom = map.originY() - resolution;
        width = map.width() + 2;
        height = map.height() + 2;
        distance = new byte[Math.multiplyExact(width, height)];
        for (int row = 0; row < map.height(); row++) {
            for (int column = 0; column < map.width(); column++) {
                if (map.cells()[row * map.width() + column] != OccupancyGrid.OCCUPIED) {
                    distance[(row + 1) * width + column + 1] = FARTHEST;
                }
            }
        }
        measureDistances();
    }

    private void measureDistances() {
        for (int i = width + 1; i < distance.length - width - 1; i++) {
            atMostOneMoreThan(i, i - 1, i - width - 1, i - width, i - width + 1);
        }
        for (int i = distance.length - width - 2; i > width; i--) {
            atMostOneMoreThan(i, i + 1, i + width + 1, i + width, i + width - 1);
        }
    }

    private void atMostOneMoreThan(int i, int a, int b, int c, int d) {
        int least = Math.min(Math.min(distance[a], distance[b]), Math.min(distance[c], distance[d]));
        distance[i] = (byte) Math.min(distance[i], least + 1);
    }

    /// Whether a place is on the map and not in a wall.
    public boolean isFree(double x, double y) {
        return distanceAt(x, y) > 0;
    }

    /// A distance [m] within which nothing is solid around a place; less than the true one by up to a cell and by
    /// the difference between square and circle. Negative in walls and outside the map.
    double emptyAround(double x, double y) {
        return (distanceAt(x, y) - 1) * resolution;
    }

    private int distanceAt(double x, double y) {
        double column = (x - left) * cellsPerMeter;
        double row = (y - bottom) * cellsPerMeter;
        boolean inside = column >= 0 && column < width && row >= 0 && row < height; // false for NaN
        return inside ? distance[((int) row) * width + (int) column] : 0;
    }

    /// Way of a ray from a place to the border of the first occupied cell [m]; +∞ when there is none within reach.
    /// 0 inside a wall.
    ///
    /// An exact grid walk (Amanatides and Woo, A Fast Voxel Traversal Algorithm, 1987) that crosses the empty
    /// square around the current cell in one stride (Cohen and Sheffer, Proximity Clouds, 1994).
    ///
    /// @param dx direction; (dx, dy) has length 1
    public double ray(double x, double y, double dx, double dy, double reach) {
        double fromColumn = (x - left) * cellsPerMeter;
        double fromRow = (y - bottom) * cellsPerMeter;
        double limit = reach * cellsPerMeter;
        int column = (int) fromColumn;
        int row = (int) fromRow;
        if (!(fromColumn >= 1 && column < width - 1 && fromRow >= 1 && row < height - 1)) {
            return Double.POSITIVE_INFINITY;
        }
        boolean right = dx >= 0;
        boolean up = dy >= 0;
        double perColumn = dx == 0 ? Double.POSITIVE_INFINITY : 1 / dx;
        double perRow = dy == 0 ? Double.POSITIVE_INFINITY : 1 / dy;
        double way = 0;
        for (int empty = distance[row * width + column]; empty > 0; empty = distance[row * width + column]) {
            double toColumn = ((right ? column + empty : column - empty + 1) - fromColumn) * perColumn;
            double toRow = ((up ? row + empty : row - empty + 1) - fromRow) * perRow;
            if (toColumn < toRow) {
                way = toColumn;
                column += right ? empty : -empty;
                row = within((int) (fromRow + way * dy), row, empty);
            } else {
                way = toRow;
                row += up ? empty : -empty;
                column = within((int) (fromColumn + way * dx), column, empty);
            }
            if (way > limit) {
                return Double.POSITIVE_INFINITY;
            }
        }
        boolean atFence = column == 0 || column == width - 1 || row == 0 || row == height - 1;
        return atFence ? Double.POSITIVE_INFINITY : way * resolution;
    }

    /// Rounding may put a point beside the square that it leaves through another side.
    private static int within(int cell, int center, int empty) {
        return Math.clamp(cell, center - empty + 1, center + empty - 1);
    }

    /// How far an outline is from walls and fence [m]: at most the true distance (exact to a face, less to a
    /// corner), 0 or less when they overlap, `reach` when nothing is nearer than that.
    double separation(Outline outline, double reach) {
        double around = emptyAround(outline.x(), outline.y()) - outline.radius();
        if (around >= reach) {
            return reach;
        }
        int firstColumn = column(outline.minX() - reach);
        int lastColumn = column(outline.maxX() + reach);
        int firstRow = row(outline.minY() - reach);
        int lastRow = row(outline.maxY() + reach);
        double least = Math.min(reach, fromFence(outline));
        for (int row = firstRow; row <= lastRow; row++) {
            int empty;
            for (int column = firstColumn; column <= lastColumn; column += Math.max(1, empty)) {
                empty = distance[row * width + column];
                if (empty == 0) {
                    double x = left + column * resolution;
                    double y = bottom + row * resolution;
                    least = Math.min(least, outline.separation(x, y, x + resolution, y + resolution));
                }
            }
        }
        return least;
    }

    private double fromFence(Outline outline) {
        double right = left + width * resolution;
        double top = bottom + height * resolution;
        double fromSides = Math.min(outline.minX() - left, right - outline.maxX());
        double fromEnds = Math.min(outline.minY() - bottom, top - outline.maxY());
        return Math.min(fromSides, fromEnds) - resolution;
    }

    private int column(double x) {
        return (int) Math.clamp(Math.floor((x - left) * cellsPerMeter), 0.0, width - 1.0);
    }

    private int row(double y) {
        return (int) Math.clamp(Math.floor((y - bottom) * cellsPerMeter), 0.0, height - 1.0);
    }
}
