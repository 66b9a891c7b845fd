package rsal.sim.world;

import rsal.data.OccupancyGrid;
import rsal.map.DistanceTransform;

/// The occupied cells of a map. Unknown cells are no walls. The map is fenced: no robot leaves it, but a ray that
/// does meets nothing.
///
/// Each cell knows how far the nearest solid one is, so that rays and collision checks can skip the empty circle
/// around it.
public final class Walls {
    private static final byte SOLID = 0;
    private static final byte NEAR = 1; // touches a solid cell, if only with a corner
    private static final byte FAR = 2;
    private static final double UNITS_PER_CELL = 2;
    private static final int MOST = 0xFF;
    private static final double GUARD = 1e-6; // [cells]; more than rounding, so that no stride ends in a wall

    private final double resolution;
    private final double cellsPerMeter;
    private final double left; // of the fence, which is one cell wide
    private final double bottom;
    private final int width; // with the fence
    private final int height;
    private final byte[] room; // by cell: SOLID, NEAR, or NEAR + units from any point of it to anything solid, unsigned

    public Walls(OccupancyGrid map) {
        resolution = map.resolution();
        cellsPerMeter = 1 / resolution;
        left = map.originX() - resolution;
        bottom = map.originY() - resolution;
        width = map.width() + 2;
        height = map.height() + 2;
        room = new byte[Math.multiplyExact(width, height)];
        markSolid(map);
        markNear();
        measureFar();
    }

    private void markSolid(OccupancyGrid map) {
        for (int row = 0; row < map.height(); row++) {
            for (int column = 0; column < map.width(); column++) {
                if (map.cells()[row * map.width() + column] != OccupancyGrid.OCCUPIED) {
                    room[(row + 1) * width + column + 1] = FAR;
                }
            }
        }
    }

    private void markNear() {
        for (int row = 1; row < height - 1; row++) {
            for (int column = 1; column < width - 1; column++) {
                int cell = row * width + column;
                if (room[cell] == FAR && touchesSolid(cell)) {
                    room[cell] = NEAR;
                }
            }
        }
    }

    private boolean touchesSolid(int cell) {
        for (int below = cell - width - 1; below <= cell + width - 1; below += width) {
            if (room[below] == SOLID || room[below + 1] == SOLID || room[below + 2] == SOLID) {
                return true;
            }
        }
        return false;
    }

    /// Two cells are as far apart, from border to border, as the middle of one is from the middle of the nearest of
    /// those around the other.
    private void measureFar() {
        DistanceTransform.measure(width, height, cell -> room[cell] != FAR, (row, squares) -> {
            for (int column = 0; column < width; column++) {
                double cells = Math.sqrt(squares[column]);
                if (cells > 0) {
                    room[row * width + column] = (byte) Math.min(MOST, NEAR + (int) (cells * UNITS_PER_CELL));
                }
            }
        });
    }

    /// Whether a place is on the map and not in a wall.
    public boolean isFree(double x, double y) {
        return roomAt(x, y) != SOLID;
    }

    /// A distance [m] within which nothing is solid around a place; less than the true one by up to two cells.
    /// Negative in walls and outside the map.
    double emptyAround(double x, double y) {
        int at = roomAt(x, y);
        return at == SOLID ? -resolution : empty(at) * resolution;
    }

    /// [cells]
    private static double empty(int room) {
        return (room - NEAR) / UNITS_PER_CELL;
    }

    private int roomAt(double x, double y) {
        double column = (x - left) * cellsPerMeter;
        double row = (y - bottom) * cellsPerMeter;
        boolean inside = column >= 0 && column < width && row >= 0 && row < height; // false for NaN
        return inside ? roomIn((int) column, (int) row) : SOLID;
    }

    private int roomIn(int column, int row) {
        return room[row * width + column] & 0xFF;
    }

    /// Ends rays at the border of the first occupied cell, if that is within reach and they have met nothing
    /// before; at once inside a wall. Rays from outside the map meet nothing.
    ///
    /// Each strides across the empty circle around where it is (Hart, Sphere Tracing, 1996) until walls are near,
    /// then walks from cell to cell exactly (Amanatides and Woo, A Fast Voxel Traversal Algorithm, 1987). All take
    /// their strides in turns, so that while one waits for memory others go on.
    void end(Rays rays, double reach) {
        int under = begin(rays);
        while (under > 0) {
            int still = 0;
            for (int k = 0; k < under; k++) {
                int i = rays.under[k];
                double way = rays.way[i];
                int column = (int) (rays.column[i] + way * rays.dx[i]);
                int row = (int) (rays.row[i] + way * rays.dy[i]);
                int here = roomIn(column, row);
                double limit = Math.min(reach, rays.range[i]) * cellsPerMeter;
                way = here > NEAR ? way + empty(here) - GUARD : walk(rays, i, way, column, row, limit);
                if (way <= limit) {
                    rays.way[i] = way;
                    rays.under[still++] = i;
                }
            }
            under = still;
        }
    }

    private int begin(Rays rays) {
        int under = 0;
        for (int i = 0; i < rays.count; i++) {
            double column = (rays.x[i] - left) * cellsPerMeter;
            double row = (rays.y[i] - bottom) * cellsPerMeter;
            if (column >= 1 && column < width - 1 && row >= 1 && row < height - 1) { // false for NaN
                rays.column[i] = column;
                rays.row[i] = row;
                rays.way[i] = 0;
                rays.under[under++] = i;
            }
        }
        return under;
    }

    /// Goes from cell to cell while walls are near.
    ///
    /// @return how far it came [cells]; +∞ when it has met a wall, noting its range, or the fence
    private double walk(Rays rays, int ray, double from, int fromColumn, int fromRow, double limit) {
        double dx = rays.dx[ray];
        double dy = rays.dy[ray];
        double perColumn = dx == 0 ? Double.POSITIVE_INFINITY : 1 / dx;
        double perRow = dy == 0 ? Double.POSITIVE_INFINITY : 1 / dy;
        int stepColumn = dx >= 0 ? 1 : -1;
        int stepRow = dy >= 0 ? 1 : -1;
        double originColumn = rays.column[ray] - (dx >= 0 ? 1 : 0); // so that a cell is left at its own number
        double originRow = rays.row[ray] - (dy >= 0 ? 1 : 0);
        double way = from;
        int column = fromColumn;
        int row = fromRow;
        int here = roomIn(column, row);
        while (here == NEAR && way <= limit) {
            double toColumn = (column - originColumn) * perColumn;
            double toRow = (row - originRow) * perRow;
            if (toColumn < toRow) {
                way = toColumn;
                column += stepColumn;
            } else {
                way = toRow;
                row += stepRow;
            }
            here = roomIn(column, row);
        }
        if (here > NEAR) {
            return way + GUARD; // so that rounding does not put it back
        }
        boolean atFence = column == 0 || column == width - 1 || row == 0 || row == height - 1;
        if (here == SOLID && way <= limit && !atFence) {
            rays.range[ray] = way * resolution;
        }
        return Double.POSITIVE_INFINITY;
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
            int stride;
            for (int column = firstColumn; column <= lastColumn; column += stride) {
                int here = roomIn(column, row);
                stride = 1 + (int) empty(Math.max(here, NEAR));
                if (here == SOLID) {
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

    double left() {
        return left;
    }

    double bottom() {
        return bottom;
    }

    /// With the fence [m].
    double sizeX() {
        return width * resolution;
    }

    /// With the fence [m].
    double sizeY() {
        return height * resolution;
    }
}
